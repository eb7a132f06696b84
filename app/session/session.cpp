#include "app/session/session.h"

#include "app/session/session_file_state.h"
#include "app/session/session_lock.h"

#include <QDateTime>

#include <algorithm>

namespace driftbench {

namespace {

namespace fs = std::filesystem;

constexpr const char *kUnnamed = "unnamed"; // document of a session that has no name yet

fs::path newUnnamedPath(const fs::path &folder)
{
    const std::string stem = QDateTime::currentDateTime().toString("yyyy-MM-dd-HHmmss").toStdString();
    fs::path path = folder / (stem + std::string(kSessionEnding));
    std::error_code code;
    for (int number = 2; fs::exists(path, code); ++number)
        path = folder / (stem + "-" + std::to_string(number) + std::string(kSessionEnding));
    return path;
}

void removeSessionFile(const fs::path &path)
{
    std::error_code code; // what can't be removed is found again as an unnamed session
    for (const char *ending : {"", "-wal", "-shm", "-lock"})
        fs::remove(path.string() + ending, code);
}

SessionOptions writtenByThis()
{
    SessionOptions options;
    options.writtenBy = "driftbench " DRIFTBENCH_VERSION;
    return options;
}

} // namespace

Session::Session(SessionFile file) : m_file(std::move(file)) {}

Session::~Session()
{
    const bool holdsNothing = m_runs.empty() && m_notes.empty() && !m_testPlan;
    if (!m_unnamed || !holdsNothing || isReadOnly())
        return;
    const fs::path file = path();
    {
        const SessionFile closed = std::move(m_file);
    }
    removeSessionFile(file);
}

Result<std::unique_ptr<Session>> Session::around(SessionFile file)
{
    std::unique_ptr<Session> session(new Session(std::move(file)));
    if (Status loaded = session->load(); !loaded)
        return loaded.error();
    return session;
}

Result<std::unique_ptr<Session>> Session::create(const fs::path &file)
{
    auto created = SessionFile::create(file, writtenByThis());
    if (!created)
        return created.error();
    return around(*std::move(created));
}

Result<std::unique_ptr<Session>> Session::createUnnamed(const fs::path &folder)
{
    std::error_code code;
    fs::create_directories(folder, code);
    if (code)
        return Error{Errc::OutputNotWritable, "The folder " + folder.string() +
                                                  " for new sessions can't be made (" + code.message() +
                                                  "); make room or permit it."};
    auto created = SessionFile::create(newUnnamedPath(folder), writtenByThis());
    if (!created)
        return created.error();
    if (Status marked = created->setDocument(kUnnamed, "yes"); !marked)
        return marked.error();
    return around(*std::move(created));
}

Result<std::unique_ptr<Session>> Session::open(const fs::path &file, SessionAccess access)
{
    auto opened = SessionFile::open(file, access, writtenByThis());
    if (!opened)
        return opened.error();
    return around(*std::move(opened));
}

std::vector<fs::path> Session::unnamedSessions(const fs::path &folder)
{
    std::vector<fs::path> found;
    std::error_code code;
    for (const fs::directory_entry &entry : fs::directory_iterator(folder, code)) {
        if (entry.path().extension() != kSessionEnding || !SessionLock::acquire(entry.path()))
            continue;
        const auto file = SessionFile::open(entry.path(), SessionAccess::ReadOnly);
        if (!file)
            continue;
        const auto unnamed = file->document(kUnnamed);
        const auto runs = file->runs();
        if (unnamed && *unnamed && runs && !runs->empty())
            found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end(), std::greater<>()); // their names begin with the time
    return found;
}

QString Session::name() const
{
    return m_unnamed ? tr("unnamed") : QString::fromStdString(path().stem().string());
}

Result<std::shared_ptr<SessionFile>> Session::anotherFile() const
{
    auto another = m_file.another();
    if (!another)
        return another.error();
    return std::make_shared<SessionFile>(*std::move(another));
}

Status Session::saveAs(const fs::path &file)
{
    const bool recording = std::any_of(m_runs.begin(), m_runs.end(),
                                       [](const RunRecord &run) { return run.state == RunState::Recording; });
    if (recording)
        return Error{Errc::InvalidOption,
                     "The session is being recorded into; stop the recording, then name it."};
    std::error_code code;
    if (fs::equivalent(file, path(), code))
        return Error{Errc::InvalidOption,
                     file.string() + " is this session's own file; choose another name."};
    if (Status copied = m_file.saveCopy(file); !copied)
        return copied;
    auto opened = SessionFile::open(file, SessionAccess::ReadWrite, writtenByThis());
    if (!opened)
        return opened.error();
    const fs::path before = path();
    const bool wasUnnamed = m_unnamed && !isReadOnly();
    m_file = *std::move(opened);
    // What the disk of the file before did not take, that of the new one may.
    if (Status saved = saveAgain(); !saved)
        return saved;
    if (m_unnamed) {
        if (Status named = m_file.removeDocument(kUnnamed); !named)
            return named;
        m_unnamed = false;
    }
    if (wasUnnamed)
        removeSessionFile(before);
    emit nameChanged();
    return {};
}

Status Session::load()
{
    const auto unnamed = m_file.document(kUnnamed);
    if (!unnamed)
        return unnamed.error();
    m_unnamed = unnamed->has_value();
    auto plan = m_file.plan();
    if (!plan)
        return plan.error();
    m_testPlan = *std::move(plan);
    if (Status runs = readRuns(); !runs)
        return runs;
    // What was measured is of use without them.
    std::vector<SessionEvent> problems;
    for (const auto part :
         {&Session::loadSource, &Session::loadPlan, &Session::loadChoice, &Session::loadResult}) {
        if (const Status loaded = (this->*part)(); !loaded)
            problems.push_back({std::nullopt, 0, utcNow(), "problem", loaded.error().message});
    }
    auto exports = m_file.exports();
    if (!exports)
        return exports.error();
    m_exports = *std::move(exports);
    auto uploads = m_file.uploads();
    if (!uploads)
        return uploads.error();
    m_uploads = *std::move(uploads);
    auto notes = m_file.notes();
    if (!notes)
        return notes.error();
    m_notes = *std::move(notes);
    auto events = m_file.events();
    if (!events)
        return events.error();
    m_events = *std::move(events);
    m_events.insert(m_events.end(), problems.begin(), problems.end());
    return {};
}

} // namespace driftbench
