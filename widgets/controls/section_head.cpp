#include "widgets/controls/section_head.h"

#include "widgets/style/control_paint.h"

#include <QHBoxLayout>

namespace driftbench {

SectionHead::SectionHead(const QString &title, QWidget *parent)
    : QWidget(parent)
    , m_layout(new QHBoxLayout(this))
    , m_title(new TextLabel(TextRole::Section, title))
    , m_aside(new TextLabel(TextRole::Note))
    , m_note(new TextLabel(TextRole::Note))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(kGap);
    m_layout->addWidget(m_title);
    m_layout->addWidget(m_aside);
    m_layout->addStretch(1);
    m_layout->addWidget(m_note);
    m_note->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setFixedHeight(std::max(kControlHeight, m_title->sizeHint().height()));
    m_aside->hide();
}

void SectionHead::setAside(const QString &text)
{
    m_aside->setText(text);
    m_aside->setVisible(!text.isEmpty());
}

void SectionHead::setNote(const QString &note, Tone tone)
{
    m_note->setText(note);
    m_note->setTone(tone);
}

void SectionHead::addControl(QWidget *control)
{
    m_layout->addWidget(control);
}

} // namespace driftbench
