#include "app/gui/pages/page_list.h"

#include "app/gui/pages/compare_page.h"
#include "app/gui/pages/export_page.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/pages/plan_page.h"
#include "app/gui/pages/record_page.h"
#include "app/gui/pages/source_page.h"
#include "app/gui/pages/train_page.h"

namespace driftbench {

Page *makePage(Step step, AppContext &context)
{
    switch (step) {
    case Step::Source:
        return new SourcePage(context);
    case Step::Plan:
        return new PlanPage(context);
    case Step::Record:
        return new RecordPage(context);
    case Step::Inspect:
        return new InspectPage(context);
    case Step::Train:
        return new TrainPage(context);
    case Step::Compare:
        return new ComparePage(context);
    case Step::Export:
        return new ExportPage(context);
    }
    return nullptr;
}

} // namespace driftbench
