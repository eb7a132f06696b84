// A calibration in work: one value a stage, kept in its session file while it changes.
//
//   source choice · test plan      what is to be measured
//   runs                           what was measured
//   calibration plan               which of it counts, and how it is trained and judged
//   prepared campaign              the runs checked and made features, or why not
//   result                         models and their comparison
//   export choice                  which model goes where
//   exports, uploads               what was written
//
// Each stage has one signal. A stage that is computed is dropped when what it was computed from changes: runs
// and calibration plan drop the prepared campaign and the result, the prepared campaign drops the result.
// What was measured, written or uploaded is a fact and stays. Values change first, then the signals come, in
// the order above, one a stage that changed.
//
// There is nothing to save: every change is in the file when its function returns. Where it can't be written
// (a full disk), the value stays, savingFailed says so, and it is written with the next change that can be,
// or by saveAgain(). A session that another program writes to is read-only: its setters return
// SessionReadOnly.
//
// A new session lies in a file without a name of its own in a folder of the program, until saveAs names it;
// it is there after a crash (unnamedSessions).
#pragma once

#include "app/session/calibration_plan.h"
#include "app/session/export_choice.h"
#include "app/session/plan_history.h"
#include "app/session/prepared_campaign.h"
#include "app/session/session_event.h"
#include "app/session/session_file.h"
#include "app/session/training_job.h"
#include "device/source_choice.h"
#include "engine/base/result.h"
#include "engine/physics/test_plan.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace driftbench {

class Session final : public QObject
{
    Q_OBJECT

public:
    static Result<std::unique_ptr<Session>> create(const std::filesystem::path &file);
    static Result<std::unique_ptr<Session>> createUnnamed(const std::filesystem::path &folder);
    static Result<std::unique_ptr<Session>> open(const std::filesystem::path &file,
                                                 SessionAccess access = SessionAccess::ReadWrite);
    // Sessions in that folder that were never named and have runs, the newest first.
    static std::vector<std::filesystem::path> unnamedSessions(const std::filesystem::path &folder);

    ~Session() override;

    const std::filesystem::path &path() const { return m_file.path(); }
    QString name() const; // "five-runs", or "unnamed"
    bool isUnnamed() const { return m_unnamed; }
    bool isReadOnly() const { return m_file.readOnly(); }
    QString readOnlyReason() const { return QString::fromStdString(m_file.readOnlyReason()); }
    const std::vector<RunId> &recoveredRuns() const { return m_file.recovered(); }
    const SessionFile &file() const { return m_file; } // for recorders and copies
    // The file for another thread.
    Result<std::shared_ptr<SessionFile>> anotherFile() const;

    // Gives an unnamed session its place; a named one is copied there and goes on there. Not while it is
    // being recorded into. A copy that the user keeps beside it: SessionFile::saveCopy in a TaskJob.
    Status saveAs(const std::filesystem::path &file);

    // Source
    const std::optional<SourceChoice> &source() const { return m_source; }
    Status setSource(const SourceChoice &choice);

    // Test plan
    const std::optional<TestPlan> &testPlan() const { return m_testPlan; }
    Status setTestPlan(const TestPlan &plan);

    // Runs
    const std::vector<RunRecord> &runs() const { return m_runs; }
    const RunRecord *run(RunId id) const; // null: there is none
    SensorIdentity sensor() const { return m_sensor; }
    bool isSimulated() const; // any of the runs
    // As it is calibrated (LoadedRun), from memory if someone still has it; a long run takes its time.
    Result<std::shared_ptr<const Recording>> recording(RunId id);
    Status renameRun(RunId id, const QString &name);
    Status removeRun(RunId id);
    Status refreshRuns(); // after something else wrote to the file: a recorder, an import

    // Calibration plan. text: of the step, for undo: "exclude 12 s of run 2".
    const CalibrationPlan &plan() const { return m_history.plan(); }
    Status editPlan(CalibrationPlan plan, const QString &text);
    Status undo();
    Status redo();
    const PlanHistory &history() const { return m_history; }

    // Computed stages, as jobs deliver them. What was made by another plan than that of now is not taken, and
    // a result only while the campaign that it was made from is there (InvalidOption).
    const std::shared_ptr<const PreparedCampaign> &prepared() const { return m_prepared; }
    bool setPrepared(const std::shared_ptr<const PreparedCampaign> &prepared);
    const std::shared_ptr<const CalibrationResult> &result() const { return m_result; }
    Status setResult(const std::shared_ptr<const CalibrationResult> &result);
    // What a TrainingJob needs for the plan of now.
    Result<TrainingInput> trainingInput(bool train = true) const;

    // The last evaluation of a saved model on these runs, as JSON; empty: none.
    const std::string &evaluation() const { return m_evaluation; }
    Status setEvaluation(const std::string &json);

    // Export
    const ExportChoice &exportChoice() const { return m_choice; }
    Status setExportChoice(const ExportChoice &choice);
    const TrainedModel *chosenModel() const;                       // null: there is none of that name
    std::optional<ModelId> modelId(const std::string &name) const; // of the result's models in the file
    const std::vector<ExportRecord> &exports() const { return m_exports; }
    Status addExport(ExportRecord made);
    const std::vector<UploadRecord> &uploads() const { return m_uploads; }
    Status addUpload(UploadRecord made);

    // Log
    const std::vector<SessionEvent> &events() const { return m_events; } // the oldest first
    Status addEvent(SessionEvent event);
    const std::vector<NoteRecord> &notes() const { return m_notes; }
    Status addNote(const QString &text, std::optional<RunId> run = std::nullopt);

    bool isSaved() const { return m_unsaved.empty(); }
    Status saveAgain();

signals:
    void nameChanged();
    void sourceChanged();
    void testPlanChanged();
    void runsChanged();
    void planChanged(); // also where undo and redo texts changed
    void preparedChanged();
    void resultChanged();
    void evaluationChanged();
    void exportChoiceChanged();
    void exportsChanged();
    void uploadsChanged();
    void notesChanged();
    void eventAdded(const driftbench::SessionEvent &event);
    void savingFailed(const QString &sentence);
    void savedAgain();

private:
    enum class Part
    {
        Source,
        TestPlan,
        Plan,
        Result,
        Choice,
    };

    explicit Session(SessionFile file);
    static Result<std::unique_ptr<Session>> around(SessionFile file);
    Status load();
    Status loadSource();
    Status loadPlan();
    Status loadChoice();
    Status loadResult();
    Status mayChange() const;
    Status readRuns();
    // Drops what is computed, saves, tells.
    Status inputsChanged(bool runs, bool plan);
    Status planEdited(const CalibrationPlan &before);
    Status save(Part part);
    Status write(Part part);
    Status writePlan();
    Status writeResult();

    SessionFile m_file;
    bool m_unnamed = false;
    std::set<Part> m_unsaved;

    std::optional<SourceChoice> m_source;
    std::optional<TestPlan> m_testPlan;
    std::vector<RunRecord> m_runs;
    SensorIdentity m_sensor;
    std::map<RunId, std::weak_ptr<const Recording>> m_recordings;
    PlanHistory m_history;
    CalibrationPlan m_writtenPlan; // exclusions and rates as they are in the file
    std::shared_ptr<const PreparedCampaign> m_prepared;
    std::shared_ptr<const CalibrationResult> m_result;
    std::map<std::string, ModelId> m_modelIds;
    std::string m_evaluation;
    ExportChoice m_choice;
    std::vector<ExportRecord> m_exports;
    std::vector<UploadRecord> m_uploads;
    std::vector<SessionEvent> m_events;
    std::vector<NoteRecord> m_notes;
};

} // namespace driftbench
