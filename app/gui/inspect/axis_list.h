// The three axes to choose from: a small picture of TDE against temperature, the spread where the sweeps
// meet, and in words whether it is a curve of temperature.
#pragma once

#include "engine/evaluation/campaign_inspection.h"
#include "widgets/controls/text_label.h"

#include <QListView>
#include <QPolygonF>

#include <array>

class QStandardItemModel;

namespace driftbench {

struct AxisEntry
{
    QString name;   // "x"
    QString figure; // "0.79 dps"
    QString words;  // "Not a curve of T"
    Tone tone = Tone::Plain;
    QPolygonF heating, cooling; // 0..1 both ways, y upwards
};

class AxisList : public QListView
{
    Q_OBJECT

public:
    explicit AxisList(QWidget *parent = nullptr);

    void setEntries(const std::array<AxisEntry, 3> &entries);
    const std::array<AxisEntry, 3> &entries() const { return m_entries; }
    int currentAxis() const { return currentIndex().row(); }
    void setCurrentAxis(int axis);

    QSize sizeHint() const override;

    static constexpr int kRowHeight = 64;

signals:
    void axisChosen(int axis);

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    class Delegate;

    std::array<AxisEntry, 3> m_entries;
    QStandardItemModel *m_rows;
};

} // namespace driftbench
