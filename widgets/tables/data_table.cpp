#include "widgets/tables/data_table.h"

#include "widgets/style/fonts.h"
#include "widgets/tables/table_paint.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QSortFilterProxyModel>

#include <numeric>

namespace driftbench {

static constexpr int kRowHeight = 24;
static constexpr int kRowsMeasured = 60; // of a long table, for the widths of its columns

namespace {

// By the numbers where there are numbers.
class Sorted : public QSortFilterProxyModel
{
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override
    {
        const QVariant a = left.data(kExactRole);
        const QVariant b = right.data(kExactRole);
        if (a.isValid() && b.isValid())
            return a.toDouble() < b.toDouble();
        return left.data().toString().localeAwareCompare(right.data().toString()) < 0;
    }
};

} // namespace

DataTable::DataTable(const QString &accessibleName, QWidget *parent)
    : QTableView(parent), m_proxy(new Sorted(this))
{
    setAccessibleName(accessibleName);
    setHorizontalHeader(new TableHead(this));
    setItemDelegate(new TableCell(this));
    verticalHeader()->hide();
    setRowHeight(kRowHeight);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrap(false);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setCornerButtonEnabled(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    horizontalHeader()->setSectionsClickable(false);
    connect(this, &QTableView::clicked, this,
            [this](const QModelIndex &index) { emit rowActivated(toSource(index).row()); });
}

void DataTable::setTableModel(QAbstractItemModel *model)
{
    m_proxy->setSourceModel(model);
    setModel(m_proxy);
    connect(model, &QAbstractItemModel::modelReset, this, &DataTable::fitColumns);
    connect(model, &QAbstractItemModel::dataChanged, this, [this] {
        fitColumns();
        viewport()->update();
    });
    fitColumns();
}

void DataTable::setSortable(bool sortable)
{
    horizontalHeader()->setSectionsClickable(sortable);
    setSortingEnabled(sortable);
    // Nothing is sorted until a head is clicked.
    m_proxy->sort(-1);
    horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
}

void DataTable::setRowHeight(int px)
{
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setMinimumSectionSize(px);
    verticalHeader()->setDefaultSectionSize(std::max(px, QFontMetrics(bodyFont()).height() + 2));
}

void DataTable::setStretchColumn(int column)
{
    m_stretch = column;
    fitColumns();
}

QModelIndex DataTable::toSource(const QModelIndex &shown) const
{
    return m_proxy->mapToSource(shown);
}

std::vector<int> DataTable::wantedWidths() const
{
    std::vector<int> widths;
    const auto *head = static_cast<const TableHead *>(horizontalHeader());
    const int rows = std::min(m_proxy->rowCount(), kRowsMeasured);
    const int last = m_proxy->rowCount() - 1;
    for (int column = 0; column < m_proxy->columnCount(); ++column) {
        int width = head->sectionSizeFromContents(column).width();
        for (int row = 0; row < rows; ++row)
            width = std::max({width, TableCell::widthOf(m_proxy->index(row, column)),
                              TableCell::widthOf(m_proxy->index(last - row, column))});
        widths.push_back(width);
    }
    return widths;
}

void DataTable::fitColumns()
{
    if (m_proxy->columnCount() == 0)
        return;
    std::vector<int> widths = wantedWidths();
    const int spare = viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0);
    if (spare > 0 && m_stretch >= 0 && m_stretch < static_cast<int>(widths.size())) {
        widths[static_cast<std::size_t>(m_stretch)] += spare;
    } else if (spare > 0) {
        const int columns = static_cast<int>(widths.size());
        for (int i = 0; i < columns; ++i)
            widths[static_cast<std::size_t>(i)] += spare * (i + 1) / columns - spare * i / columns;
    }
    for (std::size_t i = 0; i < widths.size(); ++i)
        setColumnWidth(static_cast<int>(i), widths[i]);
    clearSpans();
    const int spannedRows = m_proxy->rowCount() <= kRowsMeasured ? m_proxy->rowCount() : 0;
    for (int row = 0; row < spannedRows; ++row) {
        for (int column = 0; column < m_proxy->columnCount(); ++column) {
            const int span = m_proxy->index(row, column).data(kSpanRole).toInt();
            if (span > 1)
                setSpan(row, column, 1, span);
        }
    }
    horizontalHeader()->setFixedHeight(static_cast<TableHead *>(horizontalHeader())->sizeHint().height());
}

int DataTable::heightOfRows(int rows) const
{
    return static_cast<const TableHead *>(horizontalHeader())->sizeHint().height() +
           rows * verticalHeader()->defaultSectionSize();
}

void DataTable::copyAs(TableFormat format)
{
    if (model())
        QApplication::clipboard()->setText(tableAs(gridOf(*model()), format));
}

void DataTable::copySelected()
{
    if (model())
        QApplication::clipboard()->setText(
            tableAs(gridOf(*model(), selectionModel()->selectedIndexes()), TableFormat::Text));
}

void DataTable::contextMenuEvent(QContextMenuEvent *event)
{
    QMenu menu(this);
    menu.addAction(tr("Copy selected cells"), this, &DataTable::copySelected);
    menu.addSeparator();
    menu.addAction(tr("Copy table as text"), this, [this] { copyAs(TableFormat::Text); });
    menu.addAction(tr("Copy table as CSV"), this, [this] { copyAs(TableFormat::Csv); });
    menu.addAction(tr("Copy table as Markdown"), this, [this] { copyAs(TableFormat::Markdown); });
    menu.addAction(tr("Copy table as LaTeX"), this, [this] { copyAs(TableFormat::Latex); });
    menu.exec(event->globalPos());
}

void DataTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy))
        return copySelected();
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && currentIndex().isValid()) {
        emit rowActivated(toSource(currentIndex()).row());
        return;
    }
    QTableView::keyPressEvent(event);
}

void DataTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange)
        fitColumns();
}

void DataTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

} // namespace driftbench
