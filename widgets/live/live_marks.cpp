#include "widgets/live/live_marks.h"

#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"

#include <QCoreApplication>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kTriangleWidth = 7.0;
static constexpr double kTriangleHeight = 6.0;
static constexpr double kEventRadius = 2.5;
static constexpr double kCatch = 5.0;
static constexpr double kWideGap = 2.0; // px; narrower ones are a triangle only
static constexpr int kLabelGap = 3;

namespace {

QString markWords(const char *text, int count = -1)
{
    return QCoreApplication::translate("driftbench::LiveMarks", text, nullptr, count);
}

double pixelOf(const QCPAxisRect &panel, double timeS)
{
    return panel.axis(QCPAxis::atBottom)->coordToPixel(timeS);
}

} // namespace

// Below the grid: what is not recorded, and what was lost.
class LiveMarks::Below : public QCPLayerable
{
public:
    Below(QCustomPlot *plot, const LiveMarks *marks)
        : QCPLayerable(plot, QStringLiteral("pending")), m_marks(marks)
    {
    }

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(false); }

    void draw(QCPPainter *painter) override
    {
        for (const QCPAxisRect *panel : mParentPlot->axisRects()) {
            if (m_marks->showPending)
                fill(*painter, *panel, m_marks->nowS, panel->axis(QCPAxis::atBottom)->range().upper, 1.0);
            for (const LiveGap &gap : m_marks->gaps)
                fill(*painter, *panel, gap.startS, gap.endS, kWideGap);
        }
    }

private:
    void fill(QCPPainter &painter, const QCPAxisRect &panel, double fromS, double toS, double least) const
    {
        const QRectF inside = panel.rect();
        const double left = std::clamp(pixelOf(panel, fromS), inside.left(), inside.right());
        const double right = std::clamp(pixelOf(panel, toS), inside.left(), inside.right());
        if (right - left >= least)
            painter.fillRect(QRectF(left, inside.top(), right - left, inside.height()), m_marks->look.page);
    }

    const LiveMarks *m_marks;
};

class LiveMarks::Above : public QCPLayerable
{
public:
    Above(QCustomPlot *plot, const LiveMarks *marks)
        : QCPLayerable(plot, QStringLiteral("overlay")), m_marks(marks)
    {
    }

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(true); }

    void draw(QCPPainter *painter) override
    {
        const auto panels = mParentPlot->axisRects();
        if (panels.isEmpty())
            return;
        drawNow(*painter, panels);
        drawDropped(*painter, *panels.front());
        drawEvents(*painter, *panels.front());
        drawLabels(*painter, *panels.back());
    }

private:
    void drawNow(QCPPainter &painter, const QList<QCPAxisRect *> &panels) const
    {
        const QCPAxis *keys = panels.front()->axis(QCPAxis::atBottom);
        if (!m_marks->showPending || !keys->range().contains(m_marks->nowS))
            return;
        painter.setAntialiasing(false);
        painter.setPen(QPen(m_marks->look.axisLine, 1.0));
        for (const QCPAxisRect *panel : panels) {
            const double x = std::floor(pixelOf(*panel, m_marks->nowS)) + 0.5;
            painter.drawLine(QLineF(x, panel->top(), x, panel->bottom()));
        }
    }

    void drawDropped(QCPPainter &painter, const QCPAxisRect &panel) const
    {
        painter.setAntialiasing(true);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_marks->look.caution);
        const double bottom = panel.top() - 1.0;
        double last = -kTriangleWidth;
        for (const LiveGap &gap : m_marks->gaps) {
            const double x = pixelOf(panel, gap.startS);
            if (x < panel.left() || x > panel.right() || x - last < 1.0)
                continue;
            last = x;
            painter.drawPolygon(QPolygonF{{x - kTriangleWidth / 2, bottom - kTriangleHeight},
                                          {x + kTriangleWidth / 2, bottom - kTriangleHeight},
                                          {x, bottom}});
        }
    }

    void drawEvents(QCPPainter &painter, const QCPAxisRect &panel) const
    {
        painter.setAntialiasing(true);
        painter.setPen(QPen(m_marks->look.mutedText, 1.0));
        painter.setBrush(Qt::NoBrush);
        for (const LiveEvent &event : m_marks->events) {
            const double x = pixelOf(panel, event.timeS);
            if (x >= panel.left() && x <= panel.right())
                painter.drawEllipse(QPointF(x, panel.top() - 1.5 - kEventRadius), kEventRadius, kEventRadius);
        }
    }

    void drawLabels(QCPPainter &painter, const QCPAxisRect &panel) const
    {
        painter.setFont(noteFont());
        painter.setPen(m_marks->look.mutedText);
        const QCPAxis *values = panel.axis(QCPAxis::atLeft);
        const QFontMetrics metrics{noteFont()};
        const QString name = markWords(QT_TRANSLATE_NOOP("driftbench::LiveMarks", "plateau"));
        for (const LiveHold &hold : m_marks->holds) {
            const double left = std::max<double>(pixelOf(panel, hold.startS), panel.left());
            const double right = std::min<double>(pixelOf(panel, hold.endS), panel.right());
            if (right - left < metrics.horizontalAdvance(name))
                continue;
            double y = values->coordToPixel(hold.temperatureC) - kLabelGap;
            if (y - metrics.height() < panel.top())
                y = values->coordToPixel(hold.temperatureC) + kLabelGap + metrics.height();
            painter.drawText(QRectF(left, y - metrics.height(), right - left, metrics.height()),
                             Qt::AlignCenter, name);
        }
        if (m_marks->planLabelS) {
            const double right = std::min<double>(pixelOf(panel, *m_marks->planLabelS), panel.right()) - 8.0;
            const double y = values->coordToPixel(m_marks->planLabelC) + kLabelGap;
            painter.drawText(QRectF(right - 80.0, y, 80.0, metrics.height()), Qt::AlignRight | Qt::AlignTop,
                             markWords(QT_TRANSLATE_NOOP("driftbench::LiveMarks", "plan")));
        }
    }

    const LiveMarks *m_marks;
};

LiveMarks::LiveMarks(QCustomPlot *plot, const Palette &palette) : look(palette), m_plot(plot)
{
    plot->addLayer(QStringLiteral("pending"), plot->layer(QStringLiteral("background")),
                   QCustomPlot::limAbove);
    new Below(plot, this); // the plot's
    new Above(plot, this);
}

void LiveMarks::addGap(const LiveGap &gap)
{
    if (gaps.size() >= kMostMarks) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < gaps.size(); i += 2, ++kept) {
            gaps[kept] = gaps[i];
            if (i + 1 == gaps.size())
                continue;
            // What lies between the two was recorded: the wide one stays where it is.
            const LiveGap &other = gaps[i + 1];
            const bool otherIsWider = other.endS - other.startS > gaps[i].endS - gaps[i].startS;
            const std::int64_t lost = gaps[i].lostSamples < 0 || other.lostSamples < 0
                                          ? -1
                                          : gaps[i].lostSamples + other.lostSamples;
            if (otherIsWider)
                gaps[kept] = other;
            gaps[kept].lostSamples = lost;
        }
        gaps.resize(kept);
    }
    gaps.push_back(gap);
}

void LiveMarks::addEvent(const LiveEvent &event)
{
    if (events.size() >= kMostMarks)
        events.erase(events.begin(), events.begin() + kMostMarks / 2);
    events.push_back(event);
}

QString LiveMarks::textAt(const QPointF &place) const
{
    const auto panels = m_plot->axisRects();
    if (panels.isEmpty())
        return {};
    const QCPAxisRect &panel = *panels.front();
    if (place.y() > panel.top() || place.y() < panel.top() - 2 * kTriangleHeight)
        return {};
    QStringList lines;
    for (const LiveGap &gap : gaps) {
        if (std::abs(pixelOf(panel, gap.startS) - place.x()) > kCatch)
            continue;
        const QString where = clockText(gap.startS);
        lines.append(
            gap.lostSamples < 0
                ? markWords(QT_TRANSLATE_NOOP("driftbench::LiveMarks", "%1: samples missing, %2"))
                      .arg(where, gap.cause)
                : markWords(QT_TRANSLATE_N_NOOP("driftbench::LiveMarks", "%1: %n samples dropped, %2"),
                            static_cast<int>(gap.lostSamples))
                      .arg(where, gap.cause));
    }
    for (const LiveEvent &event : events) {
        if (std::abs(pixelOf(panel, event.timeS) - place.x()) <= kCatch)
            lines.append(clockText(event.timeS) + QStringLiteral(": ") + event.sentence);
    }
    constexpr qsizetype kMostLines = 8;
    if (lines.size() > kMostLines)
        lines = lines.mid(0, kMostLines) + QStringList{QStringLiteral("…")};
    return lines.join(QLatin1Char('\n'));
}

} // namespace driftbench
