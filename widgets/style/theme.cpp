#include "widgets/style/theme.h"

#include "widgets/style/fonts.h"
#include "widgets/style/workbench_style.h"

#include <QApplication>
#include <QToolTip>

namespace driftbench {

static bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Active, QPalette::Window).lightness() <
           palette.color(QPalette::Active, QPalette::WindowText).lightness();
}

const Palette &lookOf(const QPalette &palette)
{
    return isDark(palette) ? darkPalette() : lightPalette();
}

Theme::Theme(QObject *parent) : QObject(parent), m_systemDark(isDark(QGuiApplication::palette()))
{
    QApplication::setStyle(new WorkbenchStyle);
    QApplication::setFont(bodyFont());
    QToolTip::setFont(noteFont());
    apply();
}

const Palette &Theme::palette() const
{
    const bool dark = m_mode == ThemeMode::System ? m_systemDark : m_mode == ThemeMode::Dark;
    return dark ? darkPalette() : lightPalette();
}

void Theme::setMode(ThemeMode mode)
{
    if (mode == m_mode)
        return;
    const Palette *before = &palette();
    m_mode = mode;
    if (&palette() != before)
        apply();
}

void Theme::setSystemDark(bool dark)
{
    if (dark == m_systemDark)
        return;
    const Palette *before = &palette();
    m_systemDark = dark;
    if (&palette() != before)
        apply();
}

void Theme::apply()
{
    const QPalette all = qtPalette(palette());
    QApplication::setPalette(all);
    QToolTip::setPalette(all);
    emit changed(palette());
}

} // namespace driftbench
