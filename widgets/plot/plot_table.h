// The data that a plot shows, as a table: for eyes that do not see curves, for the clipboard and for CSV
// files. On the screen numbers are in the user's locale, in files never.
#pragma once

#include <QAbstractTableModel>
#include <QByteArray>
#include <QStringList>
#include <QVector>

#include <vector>

class QCustomPlot;

namespace driftbench {

struct PlotTable
{
    struct Column
    {
        QString head;            // quantity and unit
        QStringList texts;       // either these
        QVector<double> numbers; // or these
        int decimals = 4;        // on the screen
    };
    std::vector<Column> columns; // of one length

    qsizetype rows() const;
};

QByteArray plotTableAsCsv(const PlotTable &table); // UTF-8, one head line, numbers with all their digits

// What any plot has in view: panel, series, key and value of each point.
PlotTable visibleData(const QCustomPlot &plot);

class PlotTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit PlotTableModel(PlotTable table, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    PlotTable m_table;
};

// Opens a window of its own beside the others; Ctrl+C copies the marked cells with their heads. It deletes
// itself when closed.
QWidget *showPlotTable(PlotTable table, const QString &title, QWidget *parent);

} // namespace driftbench
