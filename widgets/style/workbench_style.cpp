#include "widgets/style/workbench_style.h"

#include "widgets/style/control_paint.h"
#include "widgets/style/field_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/scroll_bar_paint.h"
#include "widgets/style/theme.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QPainter>
#include <QSpinBox>
#include <QStyleFactory>
#include <QStyleOption>

namespace driftbench {

static constexpr int kIndicator = 14;
static constexpr int kFieldMargin = 5; // and the two px of QLineEdit itself

static ControlState stateOf(const QStyleOption &option, const QWidget *widget)
{
    ControlState state;
    state.enabled = option.state & QStyle::State_Enabled;
    state.focused = option.state & QStyle::State_HasFocus;
    state.hovered = option.state & QStyle::State_MouseOver;
    state.pressed = option.state & QStyle::State_Sunken;
    state.checked = option.state & QStyle::State_On;
    state.primary = widget && widget->property("primary").toBool();
    state.invalid = widget && widget->property("invalid").toBool();
    return state;
}

WorkbenchStyle::WorkbenchStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

static void drawIndicator(const QStyleOption &option, QPainter &painter, const QWidget *widget, bool round)
{
    const Palette &look = lookOf(option.palette);
    const ControlState state = stateOf(option, widget);
    const QRect box =
        QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, QSize(kIndicator, kIndicator), option.rect);
    const bool on = option.state & (QStyle::State_On | QStyle::State_NoChange);
    BoxPaint paint{on ? look.accent : look.base, on ? look.accent : look.axisLine};
    if (!state.enabled)
        paint = {QColor(), look.border};
    paintBox(painter, box, paint, round ? kIndicator / 2 : 3);
    const QColor mark = state.enabled ? look.textOnAccent : look.disabledText;
    if (option.state & QStyle::State_NoChange)
        painter.fillRect(box.adjusted(4, 6, -4, -6), mark);
    else if (on && round)
        paintBox(painter, box.adjusted(4, 4, -4, -4), {mark, mark}, 3);
    else if (on)
        paintCheckMark(painter, box, mark);
}

static void drawFocus(const QStyleOption &option, QPainter &painter)
{
    paintBox(painter, option.rect, {QColor(), lookOf(option.palette).accent, 2});
}

static void drawItemPanel(const QStyleOption &option, QPainter &painter)
{
    const Palette &look = lookOf(option.palette);
    if (option.state & QStyle::State_Selected)
        painter.fillRect(option.rect, look.selection);
    else if (const auto *item = qstyleoption_cast<const QStyleOptionViewItem *>(&option))
        painter.fillRect(option.rect, item->backgroundBrush);
}

void WorkbenchStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                   const QWidget *widget) const
{
    const Palette &look = lookOf(option->palette);
    switch (element) {
    case PE_PanelButtonCommand:
    case PE_PanelButtonBevel:
        return paintBox(*painter, option->rect, buttonBox(look, stateOf(*option, widget)));
    case PE_PanelButtonTool:
        if (option->state & (State_MouseOver | State_Sunken | State_On | State_HasFocus))
            paintBox(*painter, option->rect, buttonBox(look, stateOf(*option, widget)));
        return;
    case PE_PanelLineEdit:
        if (!widget || !qobject_cast<const QAbstractSpinBox *>(widget->parentWidget()))
            paintBox(*painter, option->rect, fieldBox(look, stateOf(*option, widget)));
        return;
    case PE_FrameLineEdit:
        return;
    case PE_Frame:
        return paintBox(*painter, option->rect,
                        {QColor(), option->state & State_HasFocus ? look.accent : look.border,
                         option->state & State_HasFocus ? 2 : 1});
    case PE_FrameFocusRect:
        if (!widget || !widget->inherits("QAbstractItemView"))
            drawFocus(*option, *painter);
        return;
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
        return drawIndicator(*option, *painter, widget, false);
    case PE_IndicatorRadioButton:
        return drawIndicator(*option, *painter, widget, true);
    case PE_PanelItemViewItem:
        return drawItemPanel(*option, *painter);
    case PE_PanelItemViewRow:
        return;
    case PE_PanelTipLabel:
        painter->fillRect(option->rect, look.base);
        return paintBox(*painter, option->rect, {look.base, look.border}, 1);
    case PE_FrameStatusBarItem:
        return;
    default:
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

static void drawProgress(const QStyleOption &option, QPainter &painter)
{
    const auto *bar = qstyleoption_cast<const QStyleOptionProgressBar *>(&option);
    if (!bar)
        return;
    const Palette &look = lookOf(option.palette);
    const QRect groove = QStyle::alignedRect(Qt::LeftToRight, Qt::AlignVCenter | Qt::AlignLeft,
                                             QSize(bar->rect.width(), 8), bar->rect);
    paintBox(painter, groove, {look.grid, look.border}, 1);
    QRect done = groove.adjusted(1, 1, -1, -1);
    if (bar->maximum > bar->minimum) {
        const double share = double(bar->progress - bar->minimum) / double(bar->maximum - bar->minimum);
        done.setWidth(static_cast<int>(done.width() * std::clamp(share, 0.0, 1.0) + 0.5));
    } else {
        // No figure to show: a still half-filled bar, the workbench has no animation.
        painter.fillRect(done, QBrush(look.accent, Qt::BDiagPattern));
        return;
    }
    painter.fillRect(done, look.accent);
}

static void drawHeaderSection(const QStyleOption &option, QPainter &painter)
{
    const Palette &look = lookOf(option.palette);
    painter.fillRect(option.rect, look.header);
    painter.setPen(look.border);
    painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
}

static void drawMenuBarGround(const QStyleOption &option, QPainter &painter)
{
    const Palette &look = lookOf(option.palette);
    painter.fillRect(option.rect, look.window);
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), look.border);
}

static void drawMenuBarItem(const QStyleOption &option, QPainter &painter)
{
    const Palette &look = lookOf(option.palette);
    drawMenuBarGround(option, painter);
    const auto *item = qstyleoption_cast<const QStyleOptionMenuItem *>(&option);
    if (!item)
        return;
    const bool active = (item->state & QStyle::State_Selected) && (item->state & QStyle::State_Enabled);
    if (active)
        painter.fillRect(option.rect.adjusted(0, 0, 0, -1), look.selection);
    painter.setPen(item->state & QStyle::State_Enabled ? look.text : look.disabledText);
    const int flags = Qt::AlignCenter |
                      (QGuiApplication::keyboardModifiers() & Qt::AltModifier ? Qt::TextShowMnemonic
                                                                              : Qt::TextHideMnemonic) |
                      Qt::TextDontClip | Qt::TextSingleLine;
    painter.drawText(option.rect, flags, item->text);
}

void WorkbenchStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                                 const QWidget *widget) const
{
    const Palette &look = lookOf(option->palette);
    switch (element) {
    case CE_ProgressBar:
        return drawProgress(*option, *painter);
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
        return drawHeaderSection(*option, *painter);
    case CE_MenuBarItem:
        return drawMenuBarItem(*option, *painter);
    case CE_MenuBarEmptyArea:
        return drawMenuBarGround(*option, *painter);
    case CE_Splitter:
        return;
    case CE_PushButtonLabel: {
        const auto *button = qstyleoption_cast<const QStyleOptionButton *>(option);
        if (!button)
            return;
        QStyleOptionButton copy = *button;
        copy.palette.setColor(QPalette::ButtonText, buttonTextColor(look, stateOf(*option, widget)));
        return QProxyStyle::drawControl(element, &copy, painter, widget);
    }
    case CE_ItemViewItem: {
        const auto *item = qstyleoption_cast<const QStyleOptionViewItem *>(option);
        if (!item)
            return;
        QStyleOptionViewItem copy = *item;
        copy.palette.setColor(QPalette::HighlightedText, item->palette.color(QPalette::Text));
        return QProxyStyle::drawControl(element, &copy, painter, widget);
    }
    default:
        QProxyStyle::drawControl(element, option, painter, widget);
    }
}

void WorkbenchStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                        QPainter *painter, const QWidget *widget) const
{
    switch (control) {
    case CC_ComboBox:
        return paintComboBox(*painter, *option, stateOf(*option, widget));
    case CC_SpinBox:
        if (const auto *spin = qstyleoption_cast<const QStyleOptionSpinBox *>(option))
            paintSpinBox(*painter, *spin, stateOf(*option, widget));
        return;
    case CC_ScrollBar:
        if (const auto *slider = qstyleoption_cast<const QStyleOptionSlider *>(option))
            paintScrollBar(*painter, *slider, lookOf(option->palette));
        return;
    default:
        QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
}

QRect WorkbenchStyle::subControlRect(ComplexControl control, const QStyleOptionComplex *option,
                                     SubControl part, const QWidget *widget) const
{
    if (control == CC_ComboBox && part != SC_ComboBoxListBoxPopup)
        return comboPart(option->rect, part);
    if (control == CC_SpinBox) {
        if (const auto *spin = qstyleoption_cast<const QStyleOptionSpinBox *>(option))
            return spinPart(*spin, part);
    }
    if (control == CC_ScrollBar) {
        if (const auto *slider = qstyleoption_cast<const QStyleOptionSlider *>(option))
            return scrollBarPart(*slider, part);
    }
    return QProxyStyle::subControlRect(control, option, part, widget);
}

QRect WorkbenchStyle::subElementRect(SubElement element, const QStyleOption *option,
                                     const QWidget *widget) const
{
    if (element == SE_ProgressBarGroove || element == SE_ProgressBarContents)
        return option->rect;
    // The text of a field stands as far in as that of a combo box; a spin box sees to its own.
    if (element == SE_LineEditContents && widget &&
        !qobject_cast<const QAbstractSpinBox *>(widget->parentWidget()))
        return option->rect.adjusted(kFieldMargin, 1, -kFieldMargin, -1);
    if (element == SE_CheckBoxFocusRect || element == SE_RadioButtonFocusRect)
        return option->rect;
    return QProxyStyle::subElementRect(element, option, widget);
}

static QSize buttonSize(const QStyleOption &option)
{
    const auto *button = qstyleoption_cast<const QStyleOptionButton *>(&option);
    if (!button)
        return {};
    int width = option.fontMetrics.horizontalAdvance(button->text) + 16;
    if (!button->icon.isNull())
        width += button->iconSize.width() + 8;
    return {width, std::max(kControlHeight, option.fontMetrics.height() + 4)};
}

QSize WorkbenchStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                                       const QWidget *widget) const
{
    const int field = std::max(kControlHeight, option ? option->fontMetrics.height() + 4 : 0);
    switch (type) {
    case CT_PushButton:
        return buttonSize(*option);
    case CT_LineEdit:
    case CT_SpinBox:
        return {size.width() + 8, field};
    case CT_ComboBox:
        return {size.width() + kChevronColumn + 16, field};
    case CT_CheckBox:
    case CT_RadioButton: {
        const QSize usual = QProxyStyle::sizeFromContents(type, option, size, widget);
        return {usual.width() + 4, std::max(usual.height(), kControlHeight)};
    }
    case CT_MenuBarItem:
        return {size.width() + 16, std::max(kControlHeight + 1, size.height() + 4)};
    case CT_ProgressBar:
        return {size.width(), 8};
    case CT_HeaderSection: {
        const QSize usual = QProxyStyle::sizeFromContents(type, option, size, widget);
        return {usual.width() + 8, std::max(usual.height(), kControlHeight)};
    }
    default:
        return QProxyStyle::sizeFromContents(type, option, size, widget);
    }
}

int WorkbenchStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    switch (metric) {
    case PM_ScrollBarExtent:
        return 12;
    case PM_SplitterWidth:
        return kWideGap;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
        return kIndicator;
    case PM_CheckBoxLabelSpacing:
    case PM_RadioButtonLabelSpacing:
        return 8;
    case PM_ButtonIconSize:
    case PM_SmallIconSize:
    case PM_ListViewIconSize:
        return 16;
    case PM_DefaultFrameWidth:
    case PM_MenuPanelWidth:
        return 1;
    case PM_HeaderMargin:
        return 8;
    case PM_FocusFrameHMargin:
        return 7; // one less than the margin of an item's text
    case PM_MenuBarPanelWidth:
    case PM_MenuBarItemSpacing:
    case PM_MenuBarVMargin:
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
        return 0;
    case PM_MenuBarHMargin:
        return 8;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int WorkbenchStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                              QStyleHintReturn *returned) const
{
    switch (hint) {
    case SH_FormLayoutLabelAlignment:
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    case SH_FormLayoutFieldGrowthPolicy:
        return 2; // QFormLayout::AllNonFixedFieldsGrow
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_ComboBox_Popup:
    case SH_ScrollBar_Transient:
    case SH_Widget_Animation_Duration:
    case SH_ItemView_ActivateItemOnSingleClick:
        return 0;
    case SH_ItemView_ShowDecorationSelected:
        return 1;
    default:
        return QProxyStyle::styleHint(hint, option, widget, returned);
    }
}

void WorkbenchStyle::polish(QWidget *widget)
{
    QProxyStyle::polish(widget);
    if (qobject_cast<QAbstractButton *>(widget) || qobject_cast<QComboBox *>(widget) ||
        qobject_cast<QAbstractSpinBox *>(widget))
        widget->setAttribute(Qt::WA_Hover);
    if (auto *header = qobject_cast<QHeaderView *>(widget))
        header->setFont(noteFont());
}

} // namespace driftbench
