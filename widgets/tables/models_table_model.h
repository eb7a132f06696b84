// The models of a comparison side by side: inputs, size, time, MSD and excess over the noise floor per axis,
// as means over the held-out runs. A model that is being trained has a bar in its row, one that was refused
// the sentence; the noise floor is the last row.
#pragma once

#include "widgets/style/palette.h"
#include "widgets/tables/table_text.h"

#include <QAbstractTableModel>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace driftbench {

struct ModelLine
{
    enum class State
    {
        Waiting,
        Running,
        Finished,
        Stopped // cancelled, or refused: note says why
    };
    std::string name; // as in files
    State state = State::Waiting;
    QString label;  // "RBF, 11 centres (Novel)"; empty: from the name
    QString inputs; // "ΔT, ΔT²"
    int parameters = 0;
    double timeS = NAN;
    std::array<double, 3> msd{NAN, NAN, NAN};           // dps^2
    std::array<double, 3> excessPercent{NAN, NAN, NAN}; // over the floor
    double progress = 0.0;                              // 0..1
    QString note;                                       // in place of the figures
    bool recommended = false;
};

struct ModelsTableData
{
    std::vector<ModelLine> models;
    std::array<double, 3> floor{NAN, NAN, NAN}; // dps^2
};

class ModelsTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit ModelsTableModel(QObject *parent = nullptr) : QAbstractTableModel(parent) {}

    void setData(ModelsTableData shown);
    void setLook(const Palette &look);
    const ModelsTableData &shown() const { return m_data; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    enum Column
    {
        Name,
        Inputs,
        Parameters,
        Time,
        Msd,
        Excess = Msd + 3,
        kColumns = Excess + 3
    };

    bool hasFloor() const { return std::isfinite(m_data.floor[0]); }
    QVariant floorData(int column, int role) const;
    QString textOf(const ModelLine &line, int column) const;
    double valueOf(const ModelLine &line, int column) const;
    bool isWordy(const ModelLine &line) const;

    ModelsTableData m_data;
    Palette m_look = lightPalette();
};

// "310 ms", "12.9 s", "< 1 ms".
QString trainingTimeText(double seconds);

} // namespace driftbench
