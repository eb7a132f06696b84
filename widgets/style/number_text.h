// Numbers as people read them: a real minus sign (U+2212), a thin space (U+2009) between thousands, the
// decimal mark of the locale. Values that are not finite read "–".
#pragma once

#include <QLocale>
#include <QString>

namespace driftbench {

inline constexpr QChar kMinus(0x2212);
inline constexpr QChar kThinSpace(0x2009);
inline constexpr double kMdpsPerDps = 1000.0;

QString numberText(double value, int decimals, const QLocale &locale = QLocale());

// A sampling rate that is measured, in Hz: with tenths as long as it has three figures before them or less.
QString samplingRateText(double rateHz, const QLocale &locale = QLocale());

// The decimals that give a number of this size three figures, at most `most`.
int decimalsForThreeFigures(double value, int most = 4);

// An Allan deviation: two figures that count, at least two decimals.
QString deviationText(double deviationDps);

QString raisedText(int exponent); // "⁻²⁸"

// A power of ten as an axis labels it: 0.001 to 1 000 in full, beyond as 10 with a raised exponent.
QString decadeText(int exponent, const QLocale &locale = QLocale());

// A number too large or too small for plain figures: "2.5×10⁷".
QString powerText(double value, int decimals, const QLocale &locale = QLocale());

QString hourMinuteText(double hours); // "2:05", "−0:30"
QString clockText(double seconds);    // "2:24:10", "−0:00:30"; what is left of a second is left out

} // namespace driftbench
