#include "engine/models/model_file.h"

#include "engine/base/atomic_file.h"
#include "engine/base/checksum.h"
#include "engine/models/trained_model_json.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace driftbench {

namespace {

constexpr const char *kFormat = "driftbench model";
constexpr std::uintmax_t kLargestFile = 64U << 20U; // bytes
constexpr int kDeepestNesting = 16;                 // a model per axis needs 9

// Names of runs come from file names, which need not be UTF-8.
std::string dumped(const Json &json, int indent)
{
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// Of the whole document but for the field that holds it, written in one way only.
std::string checksumOf(Json document)
{
    document.erase("crc32");
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(crc32(dumped(document, -1))));
    return text.data();
}

Error damaged(const std::string &name, const std::string &clause)
{
    return {Errc::ModelDamaged,
            "The model file '" + name + "' " + clause + "; copy it again or train and save the model anew."};
}

// Nesting is bounded while parsing because writing (for the checksum) recurses.
Result<Json> parsed(std::string_view text, const std::string &name)
{
    if (text.empty())
        return damaged(name, "is empty");
    bool tooDeep = false;
    const auto watchDepth = [&tooDeep](int depth, Json::parse_event_t, Json &) {
        tooDeep = tooDeep || depth > kDeepestNesting;
        return depth <= kDeepestNesting;
    };
    try {
        Json document = Json::parse(text.begin(), text.end(), watchDepth);
        if (tooDeep)
            return damaged(name, "is nested deeper than any model");
        return document;
    } catch (const Json::parse_error &error) {
        if (error.byte > text.size())
            return damaged(name, "is cut off after " + std::to_string(text.size()) + " bytes");
        return damaged(name, "is not JSON at byte " + std::to_string(error.byte));
    } catch (const Json::exception &) {
        return damaged(name, "holds a number that is out of range");
    }
}

Status checkEnvelope(const Json &document, const std::string &name)
{
    if (!document.is_object() || document.value("format", Json()) != kFormat)
        return damaged(name, "is not a Driftbench model (its field format is not \"" + std::string(kFormat) +
                                 "\")");
    const Json version = document.value("version", Json());
    if (!version.is_number_unsigned() || version.get<std::uint64_t>() == 0)
        return damaged(name, "is damaged: version is not a whole number from 1 on");
    if (version.get<std::uint64_t>() > static_cast<std::uint64_t>(kModelFormatVersion))
        return Error{Errc::ModelTooNew,
                     "The model file '" + name + "' was written by a newer Driftbench (format " +
                         dumped(version, -1) + ", this one reads " + std::to_string(kModelFormatVersion) +
                         "): update, or save it again with this version."};
    const Json checksum = document.value("crc32", Json());
    if (!checksum.is_string())
        return damaged(name, "is damaged: crc32 is missing or not a text");
    if (checksum.get<std::string>() != checksumOf(document))
        return Error{Errc::ModelEdited,
                     "The model file '" + name +
                         "' was changed after it was saved (its checksum does not fit); use the "
                         "original or train and save the model anew."};
    return {};
}

Result<std::string> contentOf(const std::filesystem::path &file)
{
    const std::string name = file.string();
    std::error_code code;
    if (!std::filesystem::exists(file, code))
        return Error{Errc::FileNotFound, "There is no model file '" + name + "'; check its name and folder."};
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    if (code)
        return Error{Errc::FileUnreadable, "The model file '" + name + "' cannot be read (" + code.message() +
                                               "); check that it is a file and its permissions."};
    if (size > kLargestFile)
        return damaged(name, "is " + std::to_string(size >> 20U) + " MB, larger than any model");
    std::ifstream stream(file, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream.is_open() || stream.bad())
        return Error{Errc::FileUnreadable,
                     "The model file '" + name + "' cannot be read; check its permissions."};
    return content;
}

} // namespace

std::string modelToJson(const TrainedModel &model)
{
    Json document{{"format", kFormat}, {"version", kModelFormatVersion}, {"crc32", ""}};
    document.update(toJson(model));
    // Text that is not UTF-8 is replaced on writing; the checksum must be that of what can be read back.
    document["crc32"] = checksumOf(document);
    return dumped(document, 1) + "\n";
}

Result<TrainedModel> modelFromJson(std::string_view json, const std::string &name)
{
    const Result<Json> document = parsed(json, name);
    if (!document)
        return document.error();
    if (const Status status = checkEnvelope(*document, name); !status)
        return status.error();
    std::string problem;
    TrainedModel model = trainedModelFrom(FieldReader(*document, "", problem));
    if (!problem.empty())
        return damaged(name, "is damaged: " + problem);
    return model;
}

Status saveModel(const TrainedModel &model, const std::filesystem::path &file)
{
    return writeFileAtomically(file, modelToJson(model));
}

Result<TrainedModel> loadModel(const std::filesystem::path &file)
{
    const Result<std::string> content = contentOf(file);
    if (!content)
        return content.error();
    return modelFromJson(*content, file.string());
}

} // namespace driftbench
