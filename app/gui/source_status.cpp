#include "app/gui/source_status.h"

#include "app/gui/workbench.h"
#include "widgets/style/number_text.h"

#include <QStorageInfo>

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
    });
    connect(&acquisition, &Acquisition::batch, this,
            [this](const std::shared_ptr<const SampleBlock> &samples) {
                m_samples += samples->size();
                if (samples->size() > 0)
                    m_lastS = samples->timeS[samples->size() - 1];
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

std::vector<StatusPart> SourceStatus::parts() const
{
    const Acquisition::State state = m_bench.acquisition().state();
    if (state == Acquisition::State::Idle)
        return {};
    QString source = m_bench.sourceName();
    if (state != Acquisition::State::Running)
        return {{source + tr(" · opening")}};
    if (m_rateHz > 0.0)
        source += tr(" · %1 Hz").arg(numberText(m_rateHz, m_rateHz < 1000.0 ? 1 : 0));
    if (m_dropped == 0)
        return {{source + tr(" · 0 dropped"), Tone::Plain, kYieldsLast}};
    const QString dropped = tr("%1 dropped of %2")
                                .arg(numberText(static_cast<double>(m_dropped), 0),
                                     numberText(static_cast<double>(m_dropped + m_samples), 0));
    return {{source}, {dropped, Tone::Caution}};
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
