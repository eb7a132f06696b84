// The services of the window: the session that is open and the work on it. Pages read from it, ask it for
// work, and connect to its signals; they never keep the session, which is another one after File, Open.
//
//   session    one is always open; after openSession() all its stages are told as changed
//   source     what is chosen on the Source page, and the one Acquisition that watches or records it
//   jobs       one each: reading logs, preparing and training, talking to the device's tables
//   devices    what is plugged in, looked for on a thread of its own
//
// Everything here lives in the GUI's thread.
#pragma once

#include "app/session/acquisition.h"
#include "app/session/load_job.h"
#include "app/session/session.h"
#include "app/session/settings.h"
#include "app/session/training_job.h"
#include "app/session/upload_job.h"
#include "device/discovery/device_watch.h"
#include "device/simulated_board.h"
#include "device/source_choice.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>

namespace driftbench {

// What a source is opened for. A simulated bridge holds its first temperature while it is watched, in real
// time, and plays the test plan at the chosen speed while a run is recorded; each recorded run is another of
// its campaign.
enum class SourceUse
{
    Watch,
    Record
};

struct WorkbenchOptions
{
    std::filesystem::path sessionFolder; // for sessions without a name, and the simulated bridge's flash
    HidAccess devices = hidDevicesOfThisComputer();
    bool watchDevices = true;
};

class Workbench : public QObject
{
    Q_OBJECT

public:
    // A new, unnamed session. Errors: those of Session::createUnnamed.
    static Result<std::unique_ptr<Workbench>> create(WorkbenchOptions options, const Settings &settings = {});
    ~Workbench() override;

    // Session. The one that was open is closed first; on an error it stays.
    Session &session() const { return *m_session; }
    Status newSession();
    Status openSession(const std::filesystem::path &file);
    Status saveSessionAs(const std::filesystem::path &file);

    const Settings &settings() const { return m_settings; }
    void changeSettings(const std::function<void(Settings &)> &change);

    // Source
    // What is looked at; it becomes the session's source when it is used.
    const std::optional<SourceChoice> &sourceChoice() const { return m_choice; }
    void setSourceChoice(const SourceChoice &choice); // stops what was watched
    Status useSource();
    bool isSourceSimulated() const; // the choice, not the runs
    bool isSourcePluggedIn() const; // a bridge, neither simulated nor a log that is played back
    QString sourceName() const;     // "Simulated bridge", "run1.csv"; empty: none chosen
    Acquisition &acquisition() { return m_acquisition; }
    // Opens the choice and lets it run; what runs is stopped first. False: no choice, or a run is recorded.
    bool startSource(SourceUse use);
    void stopSource();
    SourceUse sourceUse() const { return m_use; } // of the last start
    // Of the running simulated bridge, for injecting faults; null: another source, or none runs.
    std::shared_ptr<SimulatedBoard> simulatedBoard() const { return m_board.lock(); }

    // Devices
    const DeviceList &devices() const { return m_devices; }
    void lookAgain();
    // The native bridge that the choice means, for tables (upload_job.h); InvalidOption: it has none.
    OpenClient clientOpener() const;

    // Jobs
    LoadJob &loading() { return m_loading; }
    TrainingJob &training() { return m_training; }
    UploadJob &upload() { return m_upload; }
    // Logs as runs of the session.
    Status importLogs(const std::vector<std::filesystem::path> &files, const LoadInput &how = {});
    // The runs checked and made features, if that is not done yet; preparedChanged follows.
    Status prepare();
    Status train(); // prepares as well; resultChanged follows

signals:
    void sessionReplaced(); // before the signals of its stages
    // Those of the session, whichever is open.
    void nameChanged();
    void testPlanChanged();
    void runsChanged();
    void planChanged();
    void preparedChanged();
    void resultChanged();
    void exportChoiceChanged();
    void exportsChanged();
    void uploadsChanged();
    void notesChanged();
    void eventAdded(const driftbench::SessionEvent &event);
    void savedChanged(); // saving failed, or works again

    void settingsChanged();
    void sourceChanged(); // the choice, or the session's
    void devicesChanged();
    void problem(const driftbench::Error &error); // of a job or of saving, for the event log

private:
    Workbench(WorkbenchOptions options, Settings settings, std::unique_ptr<Session> session);
    void take(std::unique_ptr<Session> session);
    void connectSession();
    void connectJobs();
    void tellUnlessCancelled(const Error &error);
    void startWatch();
    SourceChoice choiceFor(SourceUse use) const;
    bool openNow();
    void rememberSession();
    Status startTraining(bool train);

    WorkbenchOptions m_options;
    Settings m_settings;
    std::unique_ptr<Session> m_session;
    std::optional<SourceChoice> m_choice;
    SourceUse m_use = SourceUse::Watch;
    bool m_startPending = false; // as soon as the acquisition is idle
    std::weak_ptr<SimulatedBoard> m_board;
    DeviceList m_devices;
    const Session *m_trainedFor = nullptr; // null: nothing that is to be taken
    Acquisition m_acquisition;
    LoadJob m_loading;
    TrainingJob m_training;
    UploadJob m_upload;
    OwnerMailbox m_mailbox;
    std::unique_ptr<DeviceWatch> m_watch; // its thread posts to the mailbox
};

} // namespace driftbench
