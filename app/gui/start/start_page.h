// What a newcomer sees first: what can be done, the guided tour foremost. No step of the rail; it goes as
// soon as one is chosen.
#pragma once

#include <QAbstractButton>
#include <QWidget>

#include <array>

namespace driftbench {

class TextLabel;

// A wide button with an icon, what it does, and a sentence about it.
class ChoiceButton : public QAbstractButton
{
    Q_OBJECT

public:
    ChoiceButton(const QString &iconName, bool primary, QWidget *parent = nullptr);

    void setTexts(const QString &title, const QString &sentence);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_iconName;
    QString m_sentence;
    bool m_primary;
};

class StartPage : public QWidget
{
    Q_OBJECT

public:
    explicit StartPage(QWidget *parent = nullptr);

    ChoiceButton &tour() const { return *m_choices[0]; }

signals:
    void tourChosen();
    void bridgeChosen();
    void filesChosen();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    TextLabel *m_title;
    TextLabel *m_sentence;
    std::array<ChoiceButton *, 3> m_choices;
    TextLabel *m_note;
};

} // namespace driftbench
