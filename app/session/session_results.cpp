#include "app/session/session_file_state.h"
#include "engine/models/model_file.h"

namespace driftbench {

namespace {

Error noSuchModel(const Database &database, ModelId id)
{
    return {Errc::NoSuchRun, database.path().string() + " has no model number " + std::to_string(id) +
                                 "; \"session info\" lists them."};
}

std::optional<ModelId> modelIn(const Statement &row, int column)
{
    return row.isNull(column) ? std::nullopt : std::optional<ModelId>(row.integer(column));
}

} // namespace

Result<ModelId> SessionFile::addModel(const TrainedModel &model)
{
    if (Status allowed = writable(); !allowed)
        return allowed.error();
    auto transaction = Transaction::begin(database());
    if (!transaction)
        return transaction.error();
    if (Status added = database().run("INSERT INTO model(name, created_utc, json) VALUES(?1, ?2, ?3)",
                                      model.name, utcNow(), modelToJson(model));
        !added)
        return added.error();
    const ModelId id = database().lastInsertId();
    for (const std::string &name : model.trainedOn) {
        if (Status linked = database().run("INSERT INTO model_run(model_id, run_id, run_name)"
                                           " VALUES(?1, (SELECT id FROM run WHERE name = ?2), ?2)",
                                           id, name);
            !linked)
            return linked.error();
    }
    if (Status done = transaction->commit(); !done)
        return done.error();
    return id;
}

Result<std::vector<ModelRecord>> SessionFile::models() const
{
    Statement rows = database().prepare(
        "SELECT model.id, model.name, model.created_utc, model_run.run_name FROM model"
        " LEFT JOIN model_run ON model_run.model_id = model.id ORDER BY model.id, model_run.id");
    std::vector<ModelRecord> models;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return models;
        if (models.empty() || models.back().id != rows.integer(0))
            models.push_back({rows.integer(0), rows.text(1), rows.text(2), {}});
        if (!rows.isNull(3))
            models.back().trainedOn.push_back(rows.text(3));
    }
}

Result<TrainedModel> SessionFile::model(ModelId id) const
{
    Statement rows = database().prepare("SELECT name, json FROM model WHERE id = ?1");
    const auto row = rows.with(id).step();
    if (!row)
        return row.error();
    if (!*row)
        return noSuchModel(database(), id);
    return modelFromJson(rows.text(1), path().string() + ", model \"" + rows.text(0) + "\"");
}

Status SessionFile::removeModel(ModelId id)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    const auto known = database().integer("SELECT count(*) FROM model WHERE id = ?1", id);
    if (!known)
        return known.error();
    return *known == 0 ? Status(noSuchModel(database(), id))
                       : database().run("DELETE FROM model WHERE id = ?1", id);
}

Result<std::int64_t> SessionFile::addComparison(const std::string &comparisonJson,
                                                const std::string &recommendationJson)
{
    if (Status allowed = writable(); !allowed)
        return allowed.error();
    if (Status added =
            database().run("INSERT INTO comparison(created_utc, json, recommendation) VALUES(?1, ?2, ?3)",
                           utcNow(), comparisonJson, recommendationJson);
        !added)
        return added.error();
    return database().lastInsertId();
}

Result<std::vector<ComparisonRecord>> SessionFile::comparisons() const
{
    Statement rows =
        database().prepare("SELECT id, created_utc, json, recommendation FROM comparison ORDER BY id");
    std::vector<ComparisonRecord> comparisons;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return comparisons;
        comparisons.push_back({rows.integer(0), rows.text(1), rows.text(2), rows.text(3)});
    }
}

Status SessionFile::addExport(const ExportRecord &made)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run(
        "INSERT INTO export(utc, model_id, format, path, bytes, crc32) VALUES(?1, ?2, ?3, ?4, ?5, ?6)",
        orNow(made.utc), made.model, made.format, made.path, made.bytes, made.crc32);
}

Result<std::vector<ExportRecord>> SessionFile::exports() const
{
    Statement rows =
        database().prepare("SELECT utc, model_id, format, path, bytes, crc32 FROM export ORDER BY id");
    std::vector<ExportRecord> exports;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return exports;
        exports.push_back({rows.text(0), modelIn(rows, 1), rows.text(2), rows.text(3), rows.integer(4),
                           static_cast<std::uint32_t>(rows.integer(5))});
    }
}

Status SessionFile::addUpload(const UploadRecord &upload)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run(
        "INSERT INTO upload(utc, model_id, sensor_model, sensor_serial, device, kind, bank, generation,"
        " bytes, crc32, verified, activated, outcome)"
        " VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13)",
        orNow(upload.utc), upload.model, upload.sensor.model, upload.sensor.serial, upload.device,
        upload.kind, upload.bank, upload.generation, upload.bytes, upload.crc32, upload.verified,
        upload.activated, upload.outcome);
}

Result<std::vector<UploadRecord>> SessionFile::uploads() const
{
    Statement rows = database().prepare(
        "SELECT utc, model_id, sensor_model, sensor_serial, device, kind, bank, generation, bytes,"
        " crc32, verified, activated, outcome FROM upload ORDER BY id");
    std::vector<UploadRecord> uploads;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return uploads;
        uploads.push_back({rows.text(0),
                           modelIn(rows, 1),
                           {rows.text(2), rows.text(3)},
                           rows.text(4),
                           rows.text(5),
                           static_cast<int>(rows.integer(6)),
                           static_cast<std::uint32_t>(rows.integer(7)),
                           rows.integer(8),
                           static_cast<std::uint32_t>(rows.integer(9)),
                           rows.integer(10) != 0,
                           rows.integer(11) != 0,
                           rows.text(12)});
    }
}

} // namespace driftbench
