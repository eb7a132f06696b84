#include "app/gui/page.h"

#include "widgets/controls/action_button.h"
#include "widgets/style/control_paint.h"

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kTopMargin = 12;
static constexpr int kMargin = 16;

Page::Page(AppContext &context, QWidget *parent)
    : QWidget(parent), m_context(context), m_head(new PageHead(this)), m_banners(new BannerSlot(this))
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kMargin, kTopMargin, kMargin, kMargin);
    rows->setSpacing(0);
    rows->addWidget(m_head);
    rows->addSpacing(kGap);
    rows->addWidget(m_banners);
}

void Page::setBody(QWidget *body)
{
    auto *rows = static_cast<QVBoxLayout *>(layout());
    if (m_body) {
        rows->replaceWidget(m_body, body);
        m_body->deleteLater();
    } else {
        rows->addWidget(body, 1);
    }
    m_body = body;
}

QAction *Page::addPageAction(const QKeySequence &keys, const QString &iconName, std::function<void()> slot)
{
    auto *action = new QAction(this);
    action->setShortcut(keys);
    if (!iconName.isEmpty())
        setActionIcon(*action, iconName);
    connect(action, &QAction::triggered, this, [slot = std::move(slot)] { slot(); });
    addAction(action);
    m_actions.push_back(action);
    return action;
}

void Page::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const Qt::KeyboardModifiers modifiers = event->modifiers() & ~Qt::KeypadModifier;
    if (!enter || modifiers != Qt::NoModifier)
        return QWidget::keyPressEvent(event);
    if (auto *button = qobject_cast<QAbstractButton *>(QApplication::focusWidget()))
        return button->click();
    if (m_primary && m_primary->isEnabled())
        m_primary->trigger();
}

void Page::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

// Not in the constructor: a derived page is not whole then.
void Page::initialise()
{
    if (m_translated)
        return;
    m_translated = true;
    retranslate();
}

void Page::showEvent(QShowEvent *event)
{
    initialise();
    QWidget::showEvent(event);
}

} // namespace driftbench
