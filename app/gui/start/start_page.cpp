#include "app/gui/start/start_page.h"

#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kColumnWidth = 640;
static constexpr int kChoiceHeight = 72;
static constexpr int kChoiceLeft = 56;

ChoiceButton::ChoiceButton(const QString &iconName, bool primary, QWidget *parent)
    : QAbstractButton(parent), m_iconName(iconName), m_primary(primary)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
}

void ChoiceButton::setTexts(const QString &title, const QString &sentence)
{
    setText(title);
    m_sentence = sentence;
    setAccessibleName(title);
    setAccessibleDescription(sentence);
    update();
}

QSize ChoiceButton::sizeHint() const
{
    const int text = QFontMetrics(sectionFont()).height() + 2 * QFontMetrics(noteFont()).height() + 20;
    return {kColumnWidth, std::max(kChoiceHeight, text)};
}

void ChoiceButton::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    ControlState state;
    state.enabled = isEnabled();
    state.focused = hasFocus();
    state.hovered = underMouse();
    state.pressed = isDown();
    state.primary = m_primary;
    QPainter painter(this);
    paintBox(painter, rect(), buttonBox(look, state));
    const QColor strong = buttonTextColor(look, state);
    const QColor weak = m_primary ? look.textOnAccent : look.mutedText;
    paintIcon(painter, QRect(18, (height() - kIcon) / 2, kIcon, kIcon), m_iconName, strong);
    const QRect place = rect().adjusted(kChoiceLeft, 0, -16, 0);
    const QFontMetrics titleMetrics(sectionFont());
    const QRect wrapped = QFontMetrics(noteFont()).boundingRect(place, Qt::TextWordWrap, m_sentence);
    const int top = (height() - titleMetrics.height() - wrapped.height() - 2) / 2;
    painter.setFont(sectionFont());
    painter.setPen(strong);
    painter.drawText(QRect(place.left(), top, place.width(), titleMetrics.height()), Qt::AlignLeft, text());
    painter.setFont(noteFont());
    painter.setPen(weak);
    painter.drawText(
        QRect(place.left(), top + titleMetrics.height() + 2, place.width(), wrapped.height() + 4),
        Qt::AlignLeft | Qt::TextWordWrap, m_sentence);
}

StartPage::StartPage(QWidget *parent)
    : QWidget(parent)
    , m_title(new TextLabel(TextRole::Title))
    , m_sentence(new TextLabel(TextRole::Muted))
    , m_choices{new ChoiceButton(QStringLiteral("play"), true),
                new ChoiceButton(QStringLiteral("usb"), false),
                new ChoiceButton(QStringLiteral("open"), false)}
    , m_note(new TextLabel(TextRole::Note))
{
    auto *column = new QWidget;
    column->setFixedWidth(kColumnWidth);
    auto *rows = new QVBoxLayout(column);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    rows->addWidget(m_title);
    m_sentence->setWordWrap(true);
    rows->addWidget(m_sentence);
    rows->addSpacing(kWideGap);
    for (ChoiceButton *choice : m_choices)
        rows->addWidget(choice);
    rows->addSpacing(kGap);
    m_note->setWordWrap(true);
    rows->addWidget(m_note);
    auto *centre = new QVBoxLayout(this);
    centre->addStretch(2);
    centre->addWidget(column, 0, Qt::AlignHCenter);
    centre->addStretch(3);
    connect(m_choices[0], &QAbstractButton::clicked, this, &StartPage::tourChosen);
    connect(m_choices[1], &QAbstractButton::clicked, this, &StartPage::bridgeChosen);
    connect(m_choices[2], &QAbstractButton::clicked, this, &StartPage::filesChosen);
    setFocusProxy(m_choices[0]);
    retranslate();
}

void StartPage::retranslate()
{
    m_title->setText(tr("Calibrate the temperature drift of a gyro"));
    m_sentence->setText(
        tr("From samples to a table in the device, in seven steps. Each step can be used on its own."));
    m_choices[0]->setTexts(
        tr("Guided tour on the simulated bridge"),
        tr("Connects, records three runs faster than time, trains, compares and writes the table. "
           "Under two minutes, no hardware."));
    m_choices[1]->setTexts(tr("Connect a bridge"),
                           tr("A native gyro bridge, or an L3GD20H or I3G4250D behind a USB-to-I2C chip."));
    m_choices[2]->setTexts(tr("Open log files or a session…"),
                           tr("CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content."));
    m_note->setText(tr("Files can also be dropped anywhere on this window. F1 lists all keys."));
    setAccessibleName(tr("Start"));
}

void StartPage::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace driftbench
