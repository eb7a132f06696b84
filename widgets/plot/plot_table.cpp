#include "widgets/plot/plot_table.h"

#include "engine/base/text.h"
#include "widgets/style/number_text.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QHeaderView>
#include <QShortcut>
#include <QTableView>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace driftbench {

static constexpr QSize kWindowSize(560, 480);

qsizetype PlotTable::rows() const
{
    qsizetype rows = 0;
    for (const Column &column : columns)
        rows = std::max({rows, column.texts.size(), column.numbers.size()});
    return rows;
}

static QString quoted(const QString &text)
{
    static const QRegularExpression kNeedsQuotes(QStringLiteral("[\",\r\n]"));
    if (!text.contains(kNeedsQuotes))
        return text;
    QString doubled = text;
    doubled.replace(QLatin1Char('"'), QStringLiteral("\"\""));
    return QLatin1Char('"') + doubled + QLatin1Char('"');
}

static QString cellInFile(const PlotTable::Column &column, qsizetype row)
{
    if (row < column.texts.size())
        return quoted(column.texts[row]);
    if (row < column.numbers.size() && std::isfinite(column.numbers[row]))
        return QString::fromStdString(shortest(column.numbers[row]));
    return {};
}

QByteArray plotTableAsCsv(const PlotTable &table)
{
    QStringList heads;
    for (const PlotTable::Column &column : table.columns)
        heads.append(quoted(column.head));
    QString text = heads.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (qsizetype row = 0; row < table.rows(); ++row) {
        QStringList cells;
        for (const PlotTable::Column &column : table.columns)
            cells.append(cellInFile(column, row));
        text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text.toUtf8();
}

// Small multiples share their words: the panel's own name may stand only beside the first of its row.
static QString panelName(const QCPAxisRect &panel, int number)
{
    const QString value = panel.axis(QCPAxis::atLeft)->label();
    const QString key = panel.axis(QCPAxis::atBottom)->label();
    if (!value.isEmpty() && !key.isEmpty())
        return QStringLiteral("%1: %2, %3").arg(number).arg(value, key);
    return QStringLiteral("%1: %2%3").arg(number).arg(value, key);
}

PlotTable visibleData(const QCustomPlot &plot)
{
    const auto text = [](const char *words) {
        return QApplication::translate("driftbench::PlotTable", words);
    };
    PlotTable table;
    table.columns = {{text(QT_TRANSLATE_NOOP("driftbench::PlotTable", "Panel")), {}, {}},
                     {text(QT_TRANSLATE_NOOP("driftbench::PlotTable", "Series")), {}, {}},
                     {text(QT_TRANSLATE_NOOP("driftbench::PlotTable", "Key")), {}, {}},
                     {text(QT_TRANSLATE_NOOP("driftbench::PlotTable", "Value")), {}, {}}};
    int number = 0;
    for (const QCPAxisRect *panel : plot.axisRects()) {
        const QString name = panelName(*panel, ++number);
        for (const QCPGraph *graph : panel->graphs()) {
            const QCPRange keys = graph->keyAxis()->range();
            const QCPRange values = graph->valueAxis()->range();
            for (auto point = graph->data()->findBegin(keys.lower, false);
                 point != graph->data()->findEnd(keys.upper, false); ++point) {
                if (!values.contains(point->value))
                    continue;
                table.columns[0].texts.append(name);
                table.columns[1].texts.append(graph->name());
                table.columns[2].numbers.append(point->key);
                table.columns[3].numbers.append(point->value);
            }
        }
    }
    return table;
}

PlotTableModel::PlotTableModel(PlotTable table, QObject *parent)
    : QAbstractTableModel(parent), m_table(std::move(table))
{
}

int PlotTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_table.rows());
}

int PlotTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_table.columns.size());
}

QVariant PlotTableModel::data(const QModelIndex &index, int role) const
{
    const PlotTable::Column &column = m_table.columns[static_cast<std::size_t>(index.column())];
    const bool isText = !column.texts.isEmpty();
    if (role == Qt::TextAlignmentRole)
        return int((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (isText)
        return index.row() < column.texts.size() ? column.texts[index.row()] : QString();
    return index.row() < column.numbers.size() ? numberText(column.numbers[index.row()], column.decimals)
                                               : QString();
}

QVariant PlotTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return section + 1;
    return m_table.columns[static_cast<std::size_t>(section)].head;
}

static void copyMarked(const QTableView &view)
{
    QModelIndexList marked = view.selectionModel()->selectedIndexes();
    if (marked.isEmpty())
        return;
    std::sort(marked.begin(), marked.end());
    QStringList heads;
    const int firstRow = marked.front().row();
    for (const QModelIndex &cell : marked) {
        if (cell.row() == firstRow)
            heads.append(view.model()->headerData(cell.column(), Qt::Horizontal).toString());
    }
    QString text = heads.join(QLatin1Char('\t'));
    int row = -1;
    for (const QModelIndex &cell : marked) {
        text += cell.row() == row ? QLatin1Char('\t') : QLatin1Char('\n');
        text += cell.data().toString();
        row = cell.row();
    }
    QApplication::clipboard()->setText(text);
}

QWidget *showPlotTable(PlotTable table, const QString &title, QWidget *parent)
{
    auto *window = new QDialog(parent);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->setWindowTitle(title);
    auto *layout = new QVBoxLayout(window);
    auto *view = new QTableView(window);
    view->setModel(new PlotTableModel(std::move(table), view));
    view->setAccessibleName(title);
    view->setAlternatingRowColors(true);
    view->setSelectionMode(QAbstractItemView::ContiguousSelection);
    view->horizontalHeader()->setStretchLastSection(true);
    layout->addWidget(view);
    auto *copy = new QShortcut(QKeySequence::Copy, view);
    QObject::connect(copy, &QShortcut::activated, view, [view] { copyMarked(*view); });
    window->resize(kWindowSize);
    window->show();
    return window;
}

} // namespace driftbench
