#include "app/report/physics_figures.h"

#include "app/report/figure_writer.h"
#include "app/report/index_page.h"
#include "widgets/style/number_text.h"
#include "widgets/views/curve_panels_view.h"

#include <cmath>

namespace driftbench {

namespace {

constexpr double kAttoPerFemto = 1000.0;

QVector<double> toQVector(const Column &values, double factor = 1.0)
{
    QVector<double> result;
    result.reserve(static_cast<qsizetype>(values.size()));
    for (const double value : values)
        result.append(value * factor);
    return result;
}

QString smallNumber(double value)
{
    return value != 0.0 && std::abs(value) < 1e-3
               ? powerText(value, 1)
               : numberText(value, std::max(decimalsForThreeFigures(value), 0));
}

void writeError(const PhysicsFile &physics, const Palette &look, FigureWriter &writer)
{
    const QVector<double> temperatureC = toQVector(physics.temperatureC);
    const QVector<double> rest(temperatureC.size(), physics.restChangeFf);
    const QString key = QStringLiteral("T (°C)");
    std::vector<CurvePanel> panels{
        {QStringLiteral("Change by the displacement"),
         {},
         key,
         QStringLiteral("Change (fF)"),
         false,
         {{QStringLiteral("ΔC′"), Role::Compensated, temperatureC, toQVector(physics.changeFf)},
          {QStringLiteral("ΔC at T0"), Role::Constant, temperatureC, rest}}},
        {QStringLiteral("Error ΔE = ΔC′ − ΔC"),
         QStringLiteral("%1 fF read as 1 dps").arg(smallNumber(physics.scaleFactorFfPerDps)),
         key,
         QStringLiteral("ΔE (fF)"),
         true,
         {{{}, Role::Compensated, temperatureC, toQVector(physics.errorFf)}}}};
    CurvePanelsView view(QStringLiteral("Capacitance error over temperature"), look);
    view.setPanels(std::move(panels), 2);
    writer.write(view, "capacitance_error",
                 QStringLiteral("Capacitance of the combs, displaced by %1 µm, over temperature")
                     .arg(smallNumber(physics.displacementUm)),
                 QStringLiteral("Eqs. (4), (10) and (11), corrected: what the displacement changes, and what "
                                "temperature adds to it; it is zero at T0 = %1 °C.")
                     .arg(numberText(physics.straightAtC, 1)));
}

void writeGaps(const PhysicsFile &physics, const Palette &look, FigureWriter &writer)
{
    CurvePanel panel{QStringLiteral("Gap along the overlap"), {},    QStringLiteral("x (µm)"),
                     QStringLiteral("Gap d1 (µm)"),           false, {}};
    for (const PhysicsGap &gap : physics.gaps) {
        const Role role = gap.temperatureC > physics.straightAtC ? Role::Heating : Role::Cooling;
        panel.curves.push_back({QStringLiteral("%1 °C").arg(numberText(gap.temperatureC, 1)), role,
                                toQVector(physics.alongUm), toQVector(gap.gapUm)});
    }
    CurvePanelsView view(QStringLiteral("Gap along the combs"), look);
    view.setPanels({std::move(panel)}, 1);
    writer.write(
        view, "gap_profile", QStringLiteral("Gap between two combs along their overlap"),
        QStringLiteral("Eq. (9), at rest. Above T0 the combs thicken towards their ends and the gap narrows "
                       "there first; below T0 it widens."));
}

Role roleOfSet(std::size_t place)
{
    constexpr std::array kRoles{Role::Line, Role::BpNetwork, Role::Compensated, Role::Cubic};
    return kRoles[std::min(place, kRoles.size() - 1)];
}

void writeQuantities(const PhysicsFile &physics, const Palette &look, FigureWriter &writer)
{
    std::vector<CurvePanel> panels;
    for (std::size_t i = 0; i < physics.quantities.size(); ++i) {
        const PhysicsQuantities &of = physics.quantities[i];
        panels.push_back(
            {QString::fromStdString(of.set),
             QStringLiteral("%1 of the variance left").arg(powerText(of.unexplained, 1)),
             QStringLiteral("T (°C)"),
             QStringLiteral("Residual (aF)"),
             true,
             {{{}, roleOfSet(i), toQVector(physics.temperatureC), toQVector(of.residualFf, kAttoPerFemto)}}});
    }
    CurvePanelsView view(QStringLiteral("What the temperature quantities leave"), look);
    view.setPanels(std::move(panels), 2);
    writer.write(view, "quantities_residual", QStringLiteral("What the temperature quantities leave of ΔE"),
                 QStringLiteral("Least squares with a constant on the physics itself, without noise; each "
                                "panel has its own scale. ΔE is analytic in ΔT, so a cube leaves less than "
                                "the root, whose kink at T0 stays."));
}

} // namespace

Result<std::vector<WrittenFigure>> writePhysicsFigures(const PhysicsFile &physics, const Palette &look,
                                                       const std::filesystem::path &folder)
{
    FigureWriter writer(folder, {});
    writeError(physics, look, writer);
    writeGaps(physics, look, writer);
    writeQuantities(physics, look, writer);
    return writer.finish();
}

QString physicsPage(const PhysicsFile &physics, const std::vector<WrittenFigure> &figures,
                    const Palette &look)
{
    const QString title = QStringLiteral("Sensing combs under thermal stress");
    QString html = pageStart(title, look);
    html += QStringLiteral("<h1>%1<span class=\"chip\">Computed</span></h1>").arg(title);
    html += QStringLiteral("<p class=\"muted\">%1 to %2 °C · straight at %3 °C · displaced by %4 µm</p>\n")
                .arg(numberText(physics.temperatureC.front(), 1), numberText(physics.temperatureC.back(), 1),
                     numberText(physics.straightAtC, 1), smallNumber(physics.displacementUm));
    if (physics.endsAtContact)
        html += QStringLiteral("<p>The combs touch at %1 °C; the figures end short of it.</p>")
                    .arg(numberText(physics.contactC, 3));
    for (const WrittenFigure &figure : figures)
        html += figureBlock(figure);
    return html + QStringLiteral("</body></html>\n");
}

} // namespace driftbench
