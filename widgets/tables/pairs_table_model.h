// Facts side by side: a name, and what it is here and there ("on the device now", "would be written"). What
// differs is semibold on the right.
#pragma once

#include "widgets/tables/table_text.h"

#include <QAbstractTableModel>

#include <vector>

namespace driftbench {

struct FactPair
{
    QString name;
    QString here;
    QString there;
};

class PairsTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit PairsTableModel(QObject *parent = nullptr) : QAbstractTableModel(parent) {}

    void setHeads(const QString &here, const QString &there);
    void setPairs(std::vector<FactPair> pairs);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString m_here, m_there;
    std::vector<FactPair> m_pairs;
};

} // namespace driftbench
