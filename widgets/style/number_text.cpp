#include "widgets/style/number_text.h"

#include "engine/base/text.h"

#include <cmath>

namespace driftbench {

static constexpr QChar kEnDash(0x2013);

QString numberText(double value, int decimals, const QLocale &locale)
{
    if (!std::isfinite(value))
        return QString(kEnDash);
    QString text = QString::fromStdString(fixed(value, decimals));
    const bool negative = text.startsWith(QLatin1Char('-'));
    if (negative)
        text.remove(0, 1);
    const qsizetype point = text.indexOf(QLatin1Char('.'));
    for (qsizetype at = (point < 0 ? text.size() : point) - 3; at > 0; at -= 3)
        text.insert(at, kThinSpace);
    text.replace(QLatin1Char('.'), locale.decimalPoint());
    return negative ? kMinus + text : text;
}

QString samplingRateText(double rateHz, const QLocale &locale)
{
    // What tenths would round up to 1 000.0 has none.
    return numberText(rateHz, rateHz < 999.95 ? 1 : 0, locale);
}

int decimalsForThreeFigures(double value, int most)
{
    const double size = std::abs(value);
    if (!std::isfinite(size) || size == 0.0)
        return std::min(2, most);
    return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, most);
}

QString raisedText(int exponent)
{
    static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    for (const QChar digit : QString::number(std::abs(exponent)))
        text += kDigits[digit.digitValue()];
    return exponent < 0 ? QStringLiteral("⁻") + text : text;
}

QString deviationText(double deviationDps)
{
    return numberText(deviationDps, std::clamp(decimalsForThreeFigures(deviationDps, 9) - 1, 2, 8));
}

QString decadeText(int exponent, const QLocale &locale)
{
    if (exponent < -3 || exponent > 3)
        return QStringLiteral("10") + raisedText(exponent);
    return numberText(std::pow(10.0, exponent), std::max(0, -exponent), locale);
}

QString powerText(double value, int decimals, const QLocale &locale)
{
    if (value == 0.0 || !std::isfinite(value))
        return numberText(value, 0, locale);
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    double mantissa = value / std::pow(10.0, exponent);
    if (std::abs(mantissa) >= 10.0 - 0.5 * std::pow(10.0, -decimals)) {
        mantissa /= 10.0;
        ++exponent;
    }
    return numberText(mantissa, decimals, locale) + QStringLiteral("×10") + raisedText(exponent);
}

QString hourMinuteText(double hours)
{
    if (!std::isfinite(hours))
        return QString(kEnDash);
    const auto minutes = static_cast<qint64>(std::llround(std::abs(hours) * 60.0));
    const QString text = QStringLiteral("%1:%2").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
    return hours < 0.0 && minutes > 0 ? kMinus + text : text;
}

QString clockText(double seconds)
{
    if (!std::isfinite(seconds))
        return QString(kEnDash);
    const auto whole = static_cast<qint64>(std::abs(seconds) + 1e-6);
    const QString text = QStringLiteral("%1:%2:%3")
                             .arg(whole / 3600)
                             .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
                             .arg(whole % 60, 2, 10, QLatin1Char('0'));
    return seconds < 0.0 && whole > 0 ? kMinus + text : text;
}

} // namespace driftbench
