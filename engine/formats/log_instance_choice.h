// Which of a log's sensors to read.
#pragma once

#include "engine/formats/log_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// Extends what is known of an instance by one sample.
void note(LogInstance &instance, double timeS, double temperatureC);

// "1 (IMU2): 11916 samples at 50.0 Hz for 238.3 s, 27.1 to 33.0 °C"
std::string described(const LogInstance &instance);

// The wanted instance; without a wish the only one of those that `preferred` names. NoSuchInstance otherwise,
// and MissingColumn if it has no temperature.
Result<LogInstance> chooseInstance(const std::vector<LogInstance> &instances, std::optional<int> wanted,
                                   const std::vector<int> &preferred, const std::string &file);

} // namespace driftbench
