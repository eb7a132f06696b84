#include "app/gui/source/simulated_form.h"

#include "engine/physics/datasheets.h"
#include "engine/physics/drift_curves.h"
#include "widgets/controls/form_rows.h"
#include "widgets/controls/number_field.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace driftbench {

static constexpr double kHighestRateHz = 10000.0;
static constexpr double kSpeeds[] = {1.0, 10.0, 100.0, 1000.0, 0.0};

static QString driftText(const std::string &drift)
{
    if (drift == "curved")
        return SimulatedForm::tr("Curved");
    if (drift == "steep")
        return SimulatedForm::tr("Steep");
    if (drift == "mild")
        return SimulatedForm::tr("Mild");
    if (drift == "none")
        return SimulatedForm::tr("None");
    return SimulatedForm::tr("Combs");
}

static QString speedText(double speed)
{
    if (speed == 1.0)
        return SimulatedForm::tr("Real time");
    return speed == 0.0 ? SimulatedForm::tr("As fast as it goes") : SimulatedForm::tr("%1 times").arg(speed);
}

SimulatedForm::SimulatedForm(QWidget *parent)
    : ChoiceForm(parent)
    , m_rows(new FormRows(kFormLabelWidth, this))
    , m_sensor(new QComboBox)
    , m_drift(new QComboBox)
    , m_speed(new QComboBox)
    , m_reference(new RateFields)
    , m_rate(new NumberField({}, tr("Hz"), 0, 1.0, kHighestRateHz, 10.0))
    , m_noise(new NumberField({}, tr("dps"), 3, 0.0, 10.0, 0.01))
    , m_spread(new NumberField({}, QStringLiteral("%"), 1, 0.0, 50.0, 0.1))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows);
    layout->addStretch(1);
    for (const auto name : {kSensorNames[1], kSensorNames[0]})
        m_sensor->addItem(QString(), QString::fromUtf8(name.data()));
    for (const std::string_view name : kDriftCurveNames)
        m_drift->addItem(QString(), QString::fromUtf8(name.data()));
    m_drift->addItem(QString(), QString()); // the preset's combs
    for (const double speed : kSpeeds)
        m_speed->addItem(QString(), speed);
    for (QWidget *field :
         {static_cast<QWidget *>(m_sensor), static_cast<QWidget *>(m_drift),
          static_cast<QWidget *>(m_reference), static_cast<QWidget *>(m_rate),
          static_cast<QWidget *>(m_noise), static_cast<QWidget *>(m_spread), static_cast<QWidget *>(m_speed)})
        m_rows->addRow({}, field);
    m_reference->setRateDps({25.0, 5.0, 53.0});
    m_rate->setValue(10.0);
    m_noise->setValue(0.14);
    m_spread->setValue(1.0);
    for (QComboBox *box : {m_sensor, m_drift, m_speed})
        connect(box, &QComboBox::currentIndexChanged, this, &ChoiceForm::edited);
    for (NumberField *field : {m_rate, m_noise, m_spread})
        connect(field, &QDoubleSpinBox::valueChanged, this, &ChoiceForm::edited);
    connect(m_reference, &RateFields::edited, this, &ChoiceForm::edited);
    retranslate();
}

void SimulatedForm::retranslate()
{
    const QStringList labels{tr("Sensor"),      tr("Drift"),      tr("Reference rate"),
                             tr("Sample rate"), tr("Noise, 1 σ"), tr("Run-to-run spread"),
                             tr("Speed")};
    for (int row = 0; row < labels.size(); ++row)
        m_rows->setLabel(row, labels[row]);
    m_sensor->setAccessibleName(labels[0]);
    m_drift->setAccessibleName(labels[1]);
    m_rate->setAccessibleName(labels[3]);
    m_noise->setAccessibleName(labels[4]);
    m_spread->setAccessibleName(labels[5]);
    m_speed->setAccessibleName(labels[6]);
    m_speed->setToolTip(tr("How fast the simulated time passes while a run is recorded."));
    m_drift->setToolTip(
        tr("How the bias follows the temperature; Combs computes it from the comb capacitors."));
    m_reference->retranslate();
    for (int i = 0; i < m_sensor->count(); ++i) {
        const QString model = m_sensor->itemData(i).toString();
        const auto sensor = namedSensor(model.toStdString());
        m_sensor->setItemText(i, tr("%1, %2 dps").arg(model).arg(sensor ? sensor->rangeDps : 0.0));
    }
    for (int i = 0; i < m_drift->count(); ++i)
        m_drift->setItemText(i, driftText(m_drift->itemData(i).toString().toStdString()));
    for (int i = 0; i < m_speed->count(); ++i)
        m_speed->setItemText(i, speedText(m_speed->itemData(i).toDouble()));
}

SourceChoice SimulatedForm::choice() const
{
    SimulatedChoice simulated;
    simulated.sensor = m_sensor->currentData().toString().toStdString();
    simulated.drift = m_drift->currentData().toString().toStdString();
    simulated.referenceRateDps = m_reference->rateDps();
    simulated.noiseDps = m_noise->value();
    simulated.spread = m_spread->value() / 100.0;
    simulated.speed = m_speed->currentData().toDouble();
    SourceChoice choice{simulated};
    choice.rateHz = m_rate->value();
    return choice;
}

void SimulatedForm::setChoice(const SourceChoice &choice)
{
    const auto *simulated = choice.as<SimulatedChoice>();
    if (!simulated)
        return;
    const QSignalBlocker silent(this);
    const auto take = [](QComboBox *box, const QVariant &wanted) {
        if (const int at = box->findData(wanted); at >= 0)
            box->setCurrentIndex(at);
    };
    take(m_sensor, QString::fromStdString(simulated->sensor));
    take(m_drift, QString::fromStdString(simulated->drift));
    take(m_speed, simulated->speed);
    m_reference->setRateDps(simulated->referenceRateDps);
    if (choice.rateHz > 0.0)
        m_rate->setValue(choice.rateHz);
    m_noise->setValue(simulated->noiseDps.value_or(m_noise->value()));
    m_spread->setValue(100.0 * simulated->spread.value_or(m_spread->value() / 100.0));
}

QString SimulatedForm::settingsText() const
{
    return tr("%1, drift: %2").arg(m_sensor->currentText(), m_drift->currentText());
}

} // namespace driftbench
