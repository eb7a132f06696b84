#include "app/gui/page_head.h"

#include "widgets/controls/text_label.h"

#include <QHBoxLayout>

namespace driftbench {

static constexpr int kHeight = 40;

PageHead::PageHead(QWidget *parent)
    : QWidget(parent)
    , m_title(new TextLabel(TextRole::Title, this))
    , m_chip(new OriginChip(this))
    , m_context(new TextLabel(TextRole::Muted, this))
    , m_controls(new QHBoxLayout)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(m_title);
    layout->addWidget(m_chip);
    m_context->setElided(true);
    layout->addWidget(m_context, 1);
    m_controls->setSpacing(8);
    layout->addLayout(m_controls);
    setMinimumHeight(kHeight);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void PageHead::setTitle(const QString &title)
{
    m_title->setText(title);
}

void PageHead::setOrigin(Origin origin)
{
    m_chip->setOrigin(origin);
}

Origin PageHead::origin() const
{
    return m_chip->origin();
}

void PageHead::setContext(const QString &line)
{
    m_context->setText(line);
}

QString PageHead::context() const
{
    return m_context->text();
}

void PageHead::addControl(QWidget *control)
{
    m_controls->addWidget(control);
}

} // namespace driftbench
