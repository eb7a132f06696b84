// A compensation table, knot by knot: temperature, TDE in dps, the fixed-point codes, and the worst error of
// the cell that begins there (against the model, in mdps).
#pragma once

#include "engine/compensation/table_error.h"
#include "widgets/tables/table_text.h"

#include <QAbstractTableModel>

#include <memory>

namespace driftbench {

struct KnotsTableData
{
    CompensationTable table;
    FixedPointTable fixed;
    TableErrors errors; // empty: not measured
};

class KnotsTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit KnotsTableModel(QObject *parent = nullptr) : QAbstractTableModel(parent) {}

    void setData(std::shared_ptr<const KnotsTableData> shown); // null: empty

    static std::vector<int> codeColumns(); // what the device holds; of use beside the rates only

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    enum Column
    {
        Temperature,
        Value,
        Code = Value + 3,
        Worst = Code + 3,
        kColumns
    };

    double valueOf(int row, int column) const;
    int decimalsOf(int column) const;

    std::shared_ptr<const KnotsTableData> m_data;
};

} // namespace driftbench
