#include "app/gui/inspect/axis_list.h"

#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

namespace driftbench {

static constexpr QRect kPicture(8, 8, 72, 48); // in a row
static constexpr int kTextLeft = 90;
static constexpr int kEdge = 3;

class AxisList::Delegate : public QStyledItemDelegate
{
public:
    explicit Delegate(AxisList *list) : QStyledItemDelegate(list), m_list(list) {}

    QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override
    {
        return {0, kRowHeight};
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const Palette &look = lookOf(option.palette);
        const AxisEntry &entry = m_list->m_entries[static_cast<std::size_t>(index.row())];
        const bool current = option.state.testFlag(QStyle::State_Selected);
        painter->save();
        painter->fillRect(option.rect, current ? look.selection : look.base);
        if (current)
            painter->fillRect(QRect(option.rect.left(), option.rect.top(), kEdge, option.rect.height()),
                              look.accent);
        if (index.row() + 1 < index.model()->rowCount())
            painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                              look.border);
        drawPicture(*painter, kPicture.translated(option.rect.topLeft()), entry, look);
        drawWords(*painter, option.rect, entry, look);
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->setPen(QPen(look.accent, 2.0));
            painter->setBrush(Qt::NoBrush);
            painter->drawRect(QRectF(option.rect).adjusted(1, 1, -1, -1));
        }
        painter->restore();
    }

private:
    static void drawPicture(QPainter &painter, const QRect &place, const AxisEntry &entry,
                            const Palette &look)
    {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(look.border, 1.0));
        painter.setBrush(look.base);
        painter.drawRect(place);
        painter.setRenderHint(QPainter::Antialiasing, true);
        const QRectF inside = QRectF(place).adjusted(5, 5, -5, -5);
        for (const auto &[dots, color] :
             {std::pair(&entry.heating, look.heating), std::pair(&entry.cooling, look.cooling)}) {
            painter.setPen(QPen(color, 1.5, Qt::SolidLine, Qt::RoundCap));
            for (const QPointF &dot : *dots)
                painter.drawPoint(QPointF(inside.left() + dot.x() * inside.width(),
                                          inside.bottom() - dot.y() * inside.height()));
        }
    }

    static void drawWords(QPainter &painter, const QRect &row, const AxisEntry &entry, const Palette &look)
    {
        const QRect upper(row.left() + kTextLeft, row.top() + 12, row.width() - kTextLeft - 4, 20);
        painter.setFont(sectionFont());
        painter.setPen(look.text);
        painter.drawText(upper, Qt::AlignLeft | Qt::AlignVCenter, entry.name);
        const int used = QFontMetrics(sectionFont()).horizontalAdvance(entry.name) + 8;
        painter.setFont(bodyFont());
        painter.drawText(upper.adjusted(used, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, entry.figure);
        painter.setFont(noteFont());
        painter.setPen(entry.tone == Tone::Caution ? look.caution : look.mutedText);
        const QRect lower = upper.translated(0, 20);
        painter.drawText(lower, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(noteFont()).elidedText(entry.words, Qt::ElideRight, lower.width()));
    }

    AxisList *m_list;
};

AxisList::AxisList(QWidget *parent) : QListView(parent), m_rows(new QStandardItemModel(3, 1, this))
{
    for (int row = 0; row < 3; ++row)
        m_rows->setItem(row, new QStandardItem);
    setModel(m_rows);
    setItemDelegate(new Delegate(this));
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(NoEditTriggers);
    setSelectionMode(SingleSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setUniformItemSizes(true);
    setFixedHeight(3 * kRowHeight);
    setCurrentAxis(0);
}

QSize AxisList::sizeHint() const
{
    return {230, 3 * kRowHeight};
}

void AxisList::setEntries(const std::array<AxisEntry, 3> &entries)
{
    m_entries = entries;
    for (int row = 0; row < 3; ++row) {
        const AxisEntry &entry = entries[static_cast<std::size_t>(row)];
        m_rows->item(row)->setData(entry.name + QStringLiteral(", ") + entry.figure + QStringLiteral(", ") +
                                       entry.words,
                                   Qt::AccessibleTextRole);
    }
    viewport()->update();
}

void AxisList::setCurrentAxis(int axis)
{
    setCurrentIndex(m_rows->index(axis, 0));
}

void AxisList::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QListView::currentChanged(current, previous);
    if (current.isValid() && current.row() != previous.row())
        emit axisChosen(current.row());
}

// Letters are keys of the page here, not a search in the list.
void AxisList::keyPressEvent(QKeyEvent *event)
{
    if (event->text().isEmpty() || !event->text().front().isLetterOrNumber())
        QListView::keyPressEvent(event);
    else
        event->ignore();
}

} // namespace driftbench
