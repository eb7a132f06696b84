#include "widgets/style/role_pens.h"

#include <QCoreApplication>

namespace driftbench {

namespace {

class ModelLabels
{
    Q_DECLARE_TR_FUNCTIONS(driftbench::ModelLabels)
};

} // namespace

QColor roleColor(Role role, const Palette &palette)
{
    switch (role) {
    case Role::Raw:
        return palette.raw;
    case Role::Compensated:
        return palette.compensated;
    case Role::BpNetwork:
        return palette.bpNetwork;
    case Role::Cubic:
        return palette.cubic;
    case Role::Line:
        return palette.line;
    case Role::Constant:
        return palette.constant;
    case Role::Heating:
        return palette.heating;
    case Role::Cooling:
        return palette.cooling;
    case Role::Excluded:
        return palette.excluded;
    }
    return palette.text;
}

static QList<qreal> dashes(Role role)
{
    switch (role) {
    case Role::BpNetwork:
        return {8, 3, 2, 3};
    case Role::Cubic:
        return {6, 3};
    case Role::Line:
        return {2, 3};
    case Role::Constant:
        return {1, 2};
    default:
        return {};
    }
}

QPen rolePen(Role role, const Palette &palette)
{
    QPen pen(roleColor(role, palette), 1.0);
    const QList<qreal> pattern = dashes(role);
    if (!pattern.isEmpty()) {
        pen.setDashPattern(pattern);
        pen.setCapStyle(Qt::FlatCap);
    }
    return pen;
}

Role roleOfModel(std::string_view name)
{
    if (name == "bpnn")
        return Role::BpNetwork;
    if (name.starts_with("cubic"))
        return Role::Cubic;
    if (name == "linear")
        return Role::Line;
    if (name == "constant")
        return Role::Constant;
    return Role::Compensated;
}

QString modelLabel(std::string_view name)
{
    if (name == "rbf")
        return ModelLabels::tr("RBF network");
    if (name == "rbf-paper")
        return ModelLabels::tr("RBF network, as in the paper");
    if (name == "bpnn")
        return ModelLabels::tr("BP network");
    if (name == "cubic")
        return ModelLabels::tr("cubic");
    if (name == "cubic-ardupilot")
        return ModelLabels::tr("cubic, as ArduPilot");
    if (name == "linear")
        return ModelLabels::tr("line");
    if (name == "constant")
        return ModelLabels::tr("constant");
    if (name == "auto")
        return ModelLabels::tr("recommended model of each axis");
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString shortModelLabel(std::string_view name)
{
    if (name.starts_with("rbf"))
        return QStringLiteral("RBF");
    if (name == "bpnn")
        return QStringLiteral("BP");
    return modelLabel(name);
}

} // namespace driftbench
