#include "app/session/session_file_state.h"

namespace driftbench {

Status insertEvent(const Database &database, const SessionEvent &event)
{
    return database.run("INSERT INTO event(utc, run_id, at_sample, kind, text) VALUES(?1, ?2, ?3, ?4, ?5)",
                        orNow(event.utc), event.run, event.atSample, event.kind, event.text);
}

Status SessionFile::addEvent(const SessionEvent &event)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return insertEvent(database(), event);
}

Result<std::vector<SessionEvent>> SessionFile::events(std::optional<RunId> run) const
{
    Statement rows = database().prepare("SELECT run_id, at_sample, utc, kind, text FROM event"
                                        " WHERE ?1 IS NULL OR run_id = ?1 ORDER BY id");
    rows.with(run);
    std::vector<SessionEvent> events;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return events;
        const auto of = rows.isNull(0) ? std::nullopt : std::optional<RunId>(rows.integer(0));
        events.push_back({of, rows.integer(1), rows.text(2), rows.text(3), rows.text(4)});
    }
}

Result<std::int64_t> SessionFile::addNote(const NoteRecord &note)
{
    if (Status allowed = writable(); !allowed)
        return allowed.error();
    if (Status added = database().run("INSERT INTO note(utc, run_id, text) VALUES(?1, ?2, ?3)",
                                      orNow(note.utc), note.run, note.text);
        !added)
        return added.error();
    return database().lastInsertId();
}

Result<std::vector<NoteRecord>> SessionFile::notes() const
{
    Statement rows = database().prepare("SELECT id, utc, run_id, text FROM note ORDER BY id");
    std::vector<NoteRecord> notes;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return notes;
        const auto of = rows.isNull(2) ? std::nullopt : std::optional<RunId>(rows.integer(2));
        notes.push_back({rows.integer(0), rows.text(1), of, rows.text(3)});
    }
}

Status SessionFile::removeNote(std::int64_t id)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run("DELETE FROM note WHERE id = ?1", id);
}

} // namespace driftbench
