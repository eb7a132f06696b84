#include "widgets/controls/empty_state.h"

#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace driftbench {

EmptyState::EmptyState(const QString &iconName, QWidget *parent)
    : QWidget(parent)
    , m_iconName(iconName)
    , m_icon(new QLabel(this))
    , m_headline(new TextLabel(TextRole::Section, this))
    , m_sentence(new TextLabel(TextRole::Note, this))
    , m_buttons(new QHBoxLayout)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(16, 16, 16, 16);
    rows->setSpacing(8);
    rows->addStretch(1);
    for (QLabel *label : {m_icon, static_cast<QLabel *>(m_headline), static_cast<QLabel *>(m_sentence)}) {
        label->setAlignment(Qt::AlignCenter);
        rows->addWidget(label);
    }
    m_sentence->setWordWrap(true);
    m_buttons->setSpacing(8);
    rows->addLayout(m_buttons);
    rows->addStretch(1);
    showIcon();
}

void EmptyState::setTexts(const QString &headline, const QString &sentence)
{
    m_headline->setText(headline);
    m_sentence->setText(sentence);
}

void EmptyState::setActions(const std::vector<QAction *> &actions)
{
    while (QLayoutItem *item = m_buttons->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_buttons->addStretch(1);
    for (QAction *action : actions) {
        auto *button = new ActionButton(action, ButtonSize::Small, this);
        button->setShortcutShown(false);
        m_buttons->addWidget(button);
    }
    m_buttons->addStretch(1);
}

void EmptyState::showIcon()
{
    m_icon->setPixmap(iconPixmap(m_iconName, kIcon, lookOf(palette()).mutedText, devicePixelRatioF()));
}

void EmptyState::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showIcon();
}

} // namespace driftbench
