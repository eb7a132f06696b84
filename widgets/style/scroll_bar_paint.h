// Scroll bars of the workbench: a thumb of eight pixels with round ends on the surface it stands on, without
// arrows.
#pragma once

#include "widgets/style/palette.h"

#include <QStyleOptionSlider>

namespace driftbench {

QRect scrollBarPart(const QStyleOptionSlider &bar, QStyle::SubControl part);
void paintScrollBar(QPainter &painter, const QStyleOptionSlider &bar, const Palette &look);

} // namespace driftbench
