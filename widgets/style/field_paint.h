// Combo boxes and spin boxes: a field with a chevron or a pair of arrows at its right.
#pragma once

#include "widgets/style/control_paint.h"

#include <QStyleOptionComplex>
#include <QStyleOptionSpinBox>

namespace driftbench {

inline constexpr int kChevronColumn = 24; // px, of a combo box

void paintComboBox(QPainter &painter, const QStyleOptionComplex &option, const ControlState &state);
void paintSpinBox(QPainter &painter, const QStyleOptionSpinBox &spin, const ControlState &state);
QRect comboPart(const QRect &rect, QStyle::SubControl part);
QRect spinPart(const QStyleOptionSpinBox &spin, QStyle::SubControl part);

} // namespace driftbench
