#include "app/gui/source/bridge_forms.h"

#include "widgets/controls/form_rows.h"
#include "widgets/controls/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kRangeChoicesDps[] = {0, 245, 500, 2000};
static constexpr int kBusSpeedsKHz[] = {400, 100};
static constexpr double kHighestNativeHz = 10000.0;
static constexpr double kHighestI2cHz = 800.0;

static FormRows *placeRows(QWidget &form)
{
    auto *rows = new FormRows(kFormLabelWidth, &form);
    auto *layout = new QVBoxLayout(&form);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(rows);
    layout->addStretch(1);
    return rows;
}

static QComboBox *makeRanges()
{
    auto *box = new QComboBox;
    for (const int range : kRangeChoicesDps)
        box->addItem(QString(), range);
    return box;
}

static void nameRanges(QComboBox &box)
{
    for (int i = 0; i < box.count(); ++i) {
        const int range = box.itemData(i).toInt();
        box.setItemText(i, range == 0 ? NativeForm::tr("As it is set") : NativeForm::tr("%1 dps").arg(range));
    }
}

// 0 stands for "as it is set".
static NumberField *makeRate(double highestHz)
{
    auto *field = new NumberField({}, NativeForm::tr("Hz"), 0, 0.0, highestHz, 10.0);
    return field;
}

NativeForm::NativeForm(QWidget *parent)
    : ChoiceForm(parent)
    , m_rows(placeRows(*this))
    , m_rate(makeRate(kHighestNativeHz))
    , m_range(makeRanges())
    , m_thermometer(new QComboBox)
    , m_compensate(new QCheckBox)
{
    for (int i = 0; i < 3; ++i)
        m_thermometer->addItem(QString());
    m_rows->addRow({}, m_rate);
    m_rows->addRow({}, m_range);
    m_rows->addRow({}, m_thermometer);
    m_rows->addWide(m_compensate);
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &ChoiceForm::edited);
    connect(m_range, &QComboBox::currentIndexChanged, this, &ChoiceForm::edited);
    connect(m_thermometer, &QComboBox::currentIndexChanged, this, &ChoiceForm::edited);
    connect(m_compensate, &QCheckBox::toggled, this, &ChoiceForm::edited);
    NativeForm::retranslate();
}

void NativeForm::retranslate()
{
    const QSignalBlocker silent(this);
    m_rows->setLabel(0, tr("Sample rate"));
    m_rate->setAccessibleName(tr("Sample rate"));
    m_rate->setToolTip(tr("0 leaves the rate that the bridge has now."));
    m_rows->setLabel(1, tr("Range"));
    m_range->setAccessibleName(tr("Range"));
    nameRanges(*m_range);
    m_rows->setLabel(2, tr("Thermometer"));
    m_thermometer->setAccessibleName(tr("Thermometer"));
    m_thermometer->setItemText(0, tr("External, else die"));
    m_thermometer->setItemText(1, tr("External"));
    m_thermometer->setItemText(2, tr("On the die"));
    m_compensate->setText(tr("Compensated by its own table"));
    m_compensate->setToolTip(tr("To check a table that was written. A calibration needs raw rates."));
}

void NativeForm::setDevice(const DeviceEntry &device)
{
    if (const auto parsed = parseSourceChoice(device.source)) {
        if (const auto *native = parsed->as<NativeChoice>())
            m_device = *native;
    }
}

SourceChoice NativeForm::choice() const
{
    SourceChoice choice{m_device};
    choice.rateHz = m_rate->value();
    choice.rangeDps = m_range->currentData().toDouble();
    choice.thermometer = static_cast<ThermometerChoice>(std::max(0, m_thermometer->currentIndex()));
    choice.compensate = m_compensate->isChecked();
    return choice;
}

I2cForm::I2cForm(QWidget *parent)
    : ChoiceForm(parent)
    , m_rows(placeRows(*this))
    , m_gyro(new QComboBox)
    , m_address(new QComboBox)
    , m_range(makeRanges())
    , m_thermometer(new QComboBox)
    , m_speed(new QComboBox)
    , m_rate(makeRate(kHighestI2cHz))
    , m_offset(new NumberField({}, tr("°C"), 1, -100.0, 100.0, 1.0))
    , m_serial(new QLineEdit)
{
    for (const char *gyro : {"", "L3GD20H", "I3G4250D"})
        m_gyro->addItem(QString::fromUtf8(gyro), QString::fromUtf8(gyro));
    for (int i = 0; i < 4; ++i)
        m_thermometer->addItem(QString());
    for (const int speed : kBusSpeedsKHz)
        m_speed->addItem(tr("%1 kHz").arg(speed), speed);
    for (QWidget *field : {static_cast<QWidget *>(m_gyro), static_cast<QWidget *>(m_address),
                           static_cast<QWidget *>(m_range), static_cast<QWidget *>(m_rate),
                           static_cast<QWidget *>(m_thermometer), static_cast<QWidget *>(m_offset),
                           static_cast<QWidget *>(m_speed), static_cast<QWidget *>(m_serial)})
        m_rows->addRow({}, field);
    for (QComboBox *box : {m_gyro, m_address, m_range, m_thermometer, m_speed})
        connect(box, &QComboBox::currentIndexChanged, this, &ChoiceForm::edited);
    connect(m_gyro, &QComboBox::currentIndexChanged, this, &I2cForm::offerAddresses);
    for (NumberField *field : {m_rate, m_offset})
        connect(field, &QDoubleSpinBox::valueChanged, this, &ChoiceForm::edited);
    connect(m_serial, &QLineEdit::editingFinished, this, &ChoiceForm::edited);
    offerAddresses();
    retranslate();
}

void I2cForm::offerAddresses()
{
    const QSignalBlocker silent(m_address);
    const QVariant before = m_address->currentData();
    m_address->clear();
    m_address->addItem(tr("Whichever answers"), 0);
    const QString gyro = m_gyro->currentData().toString();
    std::vector<int> addresses;
    if (gyro != QLatin1String("I3G4250D"))
        addresses.insert(addresses.end(), {0x6A, 0x6B});
    if (gyro != QLatin1String("L3GD20H"))
        addresses.insert(addresses.end(), {0x68, 0x69});
    for (const int address : addresses)
        m_address->addItem(QStringLiteral("0x%1").arg(address, 2, 16), address);
    m_address->setCurrentIndex(std::max(0, m_address->findData(before)));
}

void I2cForm::retranslate()
{
    const QSignalBlocker silent(this);
    const QStringList labels{tr("Gyro"),        tr("Address"),    tr("Range"),     tr("Sample rate"),
                             tr("Thermometer"), tr("Die offset"), tr("Bus speed"), tr("Serial number")};
    const std::array<QWidget *, 8> fields{m_gyro,        m_address, m_range, m_rate,
                                          m_thermometer, m_offset,  m_speed, m_serial};
    for (int row = 0; row < labels.size(); ++row) {
        m_rows->setLabel(row, labels[row]);
        fields[static_cast<std::size_t>(row)]->setAccessibleName(labels[row]);
    }
    m_gyro->setItemText(0, tr("Whichever answers"));
    m_address->setItemText(0, tr("Whichever answers"));
    nameRanges(*m_range);
    m_thermometer->setItemText(0, tr("External, else die"));
    m_thermometer->setItemText(1, QStringLiteral("TMP117"));
    m_thermometer->setItemText(2, QStringLiteral("MCP9808"));
    m_thermometer->setItemText(3, tr("On the die"));
    m_rate->setToolTip(tr("0 takes the gyro's usual rate."));
    m_offset->setToolTip(tr("Of the gyro's own thermometer, which only tells differences."));
    m_serial->setPlaceholderText(tr("which gyro it is"));
    m_serial->setToolTip(tr("The gyro can't say it itself; it keeps runs of different gyros apart."));
}

void I2cForm::setDevice(const DeviceEntry &device)
{
    if (const auto parsed = parseSourceChoice(device.source)) {
        if (const auto *i2c = parsed->as<I2cChoice>())
            m_device = *i2c;
    }
}

SourceChoice I2cForm::choice() const
{
    I2cChoice i2c = m_device;
    i2c.gyro = m_gyro->currentData().toString().toStdString();
    i2c.gyroAddress = static_cast<std::uint8_t>(m_address->currentData().toInt());
    i2c.gyroSerial = m_serial->text().trimmed().toStdString();
    i2c.busKHz = m_speed->currentData().toInt();
    i2c.dieOffsetC = m_offset->value();
    SourceChoice choice{i2c};
    choice.rateHz = m_rate->value();
    choice.rangeDps = m_range->currentData().toDouble();
    auto &chosen = *choice.as<I2cChoice>();
    const int thermometer = m_thermometer->currentIndex();
    if (thermometer == 1 || thermometer == 2) {
        chosen.thermometer = thermometer == 1 ? ThermometerModel::Tmp117 : ThermometerModel::Mcp9808;
        choice.thermometer = ThermometerChoice::External;
    } else if (thermometer == 3) {
        choice.thermometer = ThermometerChoice::Die;
    }
    return choice;
}

} // namespace driftbench
