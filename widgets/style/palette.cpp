#include "widgets/style/palette.h"

namespace driftbench {

static Palette makeLight()
{
    Palette p;
    p.window = QColor(QRgb(0xECEEF1));
    p.page = QColor(QRgb(0xF6F7F9));
    p.base = QColor(QRgb(0xFFFFFF));
    p.header = QColor(QRgb(0xF8F9FB));
    p.button = QColor(QRgb(0xFDFDFE));
    p.border = QColor(QRgb(0xCFD5DC));
    p.grid = QColor(QRgb(0xE5E8EC));
    p.axisLine = QColor(QRgb(0x7C8794));
    p.text = QColor(QRgb(0x17202A));
    p.mutedText = QColor(QRgb(0x55616E));
    p.disabledText = QColor(QRgb(0x929CA7));
    p.accent = QColor(QRgb(0x0B4F94));
    p.textOnAccent = QColor(QRgb(0xFFFFFF));
    p.selection = QColor(QRgb(0xE2ECF7));
    p.infoFill = QColor(QRgb(0xE8F0F9));
    p.raw = QColor(QRgb(0xBF7A00));
    p.rawRange = QColor(QRgb(0xF7EAD3));
    p.compensated = QColor(QRgb(0x0B4F94));
    p.compensatedRange = QColor(QRgb(0xB9D0E8));
    p.bpNetwork = QColor(QRgb(0x1A9C82));
    p.cubic = QColor(QRgb(0xA3295F));
    p.line = QColor(QRgb(0x9479C2));
    p.constant = QColor(QRgb(0x66717D));
    p.heating = QColor(QRgb(0xB5330F));
    p.cooling = QColor(QRgb(0x2F93D1));
    p.excluded = QColor(QRgb(0xB4BCC5));
    p.good = QColor(QRgb(0x1B7340));
    p.goodFill = QColor(QRgb(0xE6F3EB));
    p.caution = QColor(QRgb(0x8A5A00));
    p.cautionEdge = QColor(QRgb(0xD39A1A));
    p.cautionFill = QColor(QRgb(0xFFF5DE));
    p.bad = QColor(QRgb(0xB3261E));
    p.badFill = QColor(QRgb(0xFBEAE8));
    return p;
}

static Palette makeDark()
{
    Palette p;
    p.dark = true;
    p.window = QColor(QRgb(0x161A20));
    p.page = QColor(QRgb(0x1B2027));
    p.base = QColor(QRgb(0x12161B));
    p.header = QColor(QRgb(0x161B21));
    p.button = QColor(QRgb(0x252C35));
    p.border = QColor(QRgb(0x343C46));
    p.grid = QColor(QRgb(0x242B33));
    p.axisLine = QColor(QRgb(0x75818E));
    p.text = QColor(QRgb(0xE6EAEF));
    p.mutedText = QColor(QRgb(0xA3AEBA));
    p.disabledText = QColor(QRgb(0x66717D));
    p.accent = QColor(QRgb(0x93CBFF));
    p.textOnAccent = QColor(QRgb(0x0E1319));
    p.selection = QColor(QRgb(0x22344A));
    p.infoFill = QColor(QRgb(0x1B2B3D));
    p.raw = QColor(QRgb(0xC48A2E));
    p.rawRange = QColor(QRgb(0x3A2F1C));
    p.compensated = QColor(QRgb(0x93CBFF));
    p.compensatedRange = QColor(QRgb(0x31506F));
    p.bpNetwork = QColor(QRgb(0x67D6B5));
    p.cubic = QColor(QRgb(0xD6639B));
    p.line = QColor(QRgb(0x9C86D9));
    p.constant = QColor(QRgb(0x8A95A1));
    p.heating = QColor(QRgb(0xF0764A));
    p.cooling = QColor(QRgb(0x7CC4F4));
    p.excluded = QColor(QRgb(0x4C5661));
    p.good = QColor(QRgb(0x6CCB93));
    p.goodFill = QColor(QRgb(0x17301F));
    p.caution = QColor(QRgb(0xE7B54A));
    p.cautionEdge = QColor(QRgb(0xB98A2B));
    p.cautionFill = QColor(QRgb(0x322A16));
    p.bad = QColor(QRgb(0xFF8F86));
    p.badFill = QColor(QRgb(0x391E1C));
    return p;
}

const Palette &lightPalette()
{
    static const Palette palette = makeLight();
    return palette;
}

const Palette &darkPalette()
{
    static const Palette palette = makeDark();
    return palette;
}

QPalette qtPalette(const Palette &palette)
{
    QPalette p;
    p.setColor(QPalette::Window, palette.page);
    p.setColor(QPalette::WindowText, palette.text);
    p.setColor(QPalette::Base, palette.base);
    p.setColor(QPalette::AlternateBase, palette.header);
    p.setColor(QPalette::Text, palette.text);
    p.setColor(QPalette::PlaceholderText, palette.mutedText);
    p.setColor(QPalette::Button, palette.button);
    p.setColor(QPalette::ButtonText, palette.text);
    p.setColor(QPalette::BrightText, palette.bad);
    p.setColor(QPalette::Highlight, palette.accent);
    p.setColor(QPalette::HighlightedText, palette.textOnAccent);
    p.setColor(QPalette::Link, palette.accent);
    p.setColor(QPalette::Mid, palette.border);
    p.setColor(QPalette::ToolTipBase, palette.base);
    p.setColor(QPalette::ToolTipText, palette.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, palette.disabledText);
    return p;
}

} // namespace driftbench
