#include "app/gui/pages/export_page.h"

#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"

#include <QVBoxLayout>

namespace driftbench {

ExportPage::ExportPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_empty(new EmptyState(stepIcon(Step::Export)))
{
    auto *panel = new Panel;
    panel->rows()->addWidget(m_empty);
    setBody(panel);
}

StepState ExportPage::stepState() const
{
    return {};
}

QString ExportPage::hints() const
{
    return tr("Alt+1 to 7 steps");
}

void ExportPage::retranslate()
{
    head().setTitle(stepName(Step::Export));
    head().setContext(tr("The table for the device"));
    m_empty->setTexts(tr("No model yet"), tr("Train a model first."));
}

} // namespace driftbench
