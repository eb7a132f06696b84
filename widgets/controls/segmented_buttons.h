// Two or three choices that exclude each other, as joined buttons: "Run | 10 min | 1 min".
#pragma once

#include "widgets/controls/action_button.h"

#include <QButtonGroup>
#include <QWidget>

class QHBoxLayout;

namespace driftbench {

class SegmentedButtons : public QWidget
{
    Q_OBJECT

public:
    // accessibleName: what is chosen.
    SegmentedButtons(const QString &accessibleName, ButtonSize size, QWidget *parent = nullptr);

    void setTexts(const QStringList &texts); // keeps the choice where it still exists
    int current() const;                     // -1: none
    void setCurrent(int index);              // silent if it is so already
    void setStretched(bool stretched);       // fill the width that there is
    QAbstractButton *button(int index) const;

signals:
    void currentChanged(int index);

private:
    QButtonGroup m_group;
    QHBoxLayout *m_layout;
    ButtonSize m_size;
    bool m_stretched = false;
};

} // namespace driftbench
