// The two cursors of a plot: A solid, B dashed, through all its panels, each with a tag on top. They stay
// where they are when the plot is built anew, and are drawn on a layer of their own, so that dragging one
// draws nothing else again. Positions are keys: what the axes below the panels show.
#pragma once

#include "widgets/style/palette.h"

#include <QObject>

#include <array>
#include <memory>
#include <optional>

class QCPLayerable;
class QCustomPlot;

namespace driftbench {

enum class Cursor
{
    A,
    B
};

class PlotCursors : public QObject
{
    Q_OBJECT

public:
    PlotCursors(QCustomPlot *plot, const Palette &look);
    ~PlotCursors() override;

    void setLook(const Palette &look);

    std::optional<double> key(Cursor cursor) const { return m_keys[index(cursor)]; }
    void place(Cursor cursor, double key); // kept within the shown keys' reach by the caller
    void remove(Cursor cursor);
    void clear();

    // The cursor whose line (4 px beside) or tag is at this place of the plot.
    std::optional<Cursor> at(const QPointF &place) const;

    void redraw(); // the layer alone

    static constexpr int kTagSize = 16;

signals:
    void changed();

private:
    class Overlay;

    static std::size_t index(Cursor cursor) { return cursor == Cursor::A ? 0 : 1; }
    std::optional<double> pixelOf(Cursor cursor) const; // nothing where it is not in view
    QRectF tagOf(double pixel) const;

    QCustomPlot *m_plot;
    Palette m_look;
    std::array<std::optional<double>, 2> m_keys;
    Overlay *m_overlay; // the plot's child
};

} // namespace driftbench
