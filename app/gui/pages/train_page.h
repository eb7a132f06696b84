// Train: which models, with which options; what each needs and leaves on runs held out. Finished models stay
// where a training is cancelled. A click on the curve of the excess takes another number of centres.
//
// While nothing new is trained, the page goes on showing what was trained before and says so.
#pragma once

#include "app/gui/page.h"
#include "app/session/prepared_campaign.h"

#include <map>
#include <memory>

class QProgressBar;
class QSplitter;
class QStackedWidget;

namespace driftbench {

class ActionButton;
class CentresView;
class DataTable;
class EmptyState;
class ModelsTableModel;
class Panel;
class TextLabel;
class TrainOptions;

class TrainPage : public Page
{
    Q_OBJECT

public:
    explicit TrainPage(AppContext &context, QWidget *parent = nullptr);
    ~TrainPage() override;

    StepState stepState() const override;
    QString hints() const override;
    std::vector<StatusPart> statusParts() const override;
    void entered() override;

    CentresView &losses() const { return *m_losses; }
    CentresView &curves() const { return *m_curves; }
    DataTable &table() const { return *m_table; }
    ModelsTableModel &models() const { return *m_models; }
    TrainOptions &options() const { return *m_options; }
    bool isOutdated() const; // what is shown was made with other options

protected:
    void retranslate() override;
    void changeEvent(QEvent *event) override;

private:
    void buildHead();
    QWidget *buildResults();
    void connectSession();
    void train();
    void cancel();
    void takeCentres(int centres);
    void runningChanged(bool running);
    void showJob();
    void showPlan();
    void showResult();
    void showFigures();
    void showTable();
    void showContext();
    void showRefusal();
    void setEmptyTexts();

    TrainOptions *m_options;
    QStackedWidget *m_stack;
    EmptyState *m_empty;
    CentresView *m_losses, *m_curves;
    DataTable *m_table;
    Panel *m_tablePanel;
    ModelsTableModel *m_models;
    QAction *m_train, *m_cancel, *m_toInspect;
    TextLabel *m_stage, *m_percent;
    QProgressBar *m_bar;

    std::shared_ptr<const PreparedCampaign> m_shownCampaign;
    std::shared_ptr<const CalibrationResult> m_shown;
    std::map<std::string, double> m_trainedS; // of the running training
    bool m_stopped = false;                   // the last training was cancelled
};

} // namespace driftbench
