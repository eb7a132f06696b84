// The colours of the workbench by role, light and dark. Position says the axis, colour says the role: the
// same role has the same colour in every view. Text stands at 5:1 or better on every surface it may stand on,
// lines and dots of data at 3.4:1 (rounded) or better on the plot (WCAG 2 relative luminance); range fills
// and excluded dots are faint on purpose.
#pragma once

#include <QColor>
#include <QPalette>

namespace driftbench {

struct Palette
{
    bool dark = false;

    // Chrome.
    QColor window, page, base, header, button, border, grid, axisLine;
    QColor text, mutedText, disabledText, accent, textOnAccent, selection, infoFill;

    // Data.
    QColor raw, rawRange, compensated, compensatedRange;
    QColor bpNetwork, cubic, line, constant;
    QColor heating, cooling, excluded;

    // State; always with an icon and a word.
    QColor good, goodFill, caution, cautionEdge, cautionFill, bad, badFill;
};

const Palette &lightPalette();
const Palette &darkPalette();

// What Qt's own controls need of it.
QPalette qtPalette(const Palette &palette);

} // namespace driftbench
