#include "app/gui/start/coach_strip.h"

#include "app/gui/start/guided_tour.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kEdge = 4;

CoachStrip::CoachStrip(GuidedTour &tour, QWidget *parent)
    : QFrame(parent)
    , m_tour(tour)
    , m_count(new TextLabel(TextRole::Note))
    , m_what(new TextLabel(TextRole::Section))
    , m_why(new TextLabel(TextRole::Note))
    , m_next(new ActionButton(ButtonSize::Small))
    , m_skip(new ActionButton(ButtonSize::Small))
    , m_end(new ActionButton(ButtonSize::Small))
{
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(48, 6, 16, 6);
    columns->setSpacing(8);
    auto *lines = new QVBoxLayout;
    lines->setSpacing(0);
    auto *first = new QHBoxLayout;
    first->setSpacing(8);
    first->addWidget(m_what);
    first->addWidget(m_count);
    first->addStretch(1);
    lines->addLayout(first);
    m_why->setElided(true);
    lines->addWidget(m_why);
    columns->addLayout(lines, 1);
    m_next->setPrimary(true);
    for (ActionButton *button : {m_next, m_skip, m_end})
        columns->addWidget(button);
    connect(m_next, &QPushButton::clicked, &m_tour, &GuidedTour::next);
    connect(m_skip, &QPushButton::clicked, &m_tour, &GuidedTour::skip);
    connect(m_end, &QPushButton::clicked, &m_tour, &GuidedTour::stop);
    connect(&m_tour, &GuidedTour::changed, this, &CoachStrip::showStep);
    hide();
}

void CoachStrip::showStep()
{
    setVisible(m_tour.isActive());
    if (!m_tour.isActive())
        return;
    const TourStep &step = m_tour.step();
    m_count->setText(tr("Guided tour, %1 of %2").arg(m_tour.at() + 1).arg(m_tour.count()));
    m_what->setText(step.what());
    const QString state = m_tour.isWorking() && step.state ? step.state() : QString();
    m_why->setText(state.isEmpty() ? step.why() : state);
    m_next->setText(m_tour.at() + 1 == m_tour.count() && !step.perform ? tr("Finish") : tr("Next"));
    m_next->setEnabled(!m_tour.isWorking());
    setAccessibleName(tr("Guided tour"));
    m_skip->setText(tr("Skip"));
    m_end->setText(tr("End tour"));
    for (ActionButton *button : {m_next, m_skip, m_end})
        button->updateGeometry();
}

void CoachStrip::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.infoFill);
    painter.fillRect(0, 0, width(), 1, look.accent);
    painter.fillRect(0, 0, kEdge, height(), look.accent);
    paintIcon(painter, QRect(16, (height() - kIcon) / 2, kIcon, kIcon), QStringLiteral("play"), look.accent);
}

void CoachStrip::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showStep();
}

} // namespace driftbench
