#include "support/test_data.h"

#include <QTemporaryDir>

namespace driftbench::test {

QString sourceFolder()
{
    return QStringLiteral(DRIFTBENCH_SOURCE_DIR);
}

QString programFolder()
{
    return QStringLiteral(DRIFTBENCH_BIN_DIR);
}

std::filesystem::path sharedData()
{
    if (qEnvironmentVariableIsSet("DRIFTBENCH_SHARED_DATA"))
        return qEnvironmentVariable("DRIFTBENCH_SHARED_DATA").toStdString();
    const auto beside = std::filesystem::path(sourceFolder().toStdString()).parent_path() / "shared" / "data";
    return std::filesystem::is_directory(beside) ? beside : std::filesystem::path();
}

std::filesystem::path scratchFolder()
{
    static const QTemporaryDir folder;
    return folder.path().toStdString();
}

} // namespace driftbench::test
