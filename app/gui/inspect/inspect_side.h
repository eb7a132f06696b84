// The column right of the plots of Inspect: the axes to choose from, the chosen one in figures, coverage, and
// what is excluded.
#pragma once

#include "app/gui/inspect/axis_list.h"
#include "app/gui/inspect/excluded_model.h"
#include "widgets/controls/readout_grid.h"
#include "widgets/controls/section_head.h"

#include <QWidget>

#include <memory>

class QTableView;

namespace driftbench {

class ActionButton;

class InspectSide : public QWidget
{
    Q_OBJECT

public:
    explicit InspectSide(QAction *showFindings, QWidget *parent = nullptr);

    void retranslate();
    void showSeen(const std::shared_ptr<const InspectionData> &seen, int axis);
    AxisList &axes() const { return *m_axes; }
    ExcludedModel &excluded() const { return *m_excluded; }
    QTableView &table() const { return *m_table; }
    const ReadoutGrid &figures() const { return *m_figures; }

private:
    void showAxes();
    void showFigures();
    void showCoverage();

    SectionHead *m_axisHead, *m_figureHead, *m_coverageHead, *m_excludedHead;
    AxisList *m_axes;
    ReadoutGrid *m_figures, *m_coverage;
    ExcludedModel *m_excluded;
    QTableView *m_table;
    std::shared_ptr<const InspectionData> m_seen;
    int m_axis = 0;
};

QString axisLetter(int axis);

} // namespace driftbench
