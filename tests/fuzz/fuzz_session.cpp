// Any bytes as a session file; begin with tests/golden/session-v*.driftbench, so that what changes is their
// pages.
#include "app/session/session_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace driftbench;

namespace {

// A folder of its own that goes with the object: SQLite opens no file without a name, and puts others beside
// it.
class SessionFolder
{
public:
    SessionFolder(const std::uint8_t *data, std::size_t bytes)
    {
        std::string name = (std::filesystem::temp_directory_path() / "fuzz_session.XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            std::abort();
        m_folder = name;
        std::ofstream file(path(), std::ios::binary);
        file.write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(bytes));
        if (!file.flush())
            std::abort();
    }
    ~SessionFolder()
    {
        std::error_code code;
        std::filesystem::remove_all(m_folder, code);
    }
    SessionFolder(const SessionFolder &) = delete;
    SessionFolder &operator=(const SessionFolder &) = delete;

    std::filesystem::path path() const { return m_folder / "session.driftbench"; }

private:
    std::filesystem::path m_folder;
};

template <class T>
void expectSentence(const Result<T> &result)
{
    if (!result && result.error().message.empty())
        std::abort();
}

} // namespace

// Whatever the bytes are: an error with a sentence, or what is recoverable.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t bytes)
{
    const SessionFolder folder(data, bytes);
    const auto file = SessionFile::open(folder.path(), SessionAccess::ReadOnly);
    expectSentence(file);
    if (!file)
        return 0;
    expectSentence(file->check());
    const auto runs = file->runs();
    expectSentence(runs);
    for (const RunRecord &run : runs ? *runs : std::vector<RunRecord>()) {
        const auto strict = file->readRun(run.id);
        const auto lenient = file->readRun(run.id, {true});
        expectSentence(strict);
        expectSentence(lenient);
        expectSentence(file->overview(run.id));
        expectSentence(file->gaps(run.id));
        expectSentence(file->exclusions(run.id));
        expectSentence(file->mask(run.id));
    }
    expectSentence(file->models());
    expectSentence(file->plan());
    expectSentence(file->comparisons());
    expectSentence(file->uploads());
    expectSentence(file->events());
    return 0;
}
