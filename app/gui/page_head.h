// The head of a page, 40 px: title, where the data come from, one muted line of context, then controls, the
// primary button last.
#pragma once

#include "widgets/controls/origin_chip.h"

#include <QWidget>

class QHBoxLayout;

namespace driftbench {

class TextLabel;

class PageHead : public QWidget
{
    Q_OBJECT

public:
    explicit PageHead(QWidget *parent = nullptr);

    void setTitle(const QString &title);
    void setOrigin(Origin origin);
    Origin origin() const;
    void setContext(const QString &line); // cut with "…" where there is no room
    QString context() const;
    void addControl(QWidget *control); // from left to right

private:
    TextLabel *m_title;
    OriginChip *m_chip;
    TextLabel *m_context;
    QHBoxLayout *m_controls;
};

} // namespace driftbench
