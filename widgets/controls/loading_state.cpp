#include "widgets/controls/loading_state.h"

#include "widgets/controls/text_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kBarWidth = 200;
static constexpr int kBarSteps = 1000;

LoadingState::LoadingState(QWidget *parent)
    : QWidget(parent)
    , m_what(new TextLabel(TextRole::Note, this))
    , m_bar(new QProgressBar(this))
    , m_cancel(new QAction(this))
{
    auto *rows = new QVBoxLayout(this);
    rows->setSpacing(8);
    rows->addStretch(1);
    m_what->setAlignment(Qt::AlignCenter);
    m_what->setWordWrap(true);
    rows->addWidget(m_what);
    m_bar->setFixedWidth(kBarWidth);
    m_bar->setTextVisible(false);
    rows->addWidget(m_bar, 0, Qt::AlignHCenter);
    m_cancel->setShortcut(Qt::Key_Escape);
    addAction(m_cancel);
    connect(m_cancel, &QAction::triggered, this, &LoadingState::cancelled);
    rows->addWidget(new ActionButton(m_cancel, ButtonSize::Small, this), 0, Qt::AlignHCenter);
    rows->addStretch(1);
    retranslate();
}

void LoadingState::setProgress(const QString &what, double fraction)
{
    m_what->setText(what);
    m_bar->setRange(0, fraction < 0.0 ? 0 : kBarSteps);
    if (fraction >= 0.0)
        m_bar->setValue(static_cast<int>(fraction * kBarSteps + 0.5));
}

void LoadingState::retranslate()
{
    m_cancel->setText(tr("Cancel"));
    m_bar->setAccessibleName(tr("Progress"));
}

void LoadingState::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace driftbench
