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

static constexpr int kLeastColumn = 40;  // px, when there is no room for all
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
    dressTable(*this);
    setItemDelegate(new TableCell(this));
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
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

void DataTable::setStretchColumn(int column)
{
    m_stretch = column;
    fitColumns();
}

void DataTable::setYieldingColumns(std::vector<int> columns)
{
    m_yielding = std::move(columns);
    fitColumns();
}

void DataTable::setKeptInView(bool kept)
{
    m_keptInView = kept;
    setHorizontalScrollBarPolicy(kept ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
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

// Hidden columns have no width afterwards.
void DataTable::yieldColumns(std::vector<int> &widths)
{
    const bool full = std::accumulate(widths.begin(), widths.end(), 0) > viewport()->width();
    for (const int column : m_yielding) {
        setColumnHidden(column, full);
        if (full)
            widths[static_cast<std::size_t>(column)] = 0;
    }
}

// The widest are cut to one width, until all fit.
static void cutToFit(std::vector<int> &widths, int room)
{
    int widest = *std::max_element(widths.begin(), widths.end());
    while (std::accumulate(widths.begin(), widths.end(), 0) > room && widest > kLeastColumn) {
        --widest;
        for (int &width : widths)
            width = std::min(width, widest);
    }
}

void DataTable::fitColumns()
{
    if (m_proxy->columnCount() == 0)
        return;
    std::vector<int> widths = wantedWidths();
    yieldColumns(widths);
    if (m_keptInView)
        cutToFit(widths, viewport()->width());
    const int spare = viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0);
    if (spare > 0 && m_stretch >= 0 && m_stretch < static_cast<int>(widths.size())) {
        widths[static_cast<std::size_t>(m_stretch)] += spare;
    } else if (spare > 0) {
        const auto columns =
            static_cast<int>(widths.size()) - static_cast<int>(std::count(widths.begin(), widths.end(), 0));
        int place = 0;
        for (int &width : widths) {
            if (width == 0)
                continue;
            width += spare * (place + 1) / columns - spare * place / columns;
            ++place;
        }
    }
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] > 0)
            setColumnWidth(static_cast<int>(i), widths[i]);
    }
    setSpans();
    horizontalHeader()->setFixedHeight(static_cast<TableHead *>(horizontalHeader())->sizeHint().height());
}

void DataTable::setSpans()
{
    clearSpans();
    const int spannedRows = m_proxy->rowCount() <= kRowsMeasured ? m_proxy->rowCount() : 0;
    for (int row = 0; row < spannedRows; ++row) {
        for (int column = 0; column < m_proxy->columnCount(); ++column) {
            const int span = m_proxy->index(row, column).data(kSpanRole).toInt();
            if (span > 1)
                setSpan(row, column, 1, span);
        }
    }
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
