#include "app/gui/export/upload_steps.h"

#include "widgets/controls/icon.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QPainter>

namespace driftbench {

static constexpr int kLine = 15;

UploadSteps::UploadSteps(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QString UploadSteps::nameOf(int step) const
{
    switch (step) {
    case Begin:
        return tr("Begin");
    case Write:
        return tr("Write");
    case ReadBack:
        return tr("Read back");
    case Verify:
        return tr("Verify");
    case Commit:
        return tr("Commit");
    default:
        return tr("Activate");
    }
}

QString UploadSteps::iconOf(int step) const
{
    if (m_state == State::Done || (m_state != State::Idle && step < m_current))
        return QStringLiteral("check");
    if (step == m_current && m_state == State::Running)
        return QStringLiteral("half");
    if (step == m_current && m_state == State::Failed)
        return QStringLiteral("cross");
    return QStringLiteral("ring");
}

void UploadSteps::setState(State state, Step current)
{
    m_state = state;
    m_current = current;
    showName();
    update();
}

void UploadSteps::showName()
{
    setAccessibleName(m_state == State::Idle ? tr("No upload under way")
                      : m_state == State::Done
                          ? tr("Upload done")
                          : tr("Upload, step %1 of 6: %2").arg(m_current + 1).arg(nameOf(m_current)));
}

void UploadSteps::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showName();
}

void UploadSteps::setDetail(Step step, const QString &detail)
{
    if (m_details[step] == detail)
        return;
    m_details[step] = detail;
    update();
}

QSize UploadSteps::sizeHint() const
{
    return {kSteps * 88, std::max(34, QFontMetrics(noteFont()).height() * 2 + 4)};
}

void UploadSteps::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    QPainter painter(this);
    for (int step = 0; step < kSteps; ++step) {
        const int left = width() * step / kSteps;
        const int room = width() / kSteps - kSmallIcon - 10;
        const QString icon = iconOf(step);
        const bool done = icon == QStringLiteral("check");
        const bool failed = icon == QStringLiteral("cross");
        const bool current = icon == QStringLiteral("half");
        const QColor color = done ? look.good : failed ? look.bad : current ? look.accent : look.mutedText;
        paintIcon(painter, QRect(left, (height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon), icon, color);
        const int textLeft = left + kSmallIcon + 6;
        const int middle = height() / 2;
        painter.setFont(current || failed ? strongNoteFont() : noteFont());
        painter.setPen(done || current || failed ? look.text : look.mutedText);
        const bool two = !m_details[static_cast<std::size_t>(step)].isEmpty();
        const QRect name(textLeft, two ? middle - kLine - 1 : middle - kLine / 2, room, kLine + 2);
        painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(nameOf(step), Qt::ElideRight, room));
        if (!two)
            continue;
        painter.setFont(noteFont());
        painter.setPen(look.mutedText);
        const QString detail =
            painter.fontMetrics().elidedText(m_details[static_cast<std::size_t>(step)], Qt::ElideRight, room);
        painter.drawText(QRect(textLeft, middle, room, kLine + 2), Qt::AlignLeft | Qt::AlignVCenter, detail);
    }
}

} // namespace driftbench
