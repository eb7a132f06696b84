#include "app/cli/fit_files.h"

#include "app/campaign/calibration_result.h"
#include "app/campaign/held_out_folders.h"
#include "app/cli/output_folder.h"
#include "app/cli/pending_files.h"
#include "engine/models/model_file.h"
#include "engine/models/model_recipe.h"

#include <set>
#include <system_error>

namespace driftbench::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char *kModels = "models";
constexpr const char *kHeldOut = "held-out";
constexpr const char *kAuto = "auto";

// Gathers the files of a fit and knows afterwards which of them are its own.
class FitWriter
{
public:
    explicit FitWriter(fs::path folder) : m_folder(std::move(folder)) {}

    Status add(const fs::path &relative, const std::string &text)
    {
        const fs::path target = m_folder / relative;
        if (Status made = m_folders.make(target.parent_path()); !made)
            return made;
        m_written.insert(target);
        return m_files.add(target, text);
    }

    Status commit()
    {
        if (Status committed = m_files.commit(); !committed)
            return committed;
        m_folders.keep();
        return removeEarlier();
    }

private:
    // Models of an earlier fit, and the folders that they leave empty.
    Status removeEarlier() const
    {
        std::error_code code;
        std::vector<fs::path> places{m_folder / kModels};
        for (const fs::directory_entry &entry : fs::directory_iterator(m_folder / kHeldOut, code)) {
            if (entry.is_directory(code) && !entry.is_symlink(code))
                places.push_back(entry.path());
        }
        std::vector<std::string> names = knownModelNames();
        names.push_back(kAuto);
        for (const fs::path &place : places) {
            for (const std::string &name : names) {
                if (Status removed = removeUnlessWritten(place / (name + ".json")); !removed)
                    return removed;
            }
            fs::remove(place, code); // does nothing to a folder that is not empty
        }
        return removeUnlessWritten(m_folder / kDynamicExperiment);
    }

    Status removeUnlessWritten(const fs::path &file) const
    {
        std::error_code code;
        if (m_written.contains(file) || fs::remove(file, code) || !code)
            return {};
        return Error{Errc::OutputNotWritable, file.string() + " is of an earlier fit and can't be removed: " +
                                                  code.message() + ". Remove it or choose another folder."};
    }

    fs::path m_folder;
    OutputFolders m_folders;
    PendingFiles m_files; // goes before the folders: its temporary files lie in them
    std::set<fs::path> m_written;
};

Status addModels(FitWriter &writer, const Comparison &comparison)
{
    for (const TrainedModel &model : comparison.models) {
        if (Status added = writer.add(fs::path(kModels) / (model.name + ".json"), modelToJson(model)); !added)
            return added;
    }
    const std::vector<HeldOutModels> heldOut = heldOutModels(comparison);
    std::vector<std::string> foldNames;
    for (const HeldOutModels &fold : heldOut)
        foldNames.push_back(fold.fold);
    const std::vector<std::string> folders = heldOutFolders(foldNames);
    for (std::size_t f = 0; f < folders.size(); ++f) {
        for (const TrainedModel &model : heldOut[f].models) {
            const fs::path file = fs::path(kHeldOut) / folders[f] / (model.name + ".json");
            if (Status added = writer.add(file, modelToJson(model)); !added)
                return added;
        }
    }
    return {};
}

} // namespace

Status writeFitFiles(const std::filesystem::path &folder, const Comparison &comparison,
                     const CampaignSummary &campaign, const std::vector<NamedText> &beside)
{
    FitWriter writer(folder);
    if (Status added = addModels(writer, comparison); !added)
        return added;
    for (const NamedText &file : beside) {
        if (Status added = writer.add(file.name, file.text); !added)
            return added;
    }
    for (const auto &[name, text] : comparisonFiles(comparison, campaign)) {
        if (Status added = writer.add(name, text); !added)
            return added;
    }
    return writer.commit();
}

} // namespace driftbench::cli
