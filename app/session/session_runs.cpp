#include "app/session/chunk_store.h"
#include "app/session/session_file_state.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace driftbench {

namespace {

constexpr std::array<std::string_view, 4> kStateNames{"recording", "interrupted", "complete", "imported"};
constexpr Eigen::Index kImportAtOnce = 64 * static_cast<Eigen::Index>(kChunkSamples);

constexpr const char *kRunColumns =
    "SELECT id, name, state, source, format, instance, sensor_model, sensor_serial, simulated, compensated,"
    " sample_rate_hz, range_dps, reference_x_dps, reference_y_dps, reference_z_dps, started_utc, ended_utc,"
    " (SELECT first_time_s FROM chunk WHERE run_id = run.id ORDER BY first_sample LIMIT 1),"
    " (SELECT last_time_s FROM chunk WHERE run_id = run.id ORDER BY first_sample DESC LIMIT 1),"
    " (SELECT first_sample + samples FROM chunk WHERE run_id = run.id ORDER BY first_sample DESC LIMIT 1)"
    " FROM run WHERE state <> 'importing'";

RunRecord recordOf(const Statement &row)
{
    RunRecord record;
    record.id = row.integer(0);
    RunDescription &what = record.description;
    what.name = row.text(1);
    const auto state = std::find(kStateNames.begin(), kStateNames.end(), row.text(2));
    record.state = state == kStateNames.end()
                       ? RunState::Interrupted
                       : static_cast<RunState>(std::distance(kStateNames.begin(), state));
    what.source = row.text(3);
    what.format = row.text(4);
    what.instance = static_cast<int>(row.integer(5));
    what.sensor = {row.text(6), row.text(7)};
    what.simulated = row.integer(8) != 0;
    what.compensated = row.integer(9) != 0;
    what.sampleRateHz = row.real(10);
    what.rangeDps = row.real(11);
    what.referenceRateDps = {row.real(12), row.real(13), row.real(14)};
    what.startedUtc = row.text(15);
    record.endedUtc = row.text(16);
    record.samples = row.integer(19);
    record.firstTimeS = record.samples == 0 ? 0.0 : row.real(17);
    record.lastTimeS = record.samples == 0 ? 0.0 : row.real(18);
    return record;
}

// All, or that one if it is there.
Result<std::vector<RunRecord>> readRecords(const Database &database, std::optional<RunId> id)
{
    Statement rows = database.prepare(std::string(kRunColumns) + (id ? " AND id = ?1" : " ORDER BY id"));
    if (id)
        rows.with(*id);
    std::vector<RunRecord> records;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return records;
        records.push_back(recordOf(rows));
    }
}

// A run that nobody goes on with is not being recorded, whatever its state says until the file is opened for
// writing.
Result<std::vector<RunRecord>> recordsAsTheyAre(const SessionFile &file, std::optional<RunId> id)
{
    const auto beingRecorded = [](const RunRecord &run) { return run.state == RunState::Recording; };
    auto records = readRecords(file.database(), id);
    if (!records || !file.readOnly() || std::none_of(records->begin(), records->end(), beingRecorded) ||
        SessionLock::isHeld(file.path()))
        return records;
    // Again: its recorder may have ended it between the first look and that at the lock.
    records = readRecords(file.database(), id);
    if (!records)
        return records;
    for (RunRecord &run : *records) {
        if (beingRecorded(run))
            run.state = RunState::Interrupted;
    }
    return records;
}

Result<std::string> uniqueName(const Database &database, const std::string &wanted)
{
    const std::string base = wanted.empty() ? "run" : wanted;
    std::string name = base;
    for (int number = 2;; ++number) {
        const auto taken = database.integer("SELECT count(*) FROM run WHERE name = ?1", name);
        if (!taken)
            return taken.error();
        if (*taken == 0)
            return name;
        name = base + "-" + std::to_string(number);
    }
}

Status adoptSensor(const Database &database, const SensorIdentity &sensor)
{
    Statement row = database.prepare("SELECT sensor_model, sensor_serial FROM session");
    const auto there = row.step();
    if (!there)
        return there.error();
    const SensorIdentity known{row.text(0), row.text(1)};
    if (known.contradicts(sensor))
        return Error{Errc::DifferentSensors, "This session is of " + known.text() + ", the run of " +
                                                 sensor.text() + "; begin another session for it."};
    row.reset();
    return database.run("UPDATE session SET"
                        " sensor_model = CASE sensor_model WHEN '' THEN ?1 ELSE sensor_model END,"
                        " sensor_serial = CASE sensor_serial WHEN '' THEN ?2 ELSE sensor_serial END",
                        sensor.model, sensor.serial);
}

} // namespace

std::string_view runStateName(RunState state)
{
    return kStateNames[static_cast<std::size_t>(state)];
}

RunDescription describeSource(const SourceInfo &info, const std::string &runName)
{
    RunDescription what;
    what.name = runName;
    what.source = info.name;
    what.format = "live";
    what.sensor = info.sensor;
    what.simulated = info.simulated;
    what.compensated = info.compensated;
    what.sampleRateHz = info.sampleRateHz;
    what.rangeDps = info.rangeDps;
    return what;
}

RunDescription describeRecording(const RecordingInfo &info, const std::string &runName)
{
    RunDescription what;
    what.name = runName.empty() ? std::filesystem::path(info.source).stem().string() : runName;
    what.source = info.source;
    what.format = info.format;
    what.instance = info.instance;
    what.sensor = info.sensor;
    what.simulated = info.simulated;
    return what;
}

Error noSuchRun(const Database &database, RunId id)
{
    return {Errc::NoSuchRun, database.path().string() + " has no run number " + std::to_string(id) +
                                 "; \"session info\" lists them."};
}

Result<RunId> insertRun(const Database &database, const RunDescription &what, std::string_view state)
{
    if (Status adopted = adoptSensor(database, what.sensor); !adopted)
        return adopted.error();
    const auto name = uniqueName(database, what.name);
    if (!name)
        return name.error();
    if (Status inserted = database.run(
            "INSERT INTO run(name, state, source, format, instance, sensor_model, sensor_serial, simulated,"
            " compensated, sample_rate_hz, range_dps, reference_x_dps, reference_y_dps, reference_z_dps, "
            "started_utc)"
            " VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15)",
            *name, state, what.source, what.format, what.instance, what.sensor.model, what.sensor.serial,
            what.simulated, what.compensated, what.sampleRateHz, what.rangeDps, what.referenceRateDps[0],
            what.referenceRateDps[1], what.referenceRateDps[2], orNow(what.startedUtc));
        !inserted)
        return inserted.error();
    return database.lastInsertId();
}

Result<std::vector<RunRecord>> SessionFile::runs() const
{
    return recordsAsTheyAre(*this, {});
}

Result<RunRecord> SessionFile::run(RunId id) const
{
    auto records = recordsAsTheyAre(*this, id);
    if (!records)
        return records.error();
    if (records->empty())
        return noSuchRun(database(), id);
    return std::move(records->front());
}

Result<RunId> SessionFile::importRun(const Recording &recording, RunDescription description,
                                     const ProgressHook &hook)
{
    if (Status allowed = writable(); !allowed)
        return allowed.error();
    const auto begin = [&]() -> Result<RunId> {
        auto transaction = Transaction::begin(database());
        if (!transaction)
            return transaction.error();
        const auto id = insertRun(database(), description, "importing");
        if (!id)
            return id;
        for (const std::string &warning : recording.info.warnings) {
            if (Status logged = insertEvent(database(), {*id, 0, {}, "reader", warning}); !logged)
                return logged.error();
        }
        if (Status done = transaction->commit(); !done)
            return done.error();
        return id;
    };
    const auto id = begin();
    if (!id)
        return id;
    const auto write = [&]() -> Status {
        ChunkWriter writer(database(), *id, 0);
        for (Eigen::Index first = 0; first < recording.size(); first += kImportAtOnce) {
            const double fraction = static_cast<double>(first) / static_cast<double>(recording.size());
            if (report(hook, "import", fraction) == Flow::Stop)
                return Error{Errc::Cancelled, "The import was cancelled."};
            SampleColumns rows;
            rows.append(recording, first, std::min(kImportAtOnce, recording.size() - first));
            auto transaction = Transaction::begin(database());
            if (!transaction)
                return transaction.error();
            if (Status appended = writer.append(rows, 0, rows.size()); !appended)
                return appended;
            if (Status done = transaction->commit(); !done)
                return done;
            writer.committed();
        }
        return database().run("UPDATE run SET state = 'imported', ended_utc = ?2 WHERE id = ?1", *id,
                              utcNow());
    };
    if (Status written = write(); !written) {
        // If that fails too, the next opening does it.
        (void)database().run("DELETE FROM run WHERE id = ?1", *id);
        return written.error();
    }
    return id;
}

Status SessionFile::renameRun(RunId id, const std::string &name)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    if (const auto known = run(id); !known)
        return known.error();
    const auto taken = database().integer("SELECT count(*) FROM run WHERE name = ?1 AND id <> ?2", name, id);
    if (!taken)
        return taken.error();
    if (*taken != 0 || name.empty())
        return Error{Errc::InvalidOption,
                     "A run can't be called \"" + name +
                         "\": another has that name, or it is empty. Choose another name."};
    return database().run("UPDATE run SET name = ?2 WHERE id = ?1", id, name);
}

Status SessionFile::setReferenceRate(RunId id, const Eigen::Vector3d &rateDps)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    if (const auto known = run(id); !known)
        return known.error();
    if (!rateDps.allFinite())
        return Error{Errc::InvalidOption, "The reference rate of a run must be finite on every axis."};
    return database().run(
        "UPDATE run SET reference_x_dps = ?2, reference_y_dps = ?3, reference_z_dps = ?4 WHERE id = ?1", id,
        rateDps[0], rateDps[1], rateDps[2]);
}

Status SessionFile::removeRun(RunId id)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    const auto known = run(id);
    if (!known)
        return known.error();
    if (known->state == RunState::Recording)
        return Error{Errc::InvalidOption,
                     "Run \"" + known->description.name +
                         "\" is being recorded; end the recording before you remove it."};
    return database().run("DELETE FROM run WHERE id = ?1", id);
}

} // namespace driftbench
