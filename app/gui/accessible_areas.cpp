#include "app/gui/accessible_areas.h"

#include <QAbstractScrollArea>
#include <QAccessibleWidget>

namespace driftbench {

// Tables, lists and texts have an answer of their own, which is asked before that of their base class.
static QAccessibleInterface *areaOf(const QString &className, QObject *object)
{
    if (className != QLatin1String("QScrollArea") && className != QLatin1String("QAbstractScrollArea"))
        return nullptr;
    auto *area = qobject_cast<QAbstractScrollArea *>(object);
    return area != nullptr ? new QAccessibleWidget(area, QAccessible::Client) : nullptr;
}

void installAccessibleAreas()
{
    QAccessible::installFactory(areaOf);
}

} // namespace driftbench
