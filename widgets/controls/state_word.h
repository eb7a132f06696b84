// A state as an icon and a word in its colour: "Pass", "Not permitted", "Streaming".
#pragma once

#include "widgets/controls/text_label.h"

#include <QWidget>

namespace driftbench {

// The icon of a tone: check, warn, cross, info.
QString iconOfTone(Tone tone);

class StateWord : public QWidget
{
    Q_OBJECT

public:
    explicit StateWord(QWidget *parent = nullptr);

    // iconName: empty for that of the tone.
    void setState(Tone tone, const QString &word, const QString &iconName = {});
    void setRole(TextRole role); // StrongNote unless told otherwise
    QString word() const { return m_word; }
    Tone tone() const { return m_tone; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    Tone m_tone = Tone::Plain;
    TextRole m_role = TextRole::StrongNote;
    QString m_word;
    QString m_icon;
};

} // namespace driftbench
