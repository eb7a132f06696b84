// The status bar: the keys of the page at the left, parts of the state at the right with rules between.
#pragma once

#include "app/gui/page.h"

#include <QStatusBar>

#include <vector>

class QHBoxLayout;

namespace driftbench {

class StatusLine : public QStatusBar
{
    Q_OBJECT

public:
    explicit StatusLine(QWidget *parent = nullptr);

    void setHints(const QString &hints);
    void setParts(const std::vector<StatusPart> &parts);
    QStringList parts() const;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    TextLabel *m_hints;
    QHBoxLayout *m_layout;
    std::vector<TextLabel *> m_parts;
    std::vector<QWidget *> m_rules;
};

} // namespace driftbench
