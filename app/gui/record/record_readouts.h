// The read-outs right of the live traces: progress, running MSD, cursors, link; and where the window is tall,
// the MSD over time. Values change four times a second; rows keep their places.
#pragma once

#include "widgets/controls/readout_grid.h"
#include "widgets/controls/section_head.h"

#include <QWidget>

class QProgressBar;

namespace driftbench {

class LiveRun;
class LiveTraceView;
class MsdTrendView;
class Panel;
struct Palette;

class RecordReadouts : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kTallWindow = 900; // px; above, the MSD over time is shown

    RecordReadouts(const LiveRun &run, const LiveTraceView &view, QWidget *parent = nullptr);

    void retranslate();
    void showAll(); // as it is now
    void showCursors();
    void clearTrend();
    void addTrendPoint();

    QString text(const QString &section, int row, int column = 0) const; // for tests: what stands there

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void addBlock(SectionHead *head, QWidget *body, bool rule);
    void showProgress();
    void showScores();
    void showLink();
    void showTrend();

    const LiveRun &m_run;
    const LiveTraceView &m_view;
    SectionHead *m_progressHead, *m_scoreHead, *m_cursorHead, *m_linkHead, *m_trendHead;
    QProgressBar *m_bar;
    TextLabel *m_percent;
    ReadoutGrid *m_progress, *m_scores, *m_cursors, *m_link;
    Panel *m_trendPanel;
    MsdTrendView *m_trend;
};

} // namespace driftbench
