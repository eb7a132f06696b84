#include "app/gui/export/device_words.h"

#include "app/gui/export/device_panel.h"
#include "app/gui/train/model_words.h"
#include "widgets/style/number_text.h"

#include <cmath>

namespace driftbench {

QString bankName(std::uint8_t bank)
{
    return QString(QChar(u'A' + bank));
}

QString crcText(std::uint32_t crc)
{
    return QStringLiteral("%1").arg(crc, 8, 16, QLatin1Char('0')).toUpper();
}

QString checkText(const TableUploadReport &report)
{
    if (!report.check)
        return DevicePanel::tr("Read back and verified. This device can't show its compensation at work.");
    const CompensationCheck &check = *report.check;
    if (report.rolledBack)
        return DevicePanel::tr(
                   "Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.")
            .arg(check.differing)
            .arg(check.samples)
            .arg(numberText(check.worstDps, 4));
    return DevicePanel::tr(
        "Verified at work: %n sample(s) compared with what the host computes, none differs.", nullptr,
        check.samples);
}

QString deviceModelName(std::string_view name, const TrainedModel *model)
{
    return name == "auto" ? DevicePanel::tr("recommended") : modelTitle(name, model);
}

QString sensorText(const SensorIdentity &sensor)
{
    return QString::fromStdString(sensor.serial.empty() ? sensor.text() : sensor.serial);
}

QString rangeText(const CompensationTable &table)
{
    const auto text = [](double temperatureC) {
        return numberText(temperatureC, std::abs(temperatureC - std::round(temperatureC)) < 0.05 ? 0 : 1);
    };
    return DevicePanel::tr("%1 to %2 °C, %3")
        .arg(text(table.firstTemperatureC()), text(table.lastTemperatureC()))
        .arg(table.size());
}

QString kindText(DeviceTableKind kind)
{
    return kind == DeviceTableKind::FixedPoint ? DevicePanel::tr("fixed point") : DevicePanel::tr("float32");
}

QString thermometerText(DeviceThermometer thermometer)
{
    return thermometer == DeviceThermometer::Die ? DevicePanel::tr("on the die")
                                                 : DevicePanel::tr("external");
}

} // namespace driftbench
