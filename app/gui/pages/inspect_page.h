// The page Inspect: TDE against the temperature quantities with a fitted curve, or over time; what is
// selected in one plot is marked in all; stretches are excluded with the brush, and every edit can be undone.
#pragma once

#include "app/gui/inspect/inspection_data.h"
#include "app/gui/inspect/selection.h"
#include "app/gui/page.h"

#include <memory>
#include <optional>
#include <utility>

class QSplitter;
class QStackedWidget;

namespace driftbench {

class CoverageView;
class EmptyState;
class ExclusionStrip;
class InspectSide;
class LegendRow;
class LoadingState;
class PlotView;
class SegmentedButtons;
class TcqScatterView;
class TcqTimeView;
struct StripData;

class InspectPage : public Page
{
    Q_OBJECT

public:
    explicit InspectPage(AppContext &context, QWidget *parent = nullptr);

    StepState stepState() const override;
    QString hints() const override;
    std::vector<StatusPart> statusParts() const override;
    void entered() override;

    const std::shared_ptr<const InspectionData> &seen() const { return m_seen; }
    int axis() const { return m_axis; }
    void setAxis(int axis);
    const Selection &selection() const { return m_selection; }
    void select(Selection selection);
    TcqScatterView &scatter() const { return *m_scatter; }
    ExclusionStrip &strip() const { return *m_strip; }
    CoverageView &coverage() const { return *m_coverage; }
    InspectSide &side() const { return *m_side; }

protected:
    void retranslate() override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    enum State
    {
        kEmpty,
        kLoading,
        kPlots
    };

    QWidget *makeBody();
    QWidget *makePlots();
    void addActions();
    void connectPlots();
    void connectWork();
    void refresh(); // prepares and looks, as far as it is not done
    void look();    // at what is prepared
    void sayFailure(const Error &error);
    void showEmptyTexts();
    void take(const std::shared_ptr<const InspectionData> &seen);
    void showAll();
    void showScatter();
    void showStrip();
    void showOverTime();
    void showLegend();
    void showHead();
    void showBanner();
    void showFindings();
    void showButtons();
    void addStripDots(StripData &strip) const;
    void addStripRanges(StripData &strip) const;
    std::pair<QString, QString> directionTexts() const;

    void excludeOrInclude();
    void exclude(const Selection &selection);
    void include(std::size_t run, std::size_t own);
    void moveExclusion(std::size_t stripRange, double startS, double endS);
    void edit(const CalibrationPlan &plan, const QString &text);
    void pick(std::optional<std::size_t> stripRange); // an excluded stretch

    std::shared_ptr<const InspectionData> m_seen;
    InspectionJob m_job;
    int m_axis = 0;
    bool m_overTime = false;
    // By the job, which keeps them as long as it runs.
    std::pair<const PreparedCampaign *, const TrainedModel *> m_lookedAt{};
    bool m_lookPending = false;
    bool m_failed = false; // the runs could not be read; not tried again by itself
    Selection m_selection;
    Selection m_dragged;                  // in the strip, until the button is let go
    std::vector<std::size_t> m_rangeRows; // of the strip's ranges: which of m_seen->excluded each is
    std::optional<std::size_t> m_picked;  // of m_seen->excluded

    TcqScatterView *m_scatter;
    TcqTimeView *m_time;
    ExclusionStrip *m_strip;
    CoverageView *m_coverage;
    InspectSide *m_side;
    LegendRow *m_legend;
    SegmentedButtons *m_choice;
    QStackedWidget *m_states; // one a State
    QStackedWidget *m_upper;
    QSplitter *m_splitter;
    EmptyState *m_empty;
    LoadingState *m_loading;
    QAction *m_exclude;
    QAction *m_findings;
    QAction *m_goToRecord;
};

} // namespace driftbench
