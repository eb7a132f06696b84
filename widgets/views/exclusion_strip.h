// TDE of one axis over the time of a campaign, its runs one after the other, with the stretches that are
// taken out. Dragging selects a stretch; the grips of an excluded one, and its edges, move it; a click picks
// it. Keys are seconds of the strip; who owns the runs knows which of them a second is in.
#pragma once

#include "widgets/plot/plot_view.h"

#include <QVector>

#include <optional>
#include <vector>

class QCPAxisRect;

namespace driftbench {

struct StripDots
{
    QVector<double> timeS;
    QVector<double> valueDps;
};

struct StripRange
{
    double startS = 0.0;
    double endS = 0.0;
    bool own = false; // of the user: it may be moved and picked; the others are the checks'
};

struct StripData
{
    QString valueLabel; // "TDE, x (dps)"
    double spanS = 0.0;
    std::vector<double> runStartsS; // of the second run and on: a rule there
    StripDots heating, cooling, excluded, selected;
    std::vector<StripRange> ranges; // that are excluded
};

class ExclusionStrip : public PlotView
{
    Q_OBJECT

public:
    explicit ExclusionStrip(const Palette &look = lightPalette(), QWidget *parent = nullptr);
    ~ExclusionStrip() override;

    void setData(StripData shown);
    const StripData &shown() const { return m_shown; }
    void setSelection(const std::optional<StripRange> &selection);
    void setPicked(std::optional<std::size_t> range);
    std::optional<StripRange> selection() const { return m_selection; }

    double secondAt(double pixel) const;
    double pixelOf(double second) const;

    QSize figureSize() const override { return {504, 152}; }

signals:
    void selected(double startS, double endS); // while dragging
    void selectionEnded();
    void rangeMoved(std::size_t range, double startS, double endS); // when it is let go
    void rangePicked(std::size_t range);
    void pickedNothing();

protected:
    void build() override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    class Marks;
    struct Edge
    {
        std::size_t range = 0;
        bool start = true;
    };

    std::optional<Edge> edgeAt(const QPointF &place) const;
    std::optional<std::size_t> rangeAt(const QPointF &place) const;
    bool dragEdge(QEvent *event);
    void redrawMarks();

    StripData m_shown;
    double m_secondsPerUnit = 60.0;
    std::optional<StripRange> m_selection;
    std::optional<std::size_t> m_picked;
    std::optional<Edge> m_dragged;
};

} // namespace driftbench
