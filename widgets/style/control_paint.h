// How controls are painted, shared by the style and by the controls that paint themselves: flat fills,
// borders of one pixel, corners of four, and where the focus is a border of two pixels in the accent.
#pragma once

#include "widgets/style/palette.h"

#include <QRect>

class QPainter;

namespace driftbench {

inline constexpr int kCornerRadius = 4;
inline constexpr int kControlHeight = 24; // form fields, small buttons
inline constexpr int kHeadHeight = 32;    // controls in the head of a page
inline constexpr int kGap = 8;            // between blocks, downwards
inline constexpr int kWideGap = 16;       // between blocks, across
inline constexpr int kLabelGap = 12;      // from a label to its field

struct BoxPaint
{
    QColor fill;
    QColor border;
    int borderWidth = 1;
};

void paintBox(QPainter &painter, const QRect &rect, const BoxPaint &box, int radius = kCornerRadius);

struct ControlState
{
    bool enabled = true;
    bool focused = false;
    bool hovered = false;
    bool pressed = false;
    bool checked = false;
    bool primary = false;
    bool invalid = false;
};

BoxPaint buttonBox(const Palette &look, const ControlState &state);
QColor buttonTextColor(const Palette &look, const ControlState &state);
BoxPaint fieldBox(const Palette &look, const ControlState &state);

// A check mark, a chevron, a pair of arrows, in a rectangle.
void paintCheckMark(QPainter &painter, const QRect &rect, const QColor &color);
void paintChevron(QPainter &painter, const QRect &rect, const QColor &color);
void paintArrow(QPainter &painter, const QRect &rect, bool up, const QColor &color);

} // namespace driftbench
