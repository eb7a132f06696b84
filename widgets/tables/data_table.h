// A table as the workbench shows it: rows of 24 px with rules between, no grid, heads of one or two lines,
// numbers to the right. Ctrl+C copies the selected cells with their heads, the context menu copies all of it
// as text, CSV, Markdown or LaTeX. Where sorting is on, a click on a head sorts by the numbers behind the
// texts. What a cell says beside its text: TableRole (table_text.h).
#pragma once

#include "widgets/tables/table_text.h"

#include <QTableView>

class QSortFilterProxyModel;

namespace driftbench {

class DataTable : public QTableView
{
    Q_OBJECT

public:
    explicit DataTable(const QString &accessibleName, QWidget *parent = nullptr);

    void setTableModel(QAbstractItemModel *model); // not owned
    void setSortable(bool sortable);
    // Each column as wide as its widest text, at least; the rest goes to the column named, else to all.
    void setStretchColumn(int column);
    // Left out, all together, where there is no room for every column; copies have them.
    void setYieldingColumns(std::vector<int> columns);
    // Never wider than the view: the widest columns give way, and what is cut is whole in a tooltip.
    void setKeptInView(bool kept);
    void fitColumns();
    QModelIndex toSource(const QModelIndex &shown) const;

    void copyAs(TableFormat format);  // all of it, to the clipboard
    void copySelected();              // as text; all of it if nothing is selected
    int heightOfRows(int rows) const; // head and so many rows, without scroll bars

signals:
    void rowActivated(int sourceRow); // clicked, or Enter

protected:
    void contextMenuEvent(QContextMenuEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    std::vector<int> wantedWidths() const;
    void yieldColumns(std::vector<int> &widths);
    void setSpans();

    QSortFilterProxyModel *m_proxy;
    int m_stretch = -1;
    std::vector<int> m_yielding;
    bool m_keptInView = false;
};

} // namespace driftbench
