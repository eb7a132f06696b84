#include "widgets/plot/plot_cursors.h"

#include "widgets/style/fonts.h"

#include <QPointer>
#include <qcustomplot.h>

#include <cmath>

namespace driftbench {

static constexpr double kCatch = 4.0;
static constexpr double kTagRadius = 2.0;

// Not an item of the plot: those go whenever a view is built anew.
class PlotCursors::Overlay : public QCPLayerable
{
public:
    Overlay(QCustomPlot *plot, const PlotCursors *cursors)
        : QCPLayerable(plot, QStringLiteral("cursors")), m_cursors(cursors)
    {
    }

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(false); }

    void draw(QCPPainter *painter) override
    {
        if (!m_cursors)
            return;
        for (const Cursor cursor : {Cursor::A, Cursor::B}) {
            if (const auto pixel = m_cursors->pixelOf(cursor)) {
                drawLine(*painter, cursor, *pixel);
                drawTag(*painter, cursor, *pixel);
            }
        }
    }

private:
    void drawLine(QCPPainter &painter, Cursor cursor, double pixel) const
    {
        QPen pen(m_cursors->m_look.text, 1.0);
        if (cursor == Cursor::B) {
            pen.setDashPattern({3, 3});
            pen.setCapStyle(Qt::FlatCap);
        }
        painter.setAntialiasing(false);
        painter.setPen(pen);
        const auto panels = mParentPlot->axisRects();
        const double x = std::floor(pixel) + 0.5;
        painter.drawLine(QLineF(x, panels.front()->top(), x, panels.back()->bottom()));
    }

    void drawTag(QCPPainter &painter, Cursor cursor, double pixel) const
    {
        const QRectF tag = m_cursors->tagOf(pixel);
        painter.setAntialiasing(true);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_cursors->m_look.text);
        painter.drawRoundedRect(tag, kTagRadius, kTagRadius);
        painter.setPen(m_cursors->m_look.base);
        painter.setFont(strongNoteFont());
        painter.drawText(tag, Qt::AlignCenter | Qt::TextDontClip,
                         cursor == Cursor::A ? QStringLiteral("A") : QStringLiteral("B"));
    }

    QPointer<const PlotCursors> m_cursors;
};

PlotCursors::PlotCursors(QCustomPlot *plot, const Palette &look) : QObject(plot), m_plot(plot), m_look(look)
{
    plot->addLayer(QStringLiteral("cursors"), nullptr, QCustomPlot::limAbove);
    plot->layer(QStringLiteral("cursors"))->setMode(QCPLayer::lmBuffered);
    m_overlay = new Overlay(plot, this);
}

PlotCursors::~PlotCursors() = default;

void PlotCursors::setLook(const Palette &look)
{
    m_look = look;
}

void PlotCursors::place(Cursor cursor, double key)
{
    if (!std::isfinite(key) || m_keys[index(cursor)] == key)
        return;
    m_keys[index(cursor)] = key;
    redraw();
    emit changed();
}

void PlotCursors::remove(Cursor cursor)
{
    if (!m_keys[index(cursor)])
        return;
    m_keys[index(cursor)].reset();
    redraw();
    emit changed();
}

void PlotCursors::clear()
{
    remove(Cursor::A);
    remove(Cursor::B);
}

void PlotCursors::redraw()
{
    m_plot->layer(QStringLiteral("cursors"))->replot();
}

std::optional<double> PlotCursors::pixelOf(Cursor cursor) const
{
    const auto panels = m_plot->axisRects();
    const auto key = m_keys[index(cursor)];
    if (!key || panels.isEmpty())
        return std::nullopt;
    const QCPAxis *axis = panels.front()->axis(QCPAxis::atBottom);
    if (!axis->range().contains(*key))
        return std::nullopt;
    return axis->coordToPixel(*key);
}

QRectF PlotCursors::tagOf(double pixel) const
{
    const double top = m_plot->axisRects().front()->top() - kTagSize;
    return {std::floor(pixel) - kTagSize / 2.0 + 0.5, top, double(kTagSize), double(kTagSize)};
}

std::optional<Cursor> PlotCursors::at(const QPointF &place) const
{
    const auto panels = m_plot->axisRects();
    for (const Cursor cursor : {Cursor::B, Cursor::A}) { // the one on top first
        const auto pixel = pixelOf(cursor);
        if (!pixel)
            continue;
        if (tagOf(*pixel).contains(place))
            return cursor;
        if (std::abs(place.x() - *pixel) <= kCatch && place.y() >= panels.front()->top() &&
            place.y() <= panels.back()->bottom())
            return cursor;
    }
    return std::nullopt;
}

} // namespace driftbench
