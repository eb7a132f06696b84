// What is excluded, as a table: time, samples, why. The reason of what the user took out can be written.
#pragma once

#include "app/gui/inspect/inspection_data.h"

#include <QAbstractTableModel>

#include <memory>

namespace driftbench {

class ExcludedModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        kTime,
        kSamples,
        kWhy,
        kColumns
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setData(std::shared_ptr<const InspectionData> seen);
    void retranslate();
    const ExcludedStretch *stretch(int row) const;     // null: there is none
    int rowOf(std::size_t run, std::size_t own) const; // -1: not there

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void reasonWritten(std::size_t run, std::size_t own, const QString &why);

private:
    QString timeText(const ExcludedStretch &stretch) const;

    std::shared_ptr<const InspectionData> m_seen;
};

} // namespace driftbench
