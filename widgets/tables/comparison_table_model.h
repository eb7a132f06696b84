// The comparison as a table in the order of the paper's Tables 2 to 6: MSD before and of the three models,
// the ratios Q, their differences with sign in percent (negative: the first named is better), then what the
// paper does not have: cubic, constant, noise floor, left (rms of the residual), limit.
//
// One run (one row an axis), or all of them (run and axis first). MSD in dps^2.
#pragma once

#include "engine/evaluation/paper_improvements.h"
#include "engine/evaluation/scoring.h"
#include "widgets/tables/table_text.h"

#include <QAbstractTableModel>

#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct ComparisonTableData
{
    std::vector<ComparisonRow> rows;
    std::string novel = "rbf";      // the model that plays the paper's Novel
    std::optional<std::string> run; // nothing: all
    std::optional<double> limitDps; // of what is left
    QString runTitle;               // over the first column, where it is one run
};

class ComparisonTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit ComparisonTableModel(QObject *parent = nullptr) : QAbstractTableModel(parent) {}

    void setData(ComparisonTableData shown);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    int leadingColumns() const { return m_data.run ? 1 : 2; } // run, axis

private:
    enum Figure
    {
        Msd1,
        Msd4,
        Msd5,
        Msd6,
        Q3,
        Q4,
        Q5,
        Q4AgainstQ3,
        Q5AgainstQ3,
        Q5AgainstQ4,
        Cubic,
        Constant,
        Floor,
        Left,
        Limit,
        kFigures
    };
    struct Row
    {
        PaperRow paper;
        double cubic, constant, floor, left;
        std::optional<bool> passes;
    };

    QVariant lead(const Row &row, int column, int role) const;
    double valueOf(const Row &row, int figure) const;
    QString textOf(const Row &row, int figure) const;
    int decimalsOf(int figure) const;

    ComparisonTableData m_data;
    std::vector<Row> m_rows;
};

} // namespace driftbench
