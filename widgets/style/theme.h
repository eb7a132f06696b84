// Light or dark, for the whole application at run time: the style, the QPalette and the body font. Whoever
// paints by role asks lookOf() with its own QPalette, so that a change of theme reaches it as PaletteChange
// and nobody keeps colours of its own.
#pragma once

#include "widgets/style/palette.h"

#include <QObject>

namespace driftbench {

enum class ThemeMode
{
    System, // as the desktop has it
    Light,
    Dark
};

// The palette of roles that a widget's QPalette was made from.
const Palette &lookOf(const QPalette &palette);

class Theme : public QObject
{
    Q_OBJECT

public:
    explicit Theme(QObject *parent = nullptr); // after the QApplication, before its first window

    ThemeMode mode() const { return m_mode; }
    const Palette &palette() const;

    void setMode(ThemeMode mode);
    void setSystemDark(bool dark); // as the desktop says; seen by ThemeMode::System
    bool isSystemDark() const { return m_systemDark; }

signals:
    void changed(const Palette &palette);

private:
    void apply();

    ThemeMode m_mode = ThemeMode::System;
    bool m_systemDark = false;
};

} // namespace driftbench
