#include "widgets/style/field_paint.h"

#include "widgets/style/theme.h"

#include <QAbstractSpinBox>
#include <QPainter>

namespace driftbench {

static constexpr int kArrowColumn = 18; // px, of a spin box

void paintComboBox(QPainter &painter, const QStyleOptionComplex &option, const ControlState &state)
{
    const Palette &look = lookOf(option.palette);
    paintBox(painter, option.rect, fieldBox(look, state));
    QRect chevron = option.rect;
    chevron.setLeft(option.rect.right() - kChevronColumn);
    paintChevron(painter, chevron.translated(-1, 0), state.enabled ? look.mutedText : look.disabledText);
}

void paintSpinBox(QPainter &painter, const QStyleOptionSpinBox &spin, const ControlState &state)
{
    const Palette &look = lookOf(spin.palette);
    paintBox(painter, spin.rect, fieldBox(look, state));
    if (spin.buttonSymbols == QAbstractSpinBox::NoButtons)
        return;
    const auto colorOf = [&](QAbstractSpinBox::StepEnabledFlag step) {
        return spin.stepEnabled & step ? look.mutedText : look.disabledText;
    };
    const QPoint centre(spin.rect.right() - kArrowColumn / 2 - 1, spin.rect.center().y());
    paintArrow(painter, QRect(centre.x() - 5, centre.y() - 6, 10, 5), true,
               colorOf(QAbstractSpinBox::StepUpEnabled));
    paintArrow(painter, QRect(centre.x() - 5, centre.y() + 2, 10, 5), false,
               colorOf(QAbstractSpinBox::StepDownEnabled));
}

QRect comboPart(const QRect &rect, QStyle::SubControl part)
{
    switch (part) {
    case QStyle::SC_ComboBoxEditField:
        return rect.adjusted(6, 1, -kChevronColumn, -1);
    case QStyle::SC_ComboBoxArrow:
        return {rect.right() - kChevronColumn, rect.top(), kChevronColumn, rect.height()};
    default:
        return rect;
    }
}

QRect spinPart(const QStyleOptionSpinBox &spin, QStyle::SubControl part)
{
    const QRect rect = spin.rect;
    const int arrows = spin.buttonSymbols == QAbstractSpinBox::NoButtons ? 0 : kArrowColumn;
    const QRect column(rect.right() + 1 - arrows, rect.top() + 1, arrows, rect.height() - 2);
    switch (part) {
    case QStyle::SC_SpinBoxUp:
        return column.adjusted(0, 0, 0, -column.height() / 2);
    case QStyle::SC_SpinBoxDown:
        return column.adjusted(0, column.height() - column.height() / 2, 0, 0);
    case QStyle::SC_SpinBoxEditField:
        return rect.adjusted(2, 1, -2 - arrows, -1);
    default:
        return rect;
    }
}

} // namespace driftbench
