// The status bar: the keys of the page at the left, parts of the state at the right with rules between. Where
// there is no room for all, parts that may (StatusPart::yields) are left out before the keys are cut.
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
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    int widthOf(const std::vector<StatusPart> &parts) const;

    TextLabel *m_hints;
    QHBoxLayout *m_layout;
    std::vector<StatusPart> m_wanted;
    std::vector<TextLabel *> m_parts;
    std::vector<QWidget *> m_rules;
};

} // namespace driftbench
