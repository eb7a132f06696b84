// All keys of the window in one list, by page, read from the actions themselves. Not modal.
#pragma once

#include <QDialog>

#include <vector>

class QTreeWidget;

namespace driftbench {

struct ShortcutGroup
{
    QString name; // "Everywhere", or the page
    std::vector<const QAction *> actions;
    QStringList others; // "keys|what they do" of keys that are no actions
};

class ShortcutOverview : public QDialog
{
    Q_OBJECT

public:
    explicit ShortcutOverview(QWidget *parent = nullptr);

    void setGroups(const std::vector<ShortcutGroup> &groups);
    int shortcutCount() const;

private:
    QTreeWidget *m_list;
};

} // namespace driftbench
