#include "app/cli/sibling_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace driftbench::cli {

std::optional<std::filesystem::path> siblingProgram(const std::string &name)
{
    std::error_code code;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", code);
    if (code)
        return std::nullopt;
    auto sibling = self.parent_path() / name;
    if (!std::filesystem::is_regular_file(sibling, code))
        return std::nullopt;
    return sibling;
}

int runQuietly(const std::filesystem::path &program, const std::vector<std::string> &arguments)
{
    std::string path = program.string();
    std::vector<std::string> texts = arguments;
    std::vector<char *> pointers{path.data()};
    for (std::string &text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    if (posix_spawn_file_actions_init(&actions) != 0)
        return -1;
    pid_t child = 0;
    const bool started =
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0) == 0 &&
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0) == 0 &&
        posix_spawn(&child, path.c_str(), &actions, nullptr, pointers.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    if (!started || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

} // namespace driftbench::cli
