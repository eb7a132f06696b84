// The part of Workbench that sees to the source: its choice, running it, and what is plugged in.
#include "app/gui/workbench.h"

#include "app/session/session_source.h"

#include <utility>

namespace driftbench {

static constexpr double kWatchedHoldS = 86400.0; // longer than anyone watches

void Workbench::setSourceChoice(const SourceChoice &choice)
{
    if (m_acquisition.isRecording())
        return;
    stopSource();
    m_choice = choice;
    emit sourceChanged();
}

Status Workbench::useSource()
{
    if (!m_choice)
        return Error{Errc::InvalidOption, "No source is chosen; choose a bridge or a log."};
    changeSettings([this](Settings &settings) {
        settings.lastSource = QString::fromStdString(sourceChoiceText(*m_choice));
    });
    return m_session->setSource(*m_choice);
}

bool Workbench::isSourceSimulated() const
{
    return m_choice && m_choice->as<SimulatedChoice>();
}

bool Workbench::isSourcePluggedIn() const
{
    return m_choice && !m_choice->as<SimulatedChoice>() && !m_choice->as<FileChoice>();
}

QString Workbench::sourceName() const
{
    if (!m_choice)
        return {};
    if (m_choice->as<SimulatedChoice>())
        return tr("Simulated bridge");
    if (m_choice->as<NativeChoice>())
        return tr("Gyro bridge");
    if (const auto *i2c = m_choice->as<I2cChoice>())
        return QString::fromUtf8(describe(i2c->chip).name.data());
    return QString::fromStdString(m_choice->as<FileChoice>()->path.filename().string());
}

SourceChoice Workbench::choiceFor(SourceUse use) const
{
    SourceChoice choice = *m_choice;
    auto *simulated = choice.as<SimulatedChoice>();
    if (!simulated)
        return choice;
    if (simulated->flashFile.empty())
        simulated->flashFile = m_options.sessionFolder / "simulated-bridge.flash";
    const auto &plan = m_session->testPlan();
    if (use == SourceUse::Watch) {
        const double startC = plan                 ? plan->lowestC
                              : simulated->profile ? simulated->profile->startC()
                                                   : -40.0;
        if (auto hold = TemperatureProfile::build("watch", startC, {HoldSegment{kWatchedHoldS}}))
            simulated->profile = *std::move(hold);
        simulated->speed = 1.0;
        return choice;
    }
    if (plan) {
        if (auto profile = plan->profile())
            simulated->profile = *std::move(profile);
    }
    simulated->run = static_cast<int>(m_session->runs().size());
    return choice;
}

bool Workbench::startSource(SourceUse use)
{
    if (!m_choice || m_acquisition.isRecording())
        return false;
    m_use = use;
    if (m_acquisition.state() == Acquisition::State::Idle)
        return openNow();
    m_startPending = true;
    m_acquisition.stop();
    return true;
}

bool Workbench::openNow()
{
    const auto tell = [this, sender = m_mailbox.sender()](const OpenedSource &opened) {
        sender.post([this, board = std::weak_ptr(opened.board), identity = opened.identity] {
            m_board = board;
            if (m_watch && !identity.path.empty())
                m_watch->setInUse({identity});
        });
    };
    return m_acquisition.start(sourceOpener(choiceFor(m_use), m_options.devices, tell));
}

void Workbench::stopSource()
{
    m_startPending = false;
    m_acquisition.stop();
}

void Workbench::startWatch()
{
    const auto sender = m_mailbox.sender();
    std::vector<UsbId> ids;
    for (const QString &text : m_settings.bridgeIds) {
        if (const auto id = parseUsbId(text.toStdString()))
            ids.push_back(*id);
    }
    const auto scanner = std::make_shared<DeviceScanner>(m_options.devices, ids);
    m_watch = std::make_unique<DeviceWatch>(
        [scanner](const ScanRequest &request) { return scanner->scan(request); },
        [this, sender](const DeviceList &list) {
            sender.post([this, list] {
                m_devices = list;
                emit devicesChanged();
            });
        });
}

void Workbench::lookAgain()
{
    if (m_watch)
        m_watch->lookAgain();
}

OpenClient Workbench::clientOpener() const
{
    if (!m_choice)
        return [] {
            return Result<std::shared_ptr<BridgeClient>>(
                Error{Errc::DeviceNotFound, "No bridge is chosen; choose one on the Source page."});
        };
    return driftbench::clientOpener(choiceFor(SourceUse::Record), m_options.devices);
}

} // namespace driftbench
