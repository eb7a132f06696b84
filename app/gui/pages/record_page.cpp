#include "app/gui/pages/record_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

RecordPage::RecordPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Record)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState RecordPage::stepState() const
{
    return {};
}

QString RecordPage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void RecordPage::retranslate()
{
    head().setTitle(stepName(Step::Record));
    head().setContext(tr("Live traces"));
    m_empty->setTexts(tr("No runs yet"), tr("Record a run, or open a log file."));
}

} // namespace driftbench
