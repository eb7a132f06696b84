#include "app/gui/pages/source_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

SourcePage::SourcePage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Source)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState SourcePage::stepState() const
{
    return {};
}

QString SourcePage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void SourcePage::retranslate()
{
    head().setTitle(stepName(Step::Source));
    head().setContext(tr("Where the samples come from."));
    m_empty->setTexts(tr("No source chosen"), tr("Choose a bridge, or open a log file."));
}

} // namespace driftbench
