#include "app/gui/pages/compare_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

ComparePage::ComparePage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Compare)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState ComparePage::stepState() const
{
    return {};
}

QString ComparePage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void ComparePage::retranslate()
{
    head().setTitle(stepName(Step::Compare));
    head().setContext(tr("Models against a constant, on runs they have not seen"));
    m_empty->setTexts(tr("Nothing to judge"), tr("Train a model first."));
}

} // namespace driftbench
