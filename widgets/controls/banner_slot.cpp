#include "widgets/controls/banner_slot.h"

#include "widgets/style/control_paint.h"

#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace driftbench {

BannerSlot::BannerSlot(QWidget *parent) : QWidget(parent), m_banner(new Banner(this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, kGap);
    layout->addWidget(m_banner);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(m_banner, &Banner::closed, this, [this] {
        const QString key = m_shown;
        withdraw(key);
        emit dismissed(key);
    });
    hide();
}

void BannerSlot::post(const QString &key, const BannerContent &content)
{
    put({key, content, {}});
}

void BannerSlot::post(const QString &key, std::function<BannerContent()> content)
{
    put({key, content(), content});
}

void BannerSlot::put(Message message)
{
    const auto same = std::find_if(m_messages.begin(), m_messages.end(),
                                   [&](const Message &m) { return m.key == message.key; });
    if (same != m_messages.end())
        *same = std::move(message);
    else
        m_messages.push_back(std::move(message));
    showMostUrgent();
}

void BannerSlot::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    for (Message &message : m_messages) {
        if (message.again)
            message.content = message.again();
    }
    showMostUrgent();
}

void BannerSlot::withdraw(const QString &key)
{
    if (std::erase_if(m_messages, [&](const Message &m) { return m.key == key; }) > 0)
        showMostUrgent();
}

bool BannerSlot::holds(const QString &key) const
{
    return std::any_of(m_messages.begin(), m_messages.end(), [&](const Message &m) { return m.key == key; });
}

void BannerSlot::showMostUrgent()
{
    if (m_messages.empty()) {
        m_shown.clear();
        hide();
        return;
    }
    // max_element gives the first of equals: looked for from the latest on.
    const auto most =
        std::max_element(m_messages.rbegin(), m_messages.rend(),
                         [](const Message &a, const Message &b) { return a.content.kind < b.content.kind; });
    m_shown = most->key;
    m_banner->setContent(most->content);
    show();
}

} // namespace driftbench
