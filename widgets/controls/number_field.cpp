#include "widgets/controls/number_field.h"

#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"

#include <QLineEdit>
#include <QStyle>
#include <QWheelEvent>

namespace driftbench {

static constexpr int kArrowRoom = 18;

NumberField::NumberField(const QString &accessibleName, const QString &unit, int decimals, double lowest,
                         double highest, double step, QWidget *parent)
    : QDoubleSpinBox(parent), m_unit(new TextLabel(TextRole::Note, unit, this))
{
    setAccessibleName(accessibleName);
    setDecimals(decimals);
    setRange(lowest, highest);
    setSingleStep(step);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    m_unit->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_unit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void NumberField::setUnit(const QString &unit)
{
    m_unit->setText(unit);
    placeUnit();
    updateGeometry();
}

void NumberField::setArrows(bool shown)
{
    setButtonSymbols(shown ? UpDownArrows : NoButtons);
    placeUnit();
}

void NumberField::setMark(const QString &mark)
{
    m_mark = mark;
    lineEdit()->setText(textFromValue(value()));
}

void NumberField::setError(const QString &sentence)
{
    const bool invalid = !sentence.isEmpty();
    setAccessibleDescription(sentence);
    setToolTip(sentence);
    if (property("invalid").toBool() == invalid)
        return;
    setProperty("invalid", invalid);
    update();
}

QString NumberField::textFromValue(double value) const
{
    return m_mark + numberText(value, decimals(), locale()).remove(QChar(0x2009));
}

// As the locale reads numbers, whatever sign or space it was typed with.
static QString plain(QString text, const QString &mark)
{
    if (!mark.isEmpty() && text.startsWith(mark))
        text.remove(0, mark.size());
    text.replace(kMinus, QLatin1Char('-'));
    text.remove(QChar(0x2009)).remove(QChar(0x202F)).remove(QChar(0x00A0)).remove(QLatin1Char(' '));
    return text;
}

double NumberField::valueFromText(const QString &text) const
{
    const QString number = plain(text, m_mark);
    bool fine = false;
    double value = locale().toDouble(number, &fine);
    if (!fine)
        value = QLocale::c().toDouble(number, &fine);
    return fine ? value : this->value();
}

QValidator::State NumberField::validate(QString &text, int &) const
{
    const QString number = plain(text, m_mark);
    if (number.isEmpty() || number == QLatin1String("-"))
        return QValidator::Intermediate;
    bool fine = false;
    double value = locale().toDouble(number, &fine);
    if (!fine)
        value = QLocale::c().toDouble(number, &fine);
    if (!fine)
        return QValidator::Invalid;
    return value < minimum() || value > maximum() ? QValidator::Intermediate : QValidator::Acceptable;
}

QSize NumberField::sizeHint() const
{
    ensurePolished();
    const QFontMetrics metrics(font());
    const int number = std::max(metrics.horizontalAdvance(textFromValue(minimum())),
                                metrics.horizontalAdvance(textFromValue(std::min(maximum(), 9999.0))));
    const int arrows = buttonSymbols() == NoButtons ? 0 : kArrowRoom;
    return {number + m_unit->sizeHint().width() + arrows + 20,
            std::max(kControlHeight, metrics.height() + 4)};
}

void NumberField::resizeEvent(QResizeEvent *event)
{
    QDoubleSpinBox::resizeEvent(event);
    placeUnit();
}

void NumberField::placeUnit()
{
    const int arrows = buttonSymbols() == NoButtons ? 0 : kArrowRoom;
    const int unit = m_unit->text().isEmpty() ? 0 : m_unit->sizeHint().width();
    m_unit->setGeometry(width() - arrows - unit - 6, 1, unit, height() - 2);
    lineEdit()->setTextMargins(2, 0, unit > 0 ? unit + 4 : 0, 0);
    m_unit->raise();
}

// Written anew as the language writes numbers; the value stays.
void NumberField::changeEvent(QEvent *event)
{
    QDoubleSpinBox::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    setLocale(QLocale());
    setSpecialValueText(specialValueText());
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    // A page that is scrolled must not change what the mouse happens to be over.
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace driftbench
