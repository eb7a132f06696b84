// A trained model as a JSON object and back, without the envelope of the file (model_file.h). Used inside
// this folder only.
#pragma once

#include "engine/models/json_fields.h"
#include "engine/models/trained_model.h"

namespace driftbench {

Json toJson(const TrainedModel &model);
// What is wrong goes to the reader's problem; the model is then not to be used.
TrainedModel trainedModelFrom(const FieldReader &reader);

// "constant", "linear", "polynomial", "bp network", "rbf network", "per axis"
std::string modelKind(const AnyModel &model);
Json parametersToJson(const AnyModel &model);
// kind: any of the above but "per axis", which trainedModelFrom reads.
AnyModel modelFromParameters(const std::string &kind, const FieldReader &parameters);

} // namespace driftbench
