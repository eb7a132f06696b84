#include "app/gui/export/device_words.h"

#include "app/gui/export/device_panel.h"
#include "widgets/style/number_text.h"

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

QString rangeText(const CompensationTable &table)
{
    return DevicePanel::tr("%1 to %2 °C, %3 rows")
        .arg(numberText(table.firstTemperatureC(), 1), numberText(table.lastTemperatureC(), 1))
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
