#include "support/test_data.h"
#include "widgets/controls/icon.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"
#include "widgets/style/palette.h"
#include "widgets/style/role_pens.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace driftbench;

class TestWidgetsStyle : public QObject
{
    Q_OBJECT

private slots:
    void numberText_data();
    void numberText();
    void numberText_otherLocale_keepsSpaceAndTakesDecimalMark();
    void samplingRateText_aroundAThousand_hasNoTenths();
    void decadeText_plainNearOne_powersBeyond();
    void powerText_roundsUpIntoNextDecade();
    void hourMinuteText_roundsToMinutes();
    void decimalsForThreeFigures_sizes();
    void palette_text_hasContrastOnItsSurfaces();
    void palette_dataLines_haveContrastOnThePlot();
    void roleColor_asInTheStyle_data();
    void roleColor_asInTheStyle();
    void rolePen_models_differByDash();
    void fonts_neverSmallerThanNinePoints();
    void applicationIcon_anySize_isDrawnInItsColours_data();
    void applicationIcon_anySize_isDrawnInItsColours();
};

static constexpr double kLeastForLines = 3.35; // 3.4:1, rounded; the tightest is cooling on white, 3.38

// Relative luminance and contrast as WCAG 2.1 defines them.
static double luminance(const QColor &color)
{
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

static double contrast(const QColor &a, const QColor &b)
{
    const double lighter = std::max(luminance(a), luminance(b));
    const double darker = std::min(luminance(a), luminance(b));
    return (lighter + 0.05) / (darker + 0.05);
}

void TestWidgetsStyle::numberText_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::newRow("plain") << 25.0 << 2 << QStringLiteral("25.00");
    QTest::newRow("minus") << -3.994 << 2 << QStringLiteral("\u22123.99");
    QTest::newRow("no minus zero") << -0.001 << 2 << QStringLiteral("0.00");
    QTest::newRow("thousand") << 1000.0 << 0 << QStringLiteral("1\u2009000");
    QTest::newRow("three digits") << 999.0 << 0 << QStringLiteral("999");
    QTest::newRow("million") << -1234567.25 << 1 << QStringLiteral("\u22121\u2009234\u2009567.2");
    QTest::newRow("nan") << std::numeric_limits<double>::quiet_NaN() << 2 << QStringLiteral("–");
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 2 << QStringLiteral("–");
}

void TestWidgetsStyle::numberText()
{
    QFETCH(double, value);
    QFETCH(int, decimals);
    QTEST(driftbench::numberText(value, decimals, QLocale::c()), "text");
}

void TestWidgetsStyle::samplingRateText_aroundAThousand_hasNoTenths()
{
    const auto text = [](double rateHz) { return driftbench::samplingRateText(rateHz, QLocale::c()); };
    QCOMPARE(text(11.44), QStringLiteral("11.4"));
    QCOMPARE(text(999.94), QStringLiteral("999.9"));
    QCOMPARE(text(999.96), QStringLiteral("1\u2009000"));
    QCOMPARE(text(1000.2), QStringLiteral("1\u2009000"));
}

void TestWidgetsStyle::numberText_otherLocale_keepsSpaceAndTakesDecimalMark()
{
    QCOMPARE(driftbench::numberText(-12345.5, 1, QLocale(QLocale::German)),
             QStringLiteral("\u221212\u2009345,5"));
}

void TestWidgetsStyle::decadeText_plainNearOne_powersBeyond()
{
    const QLocale c = QLocale::c();
    QCOMPARE(decadeText(-3, c), QStringLiteral("0.001"));
    QCOMPARE(decadeText(0, c), QStringLiteral("1"));
    QCOMPARE(decadeText(3, c), QStringLiteral("1\u2009000"));
    QCOMPARE(decadeText(4, c), QStringLiteral("10⁴"));
    QCOMPARE(decadeText(-12, c), QStringLiteral("10⁻¹²"));
}

void TestWidgetsStyle::powerText_roundsUpIntoNextDecade()
{
    QCOMPARE(powerText(2.5e7, 1, QLocale::c()), QStringLiteral("2.5×10⁷"));
    QCOMPARE(powerText(9.99e7, 1, QLocale::c()), QStringLiteral("1.0×10⁸"));
    QCOMPARE(powerText(-3e-9, 1, QLocale::c()), QStringLiteral("\u22123.0×10⁻⁹"));
}

void TestWidgetsStyle::hourMinuteText_roundsToMinutes()
{
    QCOMPARE(hourMinuteText(2.0 + 5.0 / 60.0), QStringLiteral("2:05"));
    QCOMPARE(hourMinuteText(0.99999), QStringLiteral("1:00"));
    QCOMPARE(hourMinuteText(-0.5), QStringLiteral("\u22120:30"));
    QCOMPARE(hourMinuteText(-1e-9), QStringLiteral("0:00"));
}

void TestWidgetsStyle::decimalsForThreeFigures_sizes()
{
    QCOMPARE(decimalsForThreeFigures(123.4), 0);
    QCOMPARE(decimalsForThreeFigures(2.61), 2);
    QCOMPARE(decimalsForThreeFigures(0.0151), 4);
    QCOMPARE(decimalsForThreeFigures(1e-9), 4);
    QCOMPARE(decimalsForThreeFigures(0.0), 2);
}

void TestWidgetsStyle::palette_text_hasContrastOnItsSurfaces()
{
    for (const Palette &p : {lightPalette(), darkPalette()}) {
        const std::vector<QColor> surfaces{p.window, p.page, p.base, p.header, p.button};
        for (const QColor &surface : surfaces) {
            for (const QColor &text : {p.text, p.mutedText, p.accent})
                QVERIFY2(contrast(text, surface) >= 5.0, qPrintable(text.name() + " on " + surface.name()));
        }
        QVERIFY(contrast(p.textOnAccent, p.accent) >= 5.0);
        QVERIFY(contrast(p.good, p.goodFill) >= 5.0);
        QVERIFY(contrast(p.caution, p.cautionFill) >= 5.0);
        QVERIFY(contrast(p.bad, p.badFill) >= 5.0);
        QVERIFY(contrast(p.text, p.infoFill) >= 5.0);
        QVERIFY(contrast(p.compensated, p.base) >= 5.0); // the only colour of data that is used for text
    }
}

void TestWidgetsStyle::palette_dataLines_haveContrastOnThePlot()
{
    for (const Palette &p : {lightPalette(), darkPalette()}) {
        for (const Role role : {Role::Raw, Role::Compensated, Role::BpNetwork, Role::Cubic, Role::Line,
                                Role::Constant, Role::Heating, Role::Cooling})
            QVERIFY2(contrast(roleColor(role, p), p.base) >= kLeastForLines,
                     qPrintable(roleColor(role, p).name()));
        QVERIFY(contrast(p.axisLine, p.base) >= kLeastForLines);
        QVERIFY(std::abs(luminance(p.raw) - luminance(p.compensated)) > 0.1); // part in greyscale
    }
}

void TestWidgetsStyle::roleColor_asInTheStyle_data()
{
    QTest::addColumn<int>("role");
    QTest::addColumn<QString>("light");
    QTest::addColumn<QString>("dark");
    const auto row = [](const char *name, Role role, const char *light, const char *dark) {
        QTest::newRow(name) << static_cast<int>(role) << QString::fromLatin1(light)
                            << QString::fromLatin1(dark);
    };
    row("raw", Role::Raw, "#bf7a00", "#c48a2e");
    row("compensated", Role::Compensated, "#0b4f94", "#93cbff");
    row("bp", Role::BpNetwork, "#1a9c82", "#67d6b5");
    row("cubic", Role::Cubic, "#a3295f", "#d6639b");
    row("line", Role::Line, "#9479c2", "#9c86d9");
    row("constant", Role::Constant, "#66717d", "#8a95a1");
    row("heating", Role::Heating, "#b5330f", "#f0764a");
    row("cooling", Role::Cooling, "#2f93d1", "#7cc4f4");
    row("excluded", Role::Excluded, "#b4bcc5", "#4c5661");
}

void TestWidgetsStyle::roleColor_asInTheStyle()
{
    QFETCH(int, role);
    QTEST(roleColor(static_cast<Role>(role), lightPalette()).name(), "light");
    QTEST(roleColor(static_cast<Role>(role), darkPalette()).name(), "dark");
    QCOMPARE(rolePen(static_cast<Role>(role), lightPalette()).widthF(), 1.0);
}

void TestWidgetsStyle::rolePen_models_differByDash()
{
    QList<QList<qreal>> seen;
    for (const char *model : {"rbf", "bpnn", "cubic", "linear", "constant"}) {
        const auto dashes = rolePen(roleOfModel(model), lightPalette()).dashPattern();
        QVERIFY2(!seen.contains(dashes), model);
        seen.append(dashes);
    }
}

void TestWidgetsStyle::fonts_neverSmallerThanNinePoints()
{
    for (const QFont &font :
         {bodyFont(), sectionFont(), noteFont(), strongNoteFont(), resultFont(), pageTitleFont()})
        QVERIFY(font.pointSize() >= 9);
}

void TestWidgetsStyle::applicationIcon_anySize_isDrawnInItsColours_data()
{
    QTest::addColumn<int>("sizePx");
    for (const int sizePx : {32, 64, 256})
        QTest::addRow("%d px", sizePx) << sizePx;
}

void TestWidgetsStyle::applicationIcon_anySize_isDrawnInItsColours()
{
    QFETCH(int, sizePx);
    const QImage image = applicationIcon().pixmap(QSize(sizePx, sizePx), 1.0).toImage();
    QCOMPARE(image.size(), QSize(sizePx, sizePx));
    const auto colorAt = [&](int x, int y) { // of the drawing's 128 x 128
        return image.pixelColor(x * sizePx / 128, y * sizePx / 128);
    };
    QCOMPARE(colorAt(0, 0).alpha(), 0);
    QCOMPARE(colorAt(64, 34).name(), QStringLiteral("#0b4f94")); // the tile
    QCOMPARE(colorAt(21, 64).name(), QStringLiteral("#ffffff")); // the ring
}

QTEST_MAIN(TestWidgetsStyle)
#include "tst_widgets_style.moc"
