// Four strips of the last minute of a source, x, y, z and T, with the newest value behind each: a look at
// what comes, not a record. What it keeps is the lowest and highest of each of a few hundred stretches of
// time, so a fast source costs no more than a slow one.
#pragma once

#include "engine/recording/sample_block.h"
#include "widgets/plot/plot_view.h"

#include <QTimer>

#include <array>
#include <deque>
#include <optional>

namespace driftbench {

class StripView : public PlotView
{
    Q_OBJECT

public:
    static constexpr double kShownS = 60.0;
    static constexpr int kStrips = 4;

    explicit StripView(const Palette &look, QWidget *parent = nullptr);

    void append(const SampleBlock &block);
    void clear();
    // Of the last value; nothing before the first sample.
    std::optional<double> latest(int strip) const;
    double measuredRateHz() const { return m_rateHz; }

    QSize figureSize() const override { return {296, 224}; }

protected:
    void build() override;

private:
    struct Stretch
    {
        std::int64_t number = 0; // of kStretchS each
        std::array<double, kStrips> low{}, high{};
    };

    void put(double timeS, const std::array<double, kStrips> &values);
    void measureRate(const SampleBlock &block);
    void drawStrip(QCPAxisRect &rect, int strip);

    std::deque<Stretch> m_stretches;
    std::array<double, kStrips> m_latest{};
    double m_latestS = 0.0;
    double m_firstS = 0.0;
    double m_rateHz = 0.0;
    double m_rateFromS = 0.0;
    std::int64_t m_rateCount = 0;
    QTimer m_repaint;
};

} // namespace driftbench
