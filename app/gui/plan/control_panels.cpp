#include "app/gui/plan/control_panels.h"

#include "engine/physics/chamber_transient.h"
#include "engine/physics/control_figures.h"
#include "widgets/controls/readout_grid.h"
#include "widgets/controls/state_word.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"
#include "widgets/views/transient_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace driftbench {

static QString withUnit(double value, int decimals, const QString &unit)
{
    return numberText(value, decimals) + QLatin1Char(' ') + unit;
}

IntervalPanel::IntervalPanel(QWidget *parent)
    : Panel(parent)
    , m_terms(new ReadoutGrid)
    , m_ratio(new ReadoutGrid)
    , m_used(new TextLabel(TextRole::Result))
    , m_verdict(new StateWord)
    , m_remark(new TextLabel(TextRole::Note))
{
    for (int row = 0; row < 3; ++row)
        m_terms->nameLabel(m_terms->addRow({})).setTextFormat(Qt::RichText);
    m_ratio->nameLabel(m_ratio->addRow({})).setTextFormat(Qt::RichText);
    rows()->addWidget(m_terms);
    rows()->addSpacing(8);
    rows()->addWidget(new Rule);
    rows()->addSpacing(8);
    rows()->addWidget(m_ratio);
    auto *result = new QHBoxLayout;
    result->setSpacing(8);
    result->addWidget(m_used);
    result->addWidget(m_verdict);
    result->addStretch(1);
    rows()->addLayout(result);
    rows()->addSpacing(4);
    m_remark->setWordWrap(true);
    rows()->addWidget(m_remark);
    rows()->addStretch(1);
}

void IntervalPanel::setPlan(const TestPlan &plan)
{
    const auto interval = controlInterval(plan.sensor, plan.lowestC, plan.highestC);
    setEnabled(interval.ok());
    if (!interval)
        return;
    const SensorDatasheet &sensor = plan.sensor;
    m_terms->setName(0, tr("Smallest rate step, ΔE<sub>S</sub>"));
    m_terms->setValue(0, withUnit(sensor.sensitivityMdps, 2, tr("mdps")));
    m_terms->setName(1, tr("Bias with T, γ′ = %1 × %2/%3")
                            .arg(numberText(sensor.zeroRateChangeMdpsPerC, 0), numberText(sensor.rangeDps, 0),
                                 QString::number(sensor.zeroRateChangeRangeDps)));
    m_terms->setValue(1, withUnit(interval->zeroRateMdpsPerC, 2, tr("mdps/°C")));
    m_terms->setName(2, tr("Sensitivity with T, β"));
    m_terms->setValue(2, withUnit(interval->sensitivityMdpsPerC, 2, tr("mdps/°C")));
    m_ratio->setName(0, tr("ΔE<sub>S</sub> / (γ′ + β)"));
    const QString longest = withUnit(interval->longestC, 4, tr("°C"));
    m_ratio->setValue(0, longest);
    m_used->setText(withUnit(plan.stepC, 2, tr("°C")));
    const bool fits = plan.stepC <= interval->longestC;
    m_verdict->setState(fits ? Tone::Good : Tone::Caution,
                        fits ? tr("used, not above %1").arg(longest) : tr("used, but above %1").arg(longest));
    m_remark->setText(
        tr("The paper prints β with the span squared, which gives %1 mdps/°C. Half the span gives "
           "the value it uses, %2.")
            .arg(numberText(interval->printedSensitivityMdpsPerC, 0),
                 numberText(interval->sensitivityMdpsPerC, 2)));
}

PeriodPanel::PeriodPanel(QWidget *parent)
    : Panel(parent), m_terms(new ReadoutGrid), m_transient(new TransientView(lookOf(palette())))
{
    for (int row = 0; row < 3; ++row)
        m_terms->addRow({});
    rows()->addWidget(m_terms);
    rows()->setContentsMargins(12, 8, 0, 0);
    m_terms->setContentsMargins(0, 0, 12, 0);
    rows()->addWidget(m_transient, 1);
    m_transient->followTheme();
}

void PeriodPanel::setPlan(const TestPlan &plan)
{
    const auto period = controlPeriod(plan.chamber, plan.lowestC, plan.highestC);
    const auto transient = ChamberTransient::create(plan.chamber);
    setEnabled(period.ok() && transient.ok());
    if (!period || !transient) {
        m_transient->setData(std::nullopt);
        return;
    }
    const auto seconds = [](const std::optional<double> &value, int decimals) {
        return value ? withUnit(*value, decimals, tr("s")) : tr("none");
    };
    m_terms->setName(0, tr("As printed (kJ, °C)"));
    m_terms->setValue(0, seconds(period->printedS, 3));
    m_terms->setName(1, tr("In SI, °C; in SI, kelvin"));
    m_terms->setValue(1, tr("%1; %2").arg(seconds(period->celsiusS, 0), seconds(period->kelvinS, 0)));
    m_terms->setName(2, tr("Slowest mode of a %1 m cube, still air").arg(numberText(plan.chamber.edgeM, 2)));
    m_terms->setValue(2, seconds(transient->slowestModeS(), 0));
    m_transient->setData(TransientData{*transient, plan.stepC, plan.chamber.thermometerAccuracyC});
}

} // namespace driftbench
