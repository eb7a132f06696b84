#include "app/gui/pages/plan_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

PlanPage::PlanPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Plan)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState PlanPage::stepState() const
{
    return {};
}

QString PlanPage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void PlanPage::retranslate()
{
    head().setTitle(stepName(Step::Plan));
    head().setContext(tr("What the chamber does in each run, and for how long"));
    m_empty->setTexts(tr("No plan yet"), tr("Choose a sensor and a chamber."));
}

} // namespace driftbench
