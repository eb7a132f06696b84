// A gyro behind one of the bridges, what is recorded of it, and whether that is what it measured.
#pragma once

#include "device/gyros/gyro_i2c_source.h"
#include "support/bridges.h"
#include "support/gyro_model.h"
#include "support/thermometer_models.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace driftbench::test {

inline constexpr double kSensitivityDps = 0.00875;

// Which sample a row holds, as GyroModel::numbered made it.
inline std::int64_t numberOf(const Eigen::RowVector3d &rateDps, double sensitivityDps)
{
    const auto low = static_cast<std::int64_t>(std::llround(rateDps[0] / sensitivityDps));
    const auto high = static_cast<std::int64_t>(std::llround(rateDps[2] / sensitivityDps)) + 1;
    return std::llround(rateDps[1] / sensitivityDps) == -low ? high * 30011 + low : -1;
}

struct GyroRow
{
    double timeS;
    double temperatureC;
    Eigen::RowVector3d rateDps;
};

class GyroRecorder final : public SampleSink
{
public:
    explicit GyroRecorder(std::int64_t wanted) : m_wanted(wanted) {}

    std::vector<GyroRow> rows;
    std::vector<SampleGap> gaps;
    std::vector<std::string> events;
    std::function<void(std::int64_t)> onBlock; // with the number of rows so far

    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        m_consecutive = m_consecutive && block.firstSample == static_cast<std::int64_t>(rows.size());
        for (Eigen::Index i = 0; i < count; ++i)
            rows.push_back({block.timeS[i], block.temperatureC[i], block.rateDps.row(i)});
        if (onBlock)
            onBlock(static_cast<std::int64_t>(rows.size()));
        return static_cast<std::int64_t>(rows.size()) < m_wanted ? Flow::Continue : Flow::Stop;
    }
    void gap(const SampleGap &gap) override
    {
        gaps.push_back(gap);
        gapAt.push_back(rows.size());
    }
    void event(const std::string &sentence) override { events.push_back(sentence); }

    bool told(const char *part) const
    {
        return std::any_of(events.begin(), events.end(),
                           [&](const std::string &event) { return event.find(part) != std::string::npos; });
    }
    bool firstSamplesAreConsecutive() const { return m_consecutive; }
    std::vector<std::size_t> gapAt; // rows before each gap

private:
    std::int64_t m_wanted;
    bool m_consecutive = true;
};

struct GyroBench
{
    GyroBench(const QString &bridgeName, const QString &model, double rateFactor = 1.0)
        : bridge(makeBridge(bridgeName.toStdString()))
        , clock(&bridge->clock)
        , gyro(model.toStdString(), bridge->clock, rateFactor)
        , tmp117(bridge->clock)
    {
        bridge->wires.attach(model == "L3GD20H" ? 0x6B : 0x68, gyro);
    }

    std::unique_ptr<GyroI2cSource> open(const GyroI2cOptions &options = {})
    {
        Result<std::unique_ptr<GyroI2cSource>> source =
            GyroI2cSource::open(std::move(bridge->bus), options, *clock);
        return source ? std::move(*source) : nullptr;
    }

    std::unique_ptr<Bridge> bridge;
    SimulatedClock *clock;
    GyroModel gyro;
    Tmp117Model tmp117;
};

inline GyroI2cOptions atRate(double rateHz)
{
    GyroI2cOptions options;
    options.gyro.rateHz = rateHz;
    return options;
}

inline bool endsWith(const GyroRecorder &recorder, const Counts &counts)
{
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (recorder.rows.back().rateDps[axis] != counts[static_cast<std::size_t>(axis)] * kSensitivityDps)
            return false;
    }
    return true;
}

// Empty if all samples are there, those missing are gaps of the right size, and times go forward.
inline QString flaw(const GyroRecorder &recorder)
{
    if (!recorder.firstSamplesAreConsecutive())
        return "blocks do not follow each other";
    std::size_t gap = 0;
    for (std::size_t i = 0; i < recorder.rows.size(); ++i) {
        const std::int64_t number = numberOf(recorder.rows[i].rateDps, kSensitivityDps);
        if (number < 0)
            return QString("row %1 is no sample").arg(i);
        const bool gapHere = gap < recorder.gapAt.size() && recorder.gapAt[gap] == i;
        const std::int64_t lost = gapHere ? recorder.gaps[gap].lostSamples : 0;
        if (i > 0) {
            const std::int64_t before = numberOf(recorder.rows[i - 1].rateDps, kSensitivityDps);
            if (number != before + 1 + lost)
                return QString("row %1: sample %2 after %3, %4 said to be lost")
                    .arg(i)
                    .arg(number)
                    .arg(before)
                    .arg(lost);
            if (recorder.rows[i].timeS <= recorder.rows[i - 1].timeS)
                return QString("row %1: time goes backwards").arg(i);
        }
        if (gapHere) {
            if (recorder.gaps[gap].startS != recorder.rows[i - 1].timeS ||
                recorder.gaps[gap].endS != recorder.rows[i].timeS)
                return QString("row %1: the gap is not between its neighbours").arg(i);
            ++gap;
        }
    }
    return gap == recorder.gaps.size() ? QString() : "a gap without samples after it";
}

// A row a bridge, in the column "name".
inline void addBridges()
{
    QTest::addColumn<QString>("name");
    for (const char *name : kBridgeNames)
        QTest::newRow(name) << QString(name);
}

} // namespace driftbench::test
