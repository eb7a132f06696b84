#include "widgets/tables/table_paint.h"

#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"
#include "widgets/tables/table_text.h"

#include <QHelpEvent>
#include <QPainter>
#include <QTableView>
#include <QToolTip>

namespace driftbench {

static constexpr int kPadding = 8;
static constexpr int kMarkWidth = 20;
static constexpr int kMarkGap = 8;
static constexpr int kIconGap = 4;
static constexpr int kBarHeight = 8;
static constexpr int kBarWidth = 56;
static constexpr int kSortMark = 5;

TableHead::TableHead(QWidget *parent) : QHeaderView(Qt::Horizontal, parent)
{
    setHighlightSections(false);
    setSectionsClickable(true);
    setMinimumSectionSize(24);
}

QSize TableHead::sizeHint() const
{
    int lines = 1;
    if (model()) {
        for (int i = 0; i < model()->columnCount(); ++i) {
            const QString text = model()->headerData(i, Qt::Horizontal).toString();
            lines = std::max(lines, 1 + static_cast<int>(text.count(QLatin1Char('\n'))));
        }
    }
    const int line = QFontMetrics(noteFont()).height();
    return {QHeaderView::sizeHint().width(), std::max(lines > 1 ? 36 : 24, lines * line + 4)};
}

QSize TableHead::sectionSizeFromContents(int section) const
{
    const QFontMetrics metrics(noteFont());
    int width = 0;
    for (const QString &line :
         model()->headerData(section, Qt::Horizontal).toString().split(QLatin1Char('\n')))
        width = std::max(width, metrics.horizontalAdvance(line));
    return {width + 2 * kPadding, sizeHint().height()};
}

void TableHead::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const Palette &look = lookOf(palette());
    painter->save();
    painter->fillRect(rect, look.header);
    painter->setPen(look.border);
    painter->drawLine(rect.left(), rect.bottom(), rect.right(), rect.bottom());
    const int alignment = model()->headerData(section, Qt::Horizontal, Qt::TextAlignmentRole).toInt();
    const bool right = (alignment & Qt::AlignRight) != 0;
    painter->setFont(noteFont());
    painter->setPen(look.mutedText);
    const QRect inner = rect.adjusted(kPadding, 0, -kPadding, -1);
    painter->drawText(inner, (right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                      model()->headerData(section, Qt::Horizontal).toString());
    if (isSortIndicatorShown() && sortIndicatorSection() == section) {
        const int x = right ? rect.right() - kPadding / 2 - 1 : rect.left() + kPadding / 2;
        const int y = rect.center().y();
        const bool up = sortIndicatorOrder() == Qt::AscendingOrder;
        const int tip = up ? y - kSortMark / 2 : y + kSortMark / 2;
        const int base = up ? y + kSortMark / 2 : y - kSortMark / 2;
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setBrush(look.mutedText);
        painter->setPen(Qt::NoPen);
        painter->drawPolygon(QPolygon({QPoint(x - 3, base), QPoint(x + 3, base), QPoint(x, tip)}));
    }
    painter->restore();
}

static QFont cellFont(const QModelIndex &index)
{
    return index.data(kStrongRole).toBool() ? sectionFont() : bodyFont();
}

int TableCell::widthOf(const QModelIndex &index)
{
    if (index.data(kSpanRole).toInt() > 1)
        return 0;
    int width = 2 * kPadding + QFontMetrics(cellFont(index)).horizontalAdvance(index.data().toString());
    if (index.data(kLineRole).isValid())
        width += kMarkWidth + kMarkGap;
    if (!index.data(kIconRole).toString().isEmpty())
        width += kSmallIcon + kIconGap;
    if (index.data(kProgressRole).isValid())
        width = std::max(width, kBarWidth + 2 * kPadding);
    return width;
}

bool TableCell::helpEvent(QHelpEvent *event, QAbstractItemView *view, const QStyleOptionViewItem &option,
                          const QModelIndex &index)
{
    const bool cut = index.isValid() && widthOf(index) > option.rect.width();
    if (event->type() != QEvent::ToolTip || !cut || index.data(Qt::ToolTipRole).isValid())
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    QToolTip::showText(event->globalPos(), index.data().toString(), view);
    return true;
}

static void paintBar(QPainter &painter, const QRect &place, double share, const Palette &look)
{
    const QRect bar(place.right() - kBarWidth + 1, place.center().y() - kBarHeight / 2, kBarWidth,
                    kBarHeight);
    painter.setPen(look.border);
    painter.setBrush(look.grid);
    painter.drawRect(bar.adjusted(0, 0, -1, -1));
    const int done = static_cast<int>((bar.width() - 2) * std::clamp(share, 0.0, 1.0));
    painter.fillRect(QRect(bar.left() + 1, bar.top() + 1, done, bar.height() - 2), look.accent);
}

void TableCell::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Palette &look = lookOf(option.palette);
    painter->save();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->fillRect(option.rect, selected ? look.selection : look.base);
    painter->setPen(look.grid);
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    QRect place = option.rect.adjusted(kPadding, 0, -kPadding, -1);
    const QVariant line = index.data(kLineRole);
    if (line.isValid()) {
        painter->setPen(line.value<QPen>());
        painter->drawLine(place.left(), place.center().y(), place.left() + kMarkWidth, place.center().y());
        place.setLeft(place.left() + kMarkWidth + kMarkGap);
    }
    const auto tone = static_cast<Tone>(index.data(kToneRole).toInt());
    const bool muted = index.data(kMutedRole).toBool();
    const QColor color = textColor(muted ? TextRole::Muted : TextRole::Body, tone, look);
    const QString icon = index.data(kIconRole).toString();
    if (!icon.isEmpty()) {
        paintIcon(*painter, QRect(place.left(), place.center().y() - kSmallIcon / 2, kSmallIcon, kSmallIcon),
                  icon, color);
        place.setLeft(place.left() + kSmallIcon + kIconGap);
    }
    const QVariant progress = index.data(kProgressRole);
    if (progress.isValid()) {
        paintBar(*painter, place, progress.toDouble(), look);
    } else {
        painter->setFont(cellFont(index));
        painter->setPen(color);
        const int alignment = index.data(Qt::TextAlignmentRole).toInt();
        const auto horizontal = (alignment & Qt::AlignRight) != 0 ? Qt::AlignRight : Qt::AlignLeft;
        const QString text =
            painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, place.width() + 1);
        painter->drawText(place, int(horizontal) | Qt::AlignVCenter | Qt::TextSingleLine, text);
    }
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(look.accent, 1));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
    painter->restore();
}

void dressTable(QTableView &view, int rowHeight)
{
    view.setHorizontalHeader(new TableHead(&view));
    view.horizontalHeader()->setSectionsClickable(false);
    QHeaderView &rows = *view.verticalHeader();
    rows.hide();
    rows.setSectionResizeMode(QHeaderView::Fixed);
    rows.setMinimumSectionSize(rowHeight); // before the usual height, which does not go below it
    rows.setDefaultSectionSize(std::max(rowHeight, QFontMetrics(bodyFont()).height() + 2));
    view.setShowGrid(false);
    view.setFrameShape(QFrame::NoFrame);
    view.setWordWrap(false);
    view.setTabKeyNavigation(false);
    view.setCornerButtonEnabled(false);
    view.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    view.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
}

} // namespace driftbench
