#include "app/gui/source/log_form.h"

#include "engine/exports/device_image_layout.h"
#include "widgets/controls/form_rows.h"
#include "widgets/controls/number_field.h"

#include <QComboBox>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kMostInstances = 6;
static constexpr double kPlaybackSpeeds[] = {1.0, 10.0, 100.0};
static constexpr double kWhole = -1.0;
static constexpr int kMostModelLetters = BRIDGE_MODEL_SIZE;
static constexpr int kMostSerialLetters = BRIDGE_SERIAL_SIZE;

enum Row
{
    kHow,
    kInstance,
    kTimeColumn,
    kTemperatureColumn,
    kRateXColumn,
    kRateYColumn,
    kRateZColumn,
    kTimeUnit,
    kTemperatureUnit,
    kRateUnit,
    kSensitivity,
    kReference,
    kModel,
    kSerial
};

template <class Unit>
static QComboBox *unitBox(std::initializer_list<Unit> units)
{
    auto *box = new QComboBox;
    box->addItem(QString());
    for (const Unit unit : units)
        box->addItem(QString::fromUtf8(unitName(unit).data()), static_cast<int>(unit));
    return box;
}

template <class Unit>
static std::optional<Unit> unitOf(const QComboBox &box)
{
    if (box.currentIndex() <= 0)
        return std::nullopt;
    return static_cast<Unit>(box.currentData().toInt());
}

// As a device's table takes it.
static QLineEdit *identityField(int mostLetters)
{
    auto *field = new QLineEdit;
    field->setMaxLength(mostLetters);
    static const QRegularExpression kLetters(QStringLiteral("[!-~]*"));
    field->setValidator(new QRegularExpressionValidator(kLetters, field));
    return field;
}

LogForm::LogForm(QWidget *parent)
    : ChoiceForm(parent)
    , m_rows(new FormRows(kFormLabelWidth, this))
    , m_how(new QComboBox)
    , m_instance(new QComboBox)
    , m_timeUnit(
          unitBox({TimeUnit::Seconds, TimeUnit::Milliseconds, TimeUnit::Microseconds, TimeUnit::Nanoseconds}))
    , m_rateUnit(unitBox({RateUnit::DegreesPerSecond, RateUnit::RadiansPerSecond,
                          RateUnit::MillidegreesPerSecond, RateUnit::Counts}))
    , m_temperatureUnit(
          unitBox({TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit}))
    , m_sensitivity(new NumberField({}, tr("mdps/LSB"), 3, 0.001, 10000.0, 0.25))
    , m_reference(new RateFields)
    , m_model(identityField(kMostModelLetters))
    , m_serial(identityField(kMostSerialLetters))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows);
    layout->addStretch(1);
    m_how->addItem(QString(), kWhole);
    for (const double speed : kPlaybackSpeeds)
        m_how->addItem(QString(), speed);
    m_instance->addItem(QString());
    for (int i = 0; i < kMostInstances; ++i)
        m_instance->addItem(QString::number(i), i);
    for (QLineEdit *&column : m_columns)
        column = new QLineEdit;
    m_sensitivity->setValue(8.75);
    m_rows->addRow({}, m_how);
    m_rows->addRow({}, m_instance);
    for (QLineEdit *column : m_columns)
        m_rows->addRow({}, column);
    for (QWidget *field : {static_cast<QWidget *>(m_timeUnit), static_cast<QWidget *>(m_temperatureUnit),
                           static_cast<QWidget *>(m_rateUnit), static_cast<QWidget *>(m_sensitivity),
                           static_cast<QWidget *>(m_reference), static_cast<QWidget *>(m_model),
                           static_cast<QWidget *>(m_serial)})
        m_rows->addRow({}, field);
    connect(m_rateUnit, &QComboBox::currentIndexChanged, this, [this] {
        m_rows->setRowVisible(kSensitivity, unitOf<RateUnit>(*m_rateUnit) == RateUnit::Counts);
    });
    connect(m_how, &QComboBox::currentIndexChanged, this, &ChoiceForm::edited);
    m_rows->setRowVisible(kSensitivity, false);
    retranslate();
}

void LogForm::retranslate()
{
    const QStringList labels{tr("How"),      tr("Gyro in the log"), tr("Time column"), tr("T column"),
                             tr("x column"), tr("y column"),        tr("z column"),    tr("Time unit"),
                             tr("T unit"),   tr("Rate unit"),       tr("Sensitivity"), tr("Reference rate"),
                             tr("Sensor"),   tr("Serial number")};
    for (int row = 0; row < labels.size(); ++row)
        m_rows->setLabel(row, labels[row]);
    m_how->setAccessibleName(labels[kHow]);
    m_instance->setAccessibleName(labels[kInstance]);
    m_timeUnit->setAccessibleName(labels[kTimeUnit]);
    m_temperatureUnit->setAccessibleName(labels[kTemperatureUnit]);
    m_rateUnit->setAccessibleName(labels[kRateUnit]);
    m_sensitivity->setAccessibleName(labels[kSensitivity]);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i]->setAccessibleName(labels[kTimeColumn + static_cast<int>(i)]);
        m_columns[i]->setPlaceholderText(tr("found by its name"));
        m_columns[i]->setToolTip(tr("The name in the header, or the number of the column."));
    }
    m_model->setAccessibleName(labels[kModel]);
    m_serial->setAccessibleName(labels[kSerial]);
    for (QLineEdit *field : {m_model, m_serial}) {
        field->setPlaceholderText(tr("as the log says"));
        field->setToolTip(
            tr("Whose log it is: a device takes a table only for itself, and the report names it."));
    }
    m_how->setItemText(0, tr("Read in whole"));
    m_how->setItemText(1, tr("Play back"));
    for (int i = 2; i < m_how->count(); ++i)
        m_how->setItemText(i, tr("Play back, %1 times").arg(m_how->itemData(i).toInt()));
    m_instance->setItemText(0, tr("The only one"));
    for (QComboBox *box : {m_timeUnit, m_temperatureUnit, m_rateUnit})
        box->setItemText(0, tr("As the log says"));
    m_reference->retranslate();
}

void LogForm::setLog(const FileSurvey &survey)
{
    const bool other = survey.path != m_log.path;
    m_log = survey;
    const bool isCsv = survey.format == QLatin1String("CSV") || survey.format.isEmpty();
    m_rows->setRowVisible(kInstance, !isCsv);
    for (int row = kTimeColumn; row <= kRateUnit; ++row)
        m_rows->setRowVisible(row, isCsv);
    m_rows->setRowVisible(kSensitivity, isCsv && unitOf<RateUnit>(*m_rateUnit) == RateUnit::Counts);
    if (other) {
        m_instance->setCurrentIndex(0);
        for (QLineEdit *column : m_columns)
            column->clear();
    }
    if (other && survey.instance)
        m_instance->setCurrentIndex(std::max(0, m_instance->findData(*survey.instance)));
}

bool LogForm::isPlayedBack() const
{
    return m_how->currentData().toDouble() != kWhole;
}

ReadOptions LogForm::readOptions() const
{
    ReadOptions read;
    if (m_instance->currentIndex() > 0 && m_instance->isVisibleTo(this))
        read.instance = m_instance->currentData().toInt();
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        read.csv.columns[i] = m_columns[i]->text().trimmed().toStdString();
    read.csv.timeUnit = unitOf<TimeUnit>(*m_timeUnit);
    read.csv.rateUnit = unitOf<RateUnit>(*m_rateUnit);
    read.csv.temperatureUnit = unitOf<TemperatureUnit>(*m_temperatureUnit);
    if (read.csv.rateUnit == RateUnit::Counts)
        read.csv.sensitivityMdpsPerCount = m_sensitivity->value();
    return read;
}

LoadInput LogForm::loadInput() const
{
    LoadInput input;
    input.read = readOptions();
    input.referenceRateDps = m_reference->rateDps();
    input.sensor = {m_model->text().toStdString(), m_serial->text().toStdString()};
    return input;
}

SourceChoice LogForm::choice() const
{
    FileChoice file{m_log.path};
    file.speed = std::max(0.0, m_how->currentData().toDouble());
    file.read = readOptions();
    return SourceChoice{file};
}

} // namespace driftbench
