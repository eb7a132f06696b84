// Logs into a session, off the thread that owns it: read, then written as imported runs, one after the other.
// A file that can't be read does not keep the others out; a cancel keeps the runs that are in.
#pragma once

#include "app/session/job.h"
#include "app/session/session_file.h"
#include "engine/formats/read_options.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace driftbench {

struct LoadInput
{
    std::vector<std::filesystem::path> files;
    ReadOptions read{};
    SensorIdentity sensor{}; // stated by the user, for logs that don't say
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::shared_ptr<SessionFile> file; // a connection of its own
};

struct LoadedLog
{
    std::filesystem::path path;
    Result<RunId> run;
};

// The same without a thread, for programs that wait. One entry a file, as far as it came.
std::vector<LoadedLog> importLogs(const LoadInput &input, const ProgressHook &hook = {});

class LoadJob final : public Job
{
    Q_OBJECT

public:
    explicit LoadJob(QObject *parent = nullptr) : Job(parent) {}
    ~LoadJob() override { cancelAndWait(); }

    bool start(LoadInput input);

signals:
    void finished(const std::vector<driftbench::LoadedLog> &logs);
};

} // namespace driftbench
