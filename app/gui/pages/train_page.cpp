#include "app/gui/pages/train_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

TrainPage::TrainPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Train)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState TrainPage::stepState() const
{
    return {};
}

QString TrainPage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void TrainPage::retranslate()
{
    head().setTitle(stepName(Step::Train));
    head().setContext(tr("Each run is held out once. Held-out error counts, training error does not."));
    m_empty->setTexts(tr("Nothing to train on"), tr("Record a run, or open a log file."));
}

} // namespace driftbench
