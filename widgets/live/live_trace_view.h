// The live traces of a run: raw and compensated rates of the three axes, the temperature against its plan,
// with two cursors that stay while samples stream in.
//
// Samples are appended as they come, whether the view is seen or not; it is repainted at most 25 times a
// second, and only while it is visible. Pausing freezes what is shown, nothing else: what is appended
// meanwhile is there on resuming. All times are seconds since the start of the run.
#pragma once

#include "engine/physics/temperature_profile.h"
#include "engine/recording/sample_block.h"
#include "widgets/live/live_marks.h"
#include "widgets/live/live_strips.h"
#include "widgets/live/trace_pyramid.h"
#include "widgets/plot/legend_painter.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/style/palette.h"

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

enum class LiveSpan
{
    Run, // all of it, as long as the plan says
    TenMinutes,
    OneMinute
};

enum class LiveQuantity
{
    Rate,
    Tde // rate less the reference rate
};

// Means over 10 s around a cursor; NaN for a trace that has none there.
struct CursorReading
{
    double timeS = 0.0;
    std::array<double, TracePyramid::kTraces> means{};
};

class LiveTraceView : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kShortestRepaintMs = 40;
    static constexpr double kCursorMeanS = 10.0;

    explicit LiveTraceView(const Palette &look = lightPalette(), QWidget *parent = nullptr);
    ~LiveTraceView() override;

    void setLook(const Palette &look);
    void retranslate();

    void clear(); // for a new run; reference, plan and choices of the view stay
    void setReference(const std::optional<Eigen::Vector3d> &rateDps);
    void setPlan(const std::optional<TemperatureProfile> &profile);
    void setCompensated(bool on);    // a model is applied: there is a second trace
    void setFinished(bool finished); // nothing more will come: no "now", nothing pending

    // Rows of the block are samples of the run; compensatedDps: N x 3, or no rows.
    void append(const SampleBlock &block, const Eigen::MatrixX3d &compensatedDps = {});
    void addGap(const LiveGap &gap);
    void addEvent(double timeS, const QString &sentence);
    void setHolds(std::vector<LiveHold> holds);

    void setSpan(LiveSpan span);
    LiveSpan span() const { return m_span; }
    void setQuantity(LiveQuantity quantity);
    LiveQuantity quantity() const { return m_quantity; }
    void setPaused(bool paused);
    bool isPaused() const { return m_pausedAtS.has_value(); }
    double pausedAtS() const { return m_pausedAtS.value_or(0.0); }
    std::int64_t samplesSincePause() const;

    bool isEmpty() const { return m_traces->empty(); }
    const TracePyramid &traces() const { return *m_traces; }
    PlotInteraction &interaction() const { return *m_interaction; }
    PlotCursors &cursors() const { return *m_interaction->cursors(); }
    const LiveMarks &marks() const { return *m_marks; }
    std::optional<CursorReading> reading(Cursor cursor) const;
    std::vector<LegendEntry> legend() const;
    PlotTable table() const;
    QCustomPlot &plot() const { return *m_plot; }
    bool isFollowing() const { return m_following; }

    QSize sizeHint() const override { return {768, 562}; }

public slots:
    void refresh(); // at once, if it is dirty or not

signals:
    void cursorsChanged();
    void legendChanged();
    void refreshed();

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeDirty();
    void rebuild();
    double nowS() const; // of what is shown
    void follow();
    void fitValues(const TracePyramid::Envelopes &data);
    void showPlanPart();
    TracePyramid::Envelopes visible() const;
    Eigen::Vector3d shiftDps() const;
    QStringList valueTitles() const;
    QString hoverText(const QPointF &place) const;

    Palette m_look;
    QCustomPlot *m_plot;
    std::unique_ptr<TracePyramid> m_traces;
    std::unique_ptr<LiveStrips> m_strips;
    std::unique_ptr<LiveMarks> m_marks;
    PlotInteraction *m_interaction;
    std::optional<Eigen::Vector3d> m_referenceDps;
    std::optional<TemperatureProfile> m_plan;
    LiveSpan m_span = LiveSpan::Run;
    LiveQuantity m_quantity = LiveQuantity::Rate;
    bool m_compensated = false;
    bool m_finished = false;
    bool m_following = true;  // time moves with the samples
    bool m_fitsValues = true; // ranges follow the data
    std::optional<double> m_pausedAtS;
    std::int64_t m_samplesAtPause = 0;
    std::optional<std::array<ValueRange, 3>> m_ranges;
    QTimer m_repaint;
    QElapsedTimer m_sinceRepaint;
    bool m_dirty = true;
};

} // namespace driftbench
