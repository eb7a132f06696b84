#include "widgets/controls/duration_field.h"

#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <optional>

namespace driftbench {

QString durationText(double seconds)
{
    if (!std::isfinite(seconds))
        return QStringLiteral("–");
    const auto whole = static_cast<qint64>(std::llround(std::max(0.0, seconds)));
    return QStringLiteral("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

static std::optional<double> secondsOf(const QString &text)
{
    static const QRegularExpression clock(QStringLiteral("^\\s*(\\d{1,4}):(\\d{1,2})(?::(\\d{1,2}))?\\s*$"));
    static const QRegularExpression seconds(QStringLiteral("^\\s*(\\d{1,7})\\s*s?\\s*$"));
    if (const auto match = clock.match(text); match.hasMatch())
        return match.captured(1).toDouble() * 3600.0 + match.captured(2).toDouble() * 60.0 +
               match.captured(3).toDouble();
    if (const auto match = seconds.match(text); match.hasMatch())
        return match.captured(1).toDouble();
    return std::nullopt;
}

DurationField::DurationField(const QString &accessibleName, double lowestS, double highestS, double stepS,
                             QWidget *parent)
    : QAbstractSpinBox(parent)
    , m_lowestS(lowestS)
    , m_highestS(highestS)
    , m_stepS(stepS)
    , m_valueS(lowestS)
    , m_unit(new TextLabel(TextRole::Note, tr("h:min:s"), this))
{
    setAccessibleName(accessibleName);
    setButtonSymbols(NoButtons);
    setFocusPolicy(Qt::StrongFocus);
    m_unit->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_unit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    lineEdit()->setText(durationText(m_valueS));
    connect(this, &QAbstractSpinBox::editingFinished, this, &DurationField::takeText);
}

void DurationField::setValueS(double seconds)
{
    const double wanted = std::clamp(seconds, m_lowestS, m_highestS);
    lineEdit()->setText(durationText(wanted));
    if (wanted == m_valueS)
        return;
    m_valueS = wanted;
    emit valueChanged(wanted);
}

void DurationField::takeText()
{
    setValueS(secondsOf(lineEdit()->text()).value_or(m_valueS));
}

void DurationField::stepBy(int steps)
{
    takeText();
    setValueS(m_valueS + steps * m_stepS);
}

QValidator::State DurationField::validate(QString &text, int &) const
{
    static const QRegularExpression possible(QStringLiteral("^[\\d:\\ss]*$"));
    if (!possible.match(text).hasMatch())
        return QValidator::Invalid;
    const auto seconds = secondsOf(text);
    return seconds && *seconds >= m_lowestS && *seconds <= m_highestS ? QValidator::Acceptable
                                                                      : QValidator::Intermediate;
}

void DurationField::fixup(QString &text) const
{
    text = durationText(std::clamp(secondsOf(text).value_or(m_valueS), m_lowestS, m_highestS));
}

QSize DurationField::sizeHint() const
{
    ensurePolished();
    const QFontMetrics metrics(font());
    return {metrics.horizontalAdvance(QStringLiteral("00:00:00")) + m_unit->sizeHint().width() + 20,
            std::max(kControlHeight, metrics.height() + 4)};
}

QAbstractSpinBox::StepEnabled DurationField::stepEnabled() const
{
    StepEnabled steps = StepNone;
    if (m_valueS > m_lowestS)
        steps |= StepDownEnabled;
    if (m_valueS < m_highestS)
        steps |= StepUpEnabled;
    return steps;
}

void DurationField::resizeEvent(QResizeEvent *event)
{
    QAbstractSpinBox::resizeEvent(event);
    const int unit = m_unit->sizeHint().width();
    m_unit->setGeometry(width() - unit - 6, 1, unit, height() - 2);
    lineEdit()->setTextMargins(2, 0, unit + 4, 0);
    m_unit->raise();
}

void DurationField::wheelEvent(QWheelEvent *event)
{
    if (hasFocus())
        QAbstractSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace driftbench
