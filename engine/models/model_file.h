// Models as JSON files: format version, units, feature set, normalisation, trained temperature range, sensor,
// training summary, verdicts, parameters, and a CRC-32 over all of it, so that a cut or edited file is
// refused. The same model always gives the same bytes; numbers read back to the same doubles.
#pragma once

#include "engine/base/result.h"
#include "engine/models/trained_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace driftbench {

inline constexpr int kModelFormatVersion = 1;

std::string modelToJson(const TrainedModel &model);

// name: of the file, for messages. Errc: ModelDamaged (cut, not JSON, a field missing or of the wrong shape),
// ModelEdited (checksum), ModelTooNew.
Result<TrainedModel> modelFromJson(std::string_view json, const std::string &name);

Status saveModel(const TrainedModel &model, const std::filesystem::path &file);
Result<TrainedModel> loadModel(const std::filesystem::path &file);

} // namespace driftbench
