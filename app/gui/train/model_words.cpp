#include "app/gui/train/model_words.h"

#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <QCoreApplication>

#include <algorithm>

namespace driftbench {

namespace {

class ModelWords
{
    Q_DECLARE_TR_FUNCTIONS(driftbench::ModelWords)
};

} // namespace

QString centresText(const std::array<int, 3> &centres)
{
    const auto [fewest, most] = std::minmax_element(centres.begin(), centres.end());
    if (*fewest == *most)
        return QString::number(*most);
    return ModelWords::tr("%1 to %2").arg(*fewest).arg(*most);
}

static QString centresPhrase(const std::array<int, 3> &centres)
{
    const auto [fewest, most] = std::minmax_element(centres.begin(), centres.end());
    return *fewest == *most ? ModelWords::tr("%n centres", nullptr, *most)
                            : ModelWords::tr("%1 to %2 centres").arg(*fewest).arg(*most);
}

static QString rbfTitle(const TrainedModel *model, bool paper)
{
    const auto *network = model != nullptr ? std::get_if<RbfNetwork>(&model->model) : nullptr;
    if (network == nullptr)
        return paper ? ModelWords::tr("RBF, paper (Novel)") : ModelWords::tr("RBF network (Novel)");
    const QString centres = centresPhrase(network->centreCount);
    return paper ? ModelWords::tr("RBF, paper, %1").arg(centres)
                 : ModelWords::tr("RBF, %1 (Novel)").arg(centres);
}

QString modelTitle(std::string_view name, const TrainedModel *model)
{
    if (name == "rbf" || name == "rbf-paper")
        return rbfTitle(model, name == "rbf-paper");
    if (name == "bpnn") {
        const auto *network = model != nullptr ? std::get_if<BpNetwork>(&model->model) : nullptr;
        const auto hidden = network != nullptr ? network->axes[0].hiddenBias.size() : 10;
        return ModelWords::tr("BP 2-%1-1 (Conv. 2)").arg(hidden);
    }
    if (name == "cubic")
        return ModelWords::tr("Cubic (PX4)");
    if (name == "cubic-ardupilot")
        return ModelWords::tr("Cubic (ArduPilot)");
    if (name == "linear")
        return ModelWords::tr("Line (Conv. 1)");
    if (name == "constant")
        return ModelWords::tr("Constant (bias only)");
    return modelLabel(name);
}

QString modelInputs(std::string_view name, const std::array<bool, 3> &rbfInputs)
{
    if (name == "constant")
        return {};
    if (name == "bpnn")
        return QStringLiteral("ΔT, ΔT²");
    if (!name.starts_with("rbf"))
        return QStringLiteral("ΔT");
    QStringList inputs;
    const std::array<QString, 3> names{QStringLiteral("ΔT"), QStringLiteral("ΔT²"), QStringLiteral("√ΔT")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (rbfInputs[i])
            inputs.append(names[i]);
    }
    return inputs.join(QStringLiteral(", "));
}

std::string mainModelName(const CalibrationResult &result)
{
    for (const char *name : {"rbf", "rbf-paper", "bpnn", "cubic", "cubic-ardupilot", "linear"}) {
        if (result.model(name) != nullptr)
            return name;
    }
    return {};
}

} // namespace driftbench
