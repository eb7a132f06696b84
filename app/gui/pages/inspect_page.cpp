#include "app/gui/pages/inspect_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

InspectPage::InspectPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Inspect)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState InspectPage::stepState() const
{
    return {};
}

QString InspectPage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void InspectPage::retranslate()
{
    head().setTitle(stepName(Step::Inspect));
    head().setContext(tr("How the drift follows the temperature"));
    m_empty->setTexts(tr("No runs yet"), tr("Record a run, or open a log file."));
}

} // namespace driftbench
