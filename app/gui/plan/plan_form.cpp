#include "app/gui/plan/plan_form.h"

#include "engine/physics/control_figures.h"
#include "widgets/controls/duration_field.h"
#include "widgets/controls/form_rows.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/section_head.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include <cmath>

namespace driftbench {

static constexpr int kLabelWidth = 112;
static constexpr int kSpanGap = 8;
static constexpr double kRangesDps[] = {245.0, 500.0, 2000.0};

PlanForm::PlanForm(QWidget *parent) : QWidget(parent), m_rows(new FormRows(kLabelWidth, this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows);
    layout->addStretch(1);
    buildSensor();
    buildChamber();
    buildProfile();
    retranslate();
}

// Every change of a field is an edit, but not while the form itself fills them.
template <class Field>
void PlanForm::watch(Field *field)
{
    connect(field, QOverload<double>::of(&Field::valueChanged), this, [this] {
        if (!m_filling)
            emit edited();
    });
}

void PlanForm::buildSensor()
{
    m_sensorHead = new SectionHead;
    m_rows->addWide(m_sensorHead);
    m_sensor = new QComboBox;
    for (const std::string_view name : kSensorNames)
        m_sensor->addItem(QString::fromUtf8(name.data()), QString::fromUtf8(name.data()));
    m_sensor->addItem(QString());
    m_sensorRow = m_rows->addRow({}, m_sensor);
    m_range = new QComboBox;
    for (const double range : kRangesDps)
        m_range->addItem(QString(), range);
    m_rangeRow = m_rows->addRow({}, m_range);
    m_sensitivity = new NumberField({}, tr("mdps/LSB"), 2, 0.01, 1000.0, 0.25);
    m_sensitivity->setArrows(false);
    m_sensitivityRow = m_rows->addRow({}, m_sensitivity);
    m_zeroRate = new NumberField({}, tr("dps/°C"), 3, 0.0, 10.0, 0.01);
    m_zeroRate->setArrows(false);
    m_zeroRateRow = m_rows->addRow({}, m_zeroRate);
    connect(m_sensor, &QComboBox::activated, this, &PlanForm::takeSensorPreset);
    connect(m_range, &QComboBox::activated, this, &PlanForm::takeRange);
    watch(m_sensitivity);
    watch(m_zeroRate);
}

void PlanForm::buildChamber()
{
    m_chamberHead = new SectionHead;
    m_rows->addWide(m_chamberHead);
    m_chamber = new QComboBox;
    for (const std::string_view name : kChamberNames)
        m_chamber->addItem(QString::fromUtf8(name.data()), QString::fromUtf8(name.data()));
    m_chamber->addItem(QString());
    m_chamberRow = m_rows->addRow({}, m_chamber);
    m_edge = new NumberField({}, tr("m"), 2, 0.05, 5.0, 0.05);
    m_edgeRow = m_rows->addRow({}, m_edge);
    m_thermometer = new NumberField({}, tr("°C"), 2, 0.01, 5.0, 0.01);
    m_thermometer->setMark(QStringLiteral("±"));
    m_thermometerRow = m_rows->addRow({}, m_thermometer);
    connect(m_chamber, &QComboBox::activated, this, &PlanForm::takeChamberPreset);
    watch(m_edge);
    watch(m_thermometer);
}

void PlanForm::buildProfile()
{
    m_profileHead = new SectionHead;
    m_rows->addWide(m_profileHead);
    auto *span = new QWidget;
    auto *columns = new QHBoxLayout(span);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kSpanGap);
    m_lowest = new NumberField({}, tr("°C"), 1, -200.0, 400.0, 5.0);
    m_highest = new NumberField({}, tr("°C"), 1, -200.0, 400.0, 5.0);
    for (NumberField *field : {m_lowest, m_highest}) {
        field->setArrows(false);
        field->setMinimumWidth(64);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        columns->addWidget(field, 1);
    }
    m_spanRow = m_rows->addRow({}, span);
    m_step = new NumberField({}, tr("°C"), 2, 0.01, 50.0, 0.1);
    m_stepRow = m_rows->addRow({}, m_step);
    m_period = new NumberField({}, tr("s"), 0, 1.0, 86400.0, 10.0);
    m_periodRow = m_rows->addRow({}, m_period);
    m_hold = new DurationField({}, 0.0, 7.0 * 86400.0, 300.0);
    m_holdRow = m_rows->addRow({}, m_hold);
    m_runs = new NumberField({}, QString(), 0, 1.0, 100.0, 1.0);
    m_runsRow = m_rows->addRow({}, m_runs);
    m_cycle = new QCheckBox;
    m_rows->addWide(m_cycle);
    for (NumberField *field : {m_lowest, m_highest, m_step, m_period, m_runs})
        watch(field);
    watch(m_hold);
    connect(m_cycle, &QCheckBox::toggled, this, [this] {
        if (!m_filling)
            emit edited();
    });
}

void PlanForm::retranslate()
{
    m_sensorHead->setTitle(tr("Sensor"));
    m_chamberHead->setTitle(tr("Chamber"));
    m_profileHead->setTitle(tr("Profile"));
    const auto label = [this](int row, QWidget *field, const QString &text) {
        m_rows->setLabel(row, text);
        field->setAccessibleName(text);
    };
    label(m_sensorRow, m_sensor, tr("Preset"));
    label(m_rangeRow, m_range, tr("Range"));
    label(m_sensitivityRow, m_sensitivity, tr("Sensitivity"));
    label(m_zeroRateRow, m_zeroRate, tr("Bias with T"));
    label(m_chamberRow, m_chamber, tr("Preset"));
    label(m_edgeRow, m_edge, tr("Inner length"));
    label(m_thermometerRow, m_thermometer, tr("Thermometer"));
    label(m_spanRow, m_lowest, tr("From, to"));
    m_lowest->setAccessibleName(tr("Lowest temperature"));
    m_highest->setAccessibleName(tr("Highest temperature"));
    label(m_stepRow, m_step, tr("Step"));
    label(m_periodRow, m_period, tr("Every"));
    label(m_holdRow, m_hold, tr("Hold at the ends"));
    label(m_runsRow, m_runs, tr("Runs"));
    m_cycle->setText(tr("Come back down, to see hysteresis"));
    m_sensor->setItemText(m_sensor->count() - 1, tr("Own figures"));
    m_chamber->setItemText(m_chamber->count() - 1, tr("Own figures"));
    for (int i = 0; i < m_range->count(); ++i)
        m_range->setItemText(i, tr("%1 dps").arg(m_range->itemData(i).toInt()));
    m_sensor->setAccessibleName(tr("Sensor preset"));
    m_chamber->setAccessibleName(tr("Chamber preset"));
}

TestPlan PlanForm::plan() const
{
    TestPlan plan = m_plan;
    plan.sensor.sensitivityMdps = m_sensitivity->value();
    plan.sensor.zeroRateChangeMdpsPerC = 1000.0 * m_zeroRate->value();
    plan.chamber.edgeM = m_edge->value();
    plan.chamber.thermometerAccuracyC = m_thermometer->value();
    plan.lowestC = m_lowest->value();
    plan.highestC = m_highest->value();
    plan.stepC = m_step->value();
    plan.periodS = m_period->value();
    plan.holdS = m_hold->valueS();
    plan.runs = static_cast<int>(std::lround(m_runs->value()));
    // A plan that cools down only stays one: it has no box of its own.
    if (m_cycle->isChecked())
        plan.kind = PlanKind::Cycle;
    else if (plan.kind == PlanKind::Cycle)
        plan.kind = PlanKind::Heating;
    if (plan.kind != PlanKind::Cycle)
        plan.cycles = 1;
    return plan;
}

void PlanForm::setPlan(const TestPlan &plan)
{
    m_plan = plan;
    fillFields();
}

static bool sameFigures(const SensorDatasheet &a, const SensorDatasheet &b)
{
    return a.zeroRateChangeMdpsPerC == b.zeroRateChangeMdpsPerC &&
           std::abs(a.sensitivityMdps * b.rangeDps - b.sensitivityMdps * a.rangeDps) <
               0.02 * a.sensitivityMdps * b.rangeDps;
}

// The preset whose figures these are, or the last entry.
static int presetIndex(const QComboBox &box, const std::string &model, bool same)
{
    const int found = box.findData(QString::fromStdString(model));
    return same && found >= 0 ? found : box.count() - 1;
}

void PlanForm::fillFields()
{
    m_filling = true;
    const auto sensor = namedSensor(m_plan.sensor.model);
    m_sensor->setCurrentIndex(
        presetIndex(*m_sensor, m_plan.sensor.model, sensor && sameFigures(m_plan.sensor, *sensor)));
    const int range = m_range->findData(m_plan.sensor.rangeDps);
    m_range->setCurrentIndex(range < 0 ? 0 : range);
    m_sensitivity->setValue(m_plan.sensor.sensitivityMdps);
    m_zeroRate->setValue(m_plan.sensor.zeroRateChangeMdpsPerC / 1000.0);
    const auto chamber = namedChamber(m_plan.chamber.model);
    m_chamber->setCurrentIndex(
        presetIndex(*m_chamber, m_plan.chamber.model,
                    chamber && chamber->edgeM == m_plan.chamber.edgeM &&
                        chamber->thermometerAccuracyC == m_plan.chamber.thermometerAccuracyC));
    m_edge->setValue(m_plan.chamber.edgeM);
    m_thermometer->setValue(m_plan.chamber.thermometerAccuracyC);
    m_lowest->setValue(m_plan.lowestC);
    m_highest->setValue(m_plan.highestC);
    m_step->setValue(m_plan.stepC);
    m_period->setValue(m_plan.periodS);
    m_hold->setValueS(m_plan.holdS);
    m_runs->setValue(m_plan.runs);
    m_cycle->setChecked(m_plan.kind == PlanKind::Cycle);
    m_filling = false;
}

void PlanForm::takeSensorPreset()
{
    const auto sensor = namedSensor(m_sensor->currentData().toString().toStdString());
    if (!sensor)
        return; // "Own figures": those that stand there
    const TestPlan before = plan();
    // Step and period follow the new sensor, what the user said of runs and sampling stays.
    if (auto made = makeTestPlan(*sensor, before.chamber)) {
        made->kind = before.kind;
        made->holdS = before.holdS;
        made->runs = before.runs;
        made->cycles = before.cycles;
        made->sampleRateHz = before.sampleRateHz;
        setPlan(*made);
        emit edited();
    }
}

void PlanForm::takeRange()
{
    TestPlan changed = plan();
    const double range = m_range->currentData().toDouble();
    const auto sensor = namedSensor(changed.sensor.model);
    // 8.75, 17.5 and 70 mdps a count: in proportion to the nominal ranges of 250, 500 and 2 000 dps.
    const auto nominal = [](double dps) { return dps == 245.0 ? 250.0 : dps; };
    if (sensor)
        changed.sensor.sensitivityMdps = sensor->sensitivityMdps * nominal(range) / nominal(sensor->rangeDps);
    changed.sensor.rangeDps = range;
    setPlan(changed);
    emit edited();
}

void PlanForm::takeChamberPreset()
{
    const auto chamber = namedChamber(m_chamber->currentData().toString().toStdString());
    if (!chamber)
        return;
    TestPlan changed = plan();
    changed.chamber = *chamber;
    setPlan(changed);
    emit edited();
}

void PlanForm::showError(const Status &checked)
{
    const QString sentence = checked ? QString() : QString::fromStdString(checked.error().message);
    const bool order = m_lowest->value() >= m_highest->value();
    const bool step = !order && m_step->value() > m_highest->value() - m_lowest->value();
    m_rows->setError(m_spanRow, order ? sentence : QString());
    m_rows->setError(m_stepRow, step ? sentence : QString());
    m_rows->setError(m_runsRow, order || step ? QString() : sentence);
    m_lowest->setError(order ? sentence : QString());
    m_highest->setError(order ? sentence : QString());
}

} // namespace driftbench
