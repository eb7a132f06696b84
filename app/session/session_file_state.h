// What a SessionFile has inside; for the files of this folder that implement it.
#pragma once

#include "app/session/database.h"
#include "app/session/session_file.h"
#include "app/session/session_lock.h"

namespace driftbench {

struct SessionFile::State
{
    std::filesystem::path path;
    SessionOptions options;
    Database database;
    std::shared_ptr<SessionLock> lock{}; // null: read-only
    std::string readOnlyReason{};
    int version = kSessionFormatVersion;
    std::vector<RunId> recovered{};
};

std::string utcNow();                                       // "2026-05-04T10:11:12.345Z"
std::optional<double> secondsOfUtc(const std::string &utc); // since 1970
std::string orNow(const std::string &utc);

// In a transaction of the caller's. The name is made unique, the session takes the run's sensor if it has
// none. DifferentSensors if the session is one of another sensor.
Result<RunId> insertRun(const Database &database, const RunDescription &description, std::string_view state);
Status insertEvent(const Database &database, const SessionEvent &event);

Error noSuchRun(const Database &database, RunId id);

} // namespace driftbench
