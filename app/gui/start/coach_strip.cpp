#include "app/gui/start/coach_strip.h"

#include "app/gui/start/guided_tour.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"

#include <QAction>
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
    , m_next(new QAction(this))
    , m_skip(new QAction(this))
    , m_end(new QAction(this))
    , m_actions{m_next, m_skip, m_end}
{
    buildActions();
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
    for (QAction *action : m_actions) {
        auto *button = new ActionButton(action, ButtonSize::Small);
        button->setPrimary(action == m_next);
        columns->addWidget(button);
        if (action == m_next)
            m_nextButton = button;
    }
    connect(&m_tour, &GuidedTour::changed, this, &CoachStrip::showStep);
    showStep();
}

void CoachStrip::buildActions()
{
    m_next->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Right));
    m_skip->setShortcut(QKeySequence(Qt::ALT | Qt::SHIFT | Qt::Key_Right));
    m_end->setShortcut(QKeySequence(Qt::ALT | Qt::Key_End));
    connect(m_next, &QAction::triggered, &m_tour, &GuidedTour::next);
    connect(m_skip, &QAction::triggered, &m_tour, &GuidedTour::skip);
    connect(m_end, &QAction::triggered, &m_tour, &GuidedTour::stop);
    showTexts();
}

void CoachStrip::showTexts()
{
    m_next->setText(tr("Next"));
    m_skip->setText(tr("Skip"));
    m_end->setText(tr("End tour"));
    setAccessibleName(tr("Guided tour"));
}

void CoachStrip::showStep()
{
    setVisible(m_tour.isActive());
    for (QAction *action : m_actions)
        action->setEnabled(m_tour.isActive());
    if (!m_tour.isActive())
        return;
    const TourStep &step = m_tour.step();
    m_count->setText(tr("Guided tour, %1 of %2").arg(m_tour.at() + 1).arg(m_tour.count()));
    m_what->setText(step.what());
    const QString state = m_tour.isWorking() && step.state ? step.state() : QString();
    const bool troubled = !m_tour.trouble().isEmpty();
    m_why->setText(troubled ? m_tour.trouble() : state.isEmpty() ? step.why() : state);
    m_why->setTone(troubled ? Tone::Bad : Tone::Plain);
    m_next->setText(troubled                                             ? tr("Try again")
                    : m_tour.at() + 1 == m_tour.count() && !step.perform ? tr("Finish")
                                                                         : tr("Next"));
    enableNext(!m_tour.isWorking());
}

// A button that is disabled hands the focus on to Skip, where the next press of Space would be one too many.
void CoachStrip::enableNext(bool enabled)
{
    if (!enabled && m_nextButton->hasFocus())
        setFocus();
    m_next->setEnabled(enabled);
    if (enabled && hasFocus())
        m_nextButton->setFocus();
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
    if (event->type() != QEvent::LanguageChange)
        return;
    showTexts();
    showStep();
}

} // namespace driftbench
