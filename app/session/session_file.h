// A calibration in one file, name.driftbench: a SQLite database with the sensor, the plan, runs with their
// samples, what was masked, models, comparisons, exports, uploads, notes and a log of events.
// docs/session-format.md describes it for readers of other programs.
//
// Every change is on the disk when its function returns; there is nothing to save. Opening costs by the
// number of runs, samples are read on demand and come back bit for bit as they were given.
//
// One program writes. Another that opens the same file gets it read-only, and readOnlyReason() says why; the
// lock goes with its program, however that ends. A run that was being recorded when its program ended is
// found as Interrupted (also by who only reads, as long as nobody writes), and RunRecorder::resume goes on
// with it.
//
// A file of an older version is brought up to date when it is opened for writing, and read as it is
// otherwise; one of a newer version is refused without a byte being touched.
//
// Threads: each SessionFile is used by one thread at a time; another() gives another thread its own.
//
// Errors: FileNotFound, UnknownFormat (no session file), SessionTooNew, SessionDamaged, SessionReadOnly (a
// change to a file that was opened read-only), SessionInUse, NoSuchRun (also for models), InvalidOption, and
// those of database.h.
#pragma once

#include "app/session/session_records.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/models/trained_model.h"
#include "engine/physics/test_plan.h"
#include "engine/recording/mask.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

class Database;
class SessionLock;

inline constexpr std::string_view kSessionEnding = ".driftbench";
inline constexpr int kSessionFormatVersion = 2;

enum class SessionAccess
{
    ReadWrite, // read-only all the same where another program writes, or the system forbids it
    ReadOnly,
};

struct SessionOptions
{
    std::string vfs{};       // a registered SQLite VFS; empty: the system's
    std::string writtenBy{}; // program and version, noted when a file is created
};

struct ReadRunOptions
{
    bool skipDamaged = false;    // leave out what is damaged, with a warning each, instead of refusing
    std::int64_t mostPoints = 0; // a longer run as means (block_means.h); 0: every sample as it is
};

struct SampleRange
{
    std::int64_t first = 0;
    std::int64_t count = 0; // fewer where the run ends before
};

class SessionFile
{
public:
    // OutputNotWritable if the file exists or can't be made.
    static Result<SessionFile> create(const std::filesystem::path &path, const SessionOptions &options = {});
    static Result<SessionFile> open(const std::filesystem::path &path, SessionAccess access,
                                    const SessionOptions &options = {});

    SessionFile(SessionFile &&other) noexcept;
    SessionFile &operator=(SessionFile &&other) noexcept;
    ~SessionFile();

    // The same file for another thread; as long as one of them lives, this program is the one that writes.
    Result<SessionFile> another() const;

    const std::filesystem::path &path() const;
    bool readOnly() const { return !readOnlyReason().empty(); }
    const std::string &readOnlyReason() const; // a sentence; empty: it can be written
    int formatVersion() const;
    const std::vector<RunId> &recovered() const; // runs that this opening found interrupted

    // session_sensor: of the first run that names one, unless it was set.
    Result<SensorIdentity> sensor() const;
    Status setSensor(const SensorIdentity &sensor);

    // Runs, in the order in which they were begun (session_runs.cpp).
    Result<std::vector<RunRecord>> runs() const;
    Result<RunRecord> run(RunId id) const;
    // Begun anew each time; what an import that was cut off had written is gone at the next opening. The hook
    // may stop it (Cancelled).
    Result<RunId> importRun(const Recording &recording, RunDescription description,
                            const ProgressHook &hook = {});
    Status renameRun(RunId id, const std::string &name); // InvalidOption: another has that name
    Status setReferenceRate(RunId id, const Eigen::Vector3d &rateDps);
    Status removeRun(RunId id);

    // Samples (session_samples.cpp). Cancelled if the hook says Stop.
    Result<Recording> readRun(RunId id, const ReadRunOptions &options = {},
                              const ProgressHook &hook = {}) const;
    Result<Recording> readRange(RunId id, const SampleRange &range, const ReadRunOptions &options = {}) const;
    Result<RunOverview> overview(RunId id) const; // stored; from the samples in a file of version 1

    // About the samples (session_marks.cpp). Setting replaces what was there.
    Result<std::vector<RunGap>> gaps(RunId id) const;
    Result<std::vector<Exclusion>> exclusions(RunId id) const;
    Status setExclusions(RunId id, const std::vector<Exclusion> &exclusions);
    Result<std::optional<Mask>> mask(RunId id) const; // nothing if none was set; as long as the run
    Status setMask(RunId id, const Mask &mask);

    // The plan, and the state of the calibration as documents by name (session_documents.cpp).
    Result<std::optional<TestPlan>> plan() const; // PlanDamaged
    Status setPlan(const TestPlan &plan);
    Result<std::optional<std::string>> document(const std::string &name) const;
    Status setDocument(const std::string &name, const std::string &text);
    Status removeDocument(const std::string &name);

    // Results (session_results.cpp).
    Result<ModelId> addModel(const TrainedModel &model);
    Result<std::vector<ModelRecord>> models() const;
    Result<TrainedModel> model(ModelId id) const; // errors of modelFromJson
    Status removeModel(ModelId id);
    Result<std::int64_t> addComparison(const std::string &comparisonJson,
                                       const std::string &recommendationJson);
    Result<std::vector<ComparisonRecord>> comparisons() const;
    Status addExport(const ExportRecord &made);
    Result<std::vector<ExportRecord>> exports() const;
    Status addUpload(const UploadRecord &upload);
    Result<std::vector<UploadRecord>> uploads() const;

    // Notes and the log (session_log.cpp).
    Result<std::int64_t> addNote(const NoteRecord &note);
    Result<std::vector<NoteRecord>> notes() const;
    Status removeNote(std::int64_t id);
    Status addEvent(const SessionEvent &event);
    Result<std::vector<SessionEvent>> events(std::optional<RunId> run = std::nullopt) const; // nothing: all

    // The whole file: what is wrong with it, a sentence each; empty: nothing (session_check.cpp).
    Result<std::vector<std::string>> check(const ProgressHook &hook = {}) const;
    // As it is now, also while it is being recorded into; the target is replaced whole (session_copy.cpp).
    Status saveCopy(const std::filesystem::path &target, const ProgressHook &hook = {}) const;

    const Database &database() const; // for this folder

private:
    struct State;
    explicit SessionFile(std::unique_ptr<State> state);
    Status writable() const;

    std::unique_ptr<State> m_state;
};

} // namespace driftbench
