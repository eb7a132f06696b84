// How tables look: the head, the cells of a DataTable, and what every table view has in common.
#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>

class QTableView;

namespace driftbench {

class TableHead : public QHeaderView
{
    Q_OBJECT

public:
    explicit TableHead(QWidget *parent);

    QSize sizeHint() const override;
    QSize sectionSizeFromContents(int section) const override;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
};

class TableCell : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    static int widthOf(const QModelIndex &index);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    // A text that is cut stands whole in a tooltip.
    bool helpEvent(QHelpEvent *event, QAbstractItemView *view, const QStyleOptionViewItem &option,
                   const QModelIndex &index) override;
};

// Head in 9 pt, rows of one height, no lines between columns. Before anything is set on the horizontal
// header.
void dressTable(QTableView &view, int rowHeight = 24);

} // namespace driftbench
