// The source choice of a session: kept as JSON, and opened for the jobs that use it.
#pragma once

#include "app/session/acquisition.h"
#include "app/session/upload_job.h"
#include "device/open_source.h"
#include "device/source_choice.h"
#include "engine/base/result.h"

#include <functional>
#include <string>

namespace driftbench {

std::string sourceChoiceToJson(const SourceChoice &choice);
// SessionDamaged.
Result<SourceChoice> sourceChoiceFromJson(const std::string &json);

// To be called where opening may take its time: device_match.h has what can go wrong.
// opened: told of what was opened, by the thread that opens; may be left out.
Acquisition::OpenSource sourceOpener(SourceChoice choice, HidAccess access = hidDevicesOfThisComputer(),
                                     std::function<void(const OpenedSource &)> opened = {});
OpenClient clientOpener(SourceChoice choice, HidAccess access = hidDevicesOfThisComputer());

} // namespace driftbench
