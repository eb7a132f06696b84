#include "support/test_data.h"

#include <QTemporaryDir>

namespace driftbench::test {

std::filesystem::path sharedData()
{
    if (qEnvironmentVariableIsSet("DRIFTBENCH_SHARED_DATA"))
        return qEnvironmentVariable("DRIFTBENCH_SHARED_DATA").toStdString();
    const auto beside = std::filesystem::path(DRIFTBENCH_SOURCE_DIR).parent_path() / "shared" / "data";
    return std::filesystem::is_directory(beside) ? beside : std::filesystem::path();
}

std::filesystem::path scratchFolder()
{
    static const QTemporaryDir folder;
    return folder.path().toStdString();
}

} // namespace driftbench::test
