#include "app/gui/shortcut_overview.h"

#include "widgets/controls/action_button.h"

#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace driftbench {

ShortcutOverview::ShortcutOverview(QWidget *parent) : QDialog(parent), m_list(new QTreeWidget(this))
{
    setWindowTitle(tr("Keyboard shortcuts"));
    resize(480, 560);
    auto *rows = new QVBoxLayout(this);
    rows->addWidget(m_list);
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Keys"), tr("What they do")});
    m_list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_list->setAccessibleName(windowTitle());
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
}

void ShortcutOverview::setGroups(const std::vector<ShortcutGroup> &groups)
{
    m_list->clear();
    for (const ShortcutGroup &group : groups) {
        auto *top = new QTreeWidgetItem({group.name});
        QFont strong = m_list->font();
        strong.setWeight(QFont::DemiBold);
        top->setFont(0, strong);
        for (const QAction *action : group.actions) {
            const QString keys = shortcutText(*action);
            if (!keys.isEmpty())
                top->addChild(new QTreeWidgetItem({keys, action->iconText()}));
        }
        for (const QString &other : group.others)
            top->addChild(new QTreeWidgetItem(other.split(QLatin1Char('|'))));
        if (top->childCount() == 0) {
            delete top;
            continue;
        }
        m_list->addTopLevelItem(top);
        top->setFirstColumnSpanned(true);
    }
    m_list->expandAll();
}

int ShortcutOverview::shortcutCount() const
{
    int count = 0;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i)
        count += m_list->topLevelItem(i)->childCount();
    return count;
}

} // namespace driftbench
