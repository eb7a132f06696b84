#include "app/session/chunk_overview.h"
#include "app/session/chunk_store.h"
#include "app/session/overview_store.h"
#include "app/session/session_file_state.h"

#include <limits>

namespace driftbench {

namespace {

constexpr std::int64_t kMostFindingsOfSqlite = 100;

// What SQLite itself finds: its pages and indexes, and references to rows that are not there.
Status checkTables(const Database &database, std::vector<std::string> &findings)
{
    Statement pages =
        database.prepare("PRAGMA integrity_check(" + std::to_string(kMostFindingsOfSqlite) + ")");
    for (;;) {
        const auto row = pages.step();
        if (!row)
            return row.error();
        if (!*row)
            break;
        if (const std::string found = pages.text(0); found != "ok")
            findings.push_back("The database's own check says: " + found + ".");
    }
    Statement references = database.prepare("PRAGMA foreign_key_check");
    for (;;) {
        const auto row = references.step();
        if (!row)
            return row.error();
        if (!*row)
            return {};
        findings.push_back("Table " + references.text(0) + ", row " + std::to_string(references.integer(1)) +
                           ", refers to a row of " + references.text(2) + " that is not there.");
    }
}

// "" or what is wrong with the stored one, behind the chunk's name.
Result<std::string> overviewFault(const Database &database, RunId run, const ChunkView &chunk,
                                  const RunOverview &computed)
{
    const auto stored = storedOverview(database, run, chunk.firstSample);
    if (!stored)
        return stored.error();
    if (!stored->has_value())
        return std::string(" has no overview.");
    return std::string(
        **stored == packedOverview(computed) ? "" : " has an overview that does not fit its samples.");
}

Status checkRun(const SessionFile &file, const RunRecord &run, std::vector<std::string> &findings,
                const std::function<Flow(std::int64_t)> &progress)
{
    const Database &database = file.database();
    const bool overviews = file.formatVersion() >= kOverviewsSinceVersion;
    const std::string name = "Run \"" + run.description.name + "\": ";
    std::int64_t next = 0;
    bool cancelled = false;
    constexpr auto all = std::numeric_limits<std::int64_t>::max();
    Status read = forEachChunk(database, run.id, 0, all, [&](const ChunkView &chunk) {
        const std::string which = name + "the chunk at sample " + std::to_string(chunk.firstSample);
        if (chunk.firstSample != next)
            findings.push_back(which +
                               (chunk.firstSample > next
                                    ? " comes behind missing samples from "
                                    : " overlaps the one before it, which ends before ") +
                               std::to_string(next) + ".");
        RunOverview overview;
        if (const std::string fault = overviewOf(chunk, overview); !fault.empty())
            findings.push_back(which + " is damaged: " + fault + ".");
        else if (overviews) {
            const auto wrong = overviewFault(database, run.id, chunk, overview);
            if (!wrong || !wrong->empty())
                findings.push_back(wrong ? which + *wrong : wrong.error().message);
        }
        next = chunk.firstSample + static_cast<std::int64_t>(std::min(chunk.samples, kChunkSamples));
        cancelled = progress(next) == Flow::Stop;
        return cancelled ? Flow::Stop : Flow::Continue;
    });
    if (cancelled)
        return Error{Errc::Cancelled, "The check was cancelled."};
    return read;
}

} // namespace

Result<std::vector<std::string>> SessionFile::check(const ProgressHook &hook) const
{
    const auto transaction = Transaction::beginReading(database());
    if (!transaction)
        return transaction.error();
    std::vector<std::string> findings;
    if (Status checked = checkTables(database(), findings); !checked) {
        if (checked.error().code != Errc::SessionDamaged)
            return checked.error();
        findings.push_back(checked.error().message);
    }
    const auto known = runs();
    if (!known) {
        if (known.error().code != Errc::SessionDamaged)
            return known.error();
        findings.push_back(known.error().message);
        return findings;
    }
    std::int64_t samples = 0;
    for (const RunRecord &run : *known)
        samples += run.samples;
    std::int64_t before = 0;
    for (const RunRecord &run : *known) {
        const Status checked = checkRun(*this, run, findings, [&](std::int64_t done) {
            return report(hook, "check",
                          static_cast<double>(before + done) /
                              static_cast<double>(std::max<std::int64_t>(samples, 1)));
        });
        if (!checked && checked.error().code != Errc::SessionDamaged)
            return checked.error();
        if (!checked)
            findings.push_back(checked.error().message);
        before += run.samples;
    }
    for (const ModelRecord &record : models().ok() ? *models() : std::vector<ModelRecord>()) {
        if (const auto model = this->model(record.id); !model)
            findings.push_back(model.error().message);
    }
    if (const auto stored = plan(); !stored)
        findings.push_back(stored.error().message);
    return findings;
}

} // namespace driftbench
