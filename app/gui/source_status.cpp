#include "app/gui/source_status.h"

#include "app/gui/workbench.h"
#include "widgets/style/number_text.h"

#include <QStorageInfo>

#include <cmath>
#include <utility>

namespace driftbench {

static constexpr int kReadOutMs = 250;
static constexpr int kRoomMs = 5000;
static constexpr double kRateOverS = 2.0;
// While nothing is wrong with them.
static constexpr int kYieldsFirst = 2;
static constexpr int kYieldsLast = 1;
static constexpr double kGiga = 1e9;
static constexpr double kLittleRoomBytes = 1e9;

SourceStatus::SourceStatus(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    Acquisition &acquisition = bench.acquisition();
    connect(&acquisition, &Acquisition::started, this, [this] {
        m_samples = m_dropped = m_measuredSamples = 0;
        m_rateHz = m_lastS = m_measuredS = 0.0;
        m_silence.start();
        m_away = false;
    });
    connect(&acquisition, &Acquisition::batch, this,
            [this](const std::shared_ptr<const SampleBlock> &samples) {
                m_samples += samples->size();
                if (samples->size() == 0)
                    return;
                m_lastS = samples->timeS[samples->size() - 1];
                m_silence.came(std::exchange(m_away, false));
            });
    connect(&acquisition, &Acquisition::sourceSaid, this, [this](const QString &sentence) {
        m_away = m_away || sentence.contains(QLatin1String("was unplugged"));
    });
    connect(&acquisition, &Acquisition::gap, this,
            [this](const SampleGap &gap) { m_dropped += std::max<std::int64_t>(0, gap.lostSamples); });
    connect(&acquisition, &Acquisition::stateChanged, this, &SourceStatus::changed);
    connect(&m_timer, &QTimer::timeout, this, &SourceStatus::measure);
    m_timer.start(kReadOutMs);
}

void SourceStatus::measure()
{
    if (!m_sinceRoom.isValid() || m_sinceRoom.elapsed() > kRoomMs) {
        m_sinceRoom.start();
        const QString folder = QString::fromStdString(m_bench.session().path().parent_path().string());
        m_freeBytes = QStorageInfo(folder).bytesAvailable();
    }
    const double spanS = m_lastS - m_measuredS;
    if (spanS > kRateOverS || (m_rateHz == 0.0 && spanS > 0.5)) {
        m_rateHz = static_cast<double>(m_samples - m_measuredSamples) / spanS;
        m_measuredS = m_lastS;
        m_measuredSamples = m_samples;
    }
    emit changed();
}

std::optional<double> SourceStatus::silentForS() const
{
    return m_away ? std::optional(m_silence.sinceS()) : m_silence.overdueForS();
}

std::vector<StatusPart> SourceStatus::parts() const
{
    const Acquisition::State state = m_bench.acquisition().state();
    if (state == Acquisition::State::Idle)
        return {};
    QString source = m_bench.sourceName();
    if (state != Acquisition::State::Running)
        return {{source + tr(" · opening")}};
    const std::optional<double> silentS = silentForS();
    if (silentS)
        source += tr(" · no samples for %1 s").arg(numberText(std::floor(*silentS), 0));
    else if (m_rateHz > 0.0)
        source += tr(" · %1 Hz").arg(samplingRateText(m_rateHz));
    const StatusPart good{source + tr(" · 0 dropped"), Tone::Plain, kYieldsLast};
    const StatusPart silent{source, Tone::Caution};
    if (m_dropped == 0)
        return {silentS ? silent : good};
    const QString dropped = tr("%1 dropped of %2")
                                .arg(numberText(static_cast<double>(m_dropped), 0),
                                     numberText(static_cast<double>(m_dropped + m_samples), 0));
    return {silentS ? silent : StatusPart{source}, {dropped, Tone::Caution}};
}

StatusPart SourceStatus::room() const
{
    if (m_freeBytes < 0)
        return {};
    const double bytes = static_cast<double>(m_freeBytes);
    const QString text = tr("%1 GB free").arg(numberText(bytes / kGiga, bytes < 10.0 * kGiga ? 1 : 0));
    return bytes < kLittleRoomBytes ? StatusPart{text, Tone::Caution}
                                    : StatusPart{text, Tone::Plain, kYieldsFirst};
}

} // namespace driftbench
