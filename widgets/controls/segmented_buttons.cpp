#include "widgets/controls/segmented_buttons.h"

#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

namespace driftbench {

namespace {

class Segment : public QToolButton
{
public:
    Segment(ButtonSize size, QWidget *parent) : QToolButton(parent), m_size(size)
    {
        setCheckable(true);
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
    }

    void setPlace(bool first, bool last)
    {
        m_first = first;
        m_last = last;
    }

    QSize sizeHint() const override
    {
        const bool head = m_size == ButtonSize::Head;
        const QFontMetrics metrics(head ? sectionFont() : strongNoteFont());
        return {metrics.horizontalAdvance(text()) + (head ? 24 : 20),
                std::max(head ? kHeadHeight : kControlHeight, metrics.height() + 4)};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        const Palette &look = lookOf(palette());
        ControlState state;
        state.enabled = isEnabled();
        state.hovered = underMouse();
        state.pressed = isDown();
        state.checked = isChecked();
        const BoxPaint box = buttonBox(look, state);
        QPainter painter(this);
        painter.setClipRect(rect());
        // The outer corners are round; towards a neighbour the box goes on beyond what is shown.
        const QRect whole = rect().adjusted(m_first ? 0 : -8, 0, m_last ? 0 : 8, 0);
        paintBox(painter, whole, box);
        if (!m_last) {
            painter.setPen(look.border);
            painter.drawLine(width() - 1, 1, width() - 1, height() - 2);
        }
        if (hasFocus())
            paintBox(painter, rect(), {QColor(), look.accent, 2});
        const bool head = m_size == ButtonSize::Head;
        painter.setFont(isChecked() ? (head ? sectionFont() : strongNoteFont())
                                    : (head ? bodyFont() : noteFont()));
        painter.setPen(buttonTextColor(look, state));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextSingleLine, text());
    }

private:
    ButtonSize m_size;
    bool m_first = true;
    bool m_last = true;
};

} // namespace

SegmentedButtons::SegmentedButtons(const QString &accessibleName, ButtonSize size, QWidget *parent)
    : QWidget(parent), m_layout(new QHBoxLayout(this)), m_size(size)
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(0);
    connect(&m_group, &QButtonGroup::idToggled, this, [this](int id, bool on) {
        if (on)
            emit currentChanged(id);
    });
}

void SegmentedButtons::setTexts(const QStringList &texts)
{
    while (m_group.buttons().size() > texts.size()) {
        QAbstractButton *last = m_group.button(static_cast<int>(m_group.buttons().size()) - 1);
        m_group.removeButton(last);
        delete last;
    }
    for (int i = 0; i < texts.size(); ++i) {
        auto *segment = static_cast<Segment *>(m_group.button(i));
        if (!segment) {
            segment = new Segment(m_size, this);
            segment->setSizePolicy(m_stretched ? QSizePolicy::Expanding : QSizePolicy::Fixed,
                                   QSizePolicy::Fixed);
            m_group.addButton(segment, i);
            m_layout->addWidget(segment);
        }
        segment->setText(texts[i]);
        segment->setAccessibleName(texts[i]);
        segment->setPlace(i == 0, i == texts.size() - 1);
        segment->updateGeometry();
        segment->update();
    }
    setStretched(m_stretched);
}

int SegmentedButtons::current() const
{
    return m_group.checkedId();
}

void SegmentedButtons::setCurrent(int index)
{
    if (QAbstractButton *wanted = m_group.button(index))
        wanted->setChecked(true);
}

void SegmentedButtons::setStretched(bool stretched)
{
    m_stretched = stretched;
    setSizePolicy(stretched ? QSizePolicy::Expanding : QSizePolicy::Fixed, QSizePolicy::Fixed);
    for (int i = 0; i < m_layout->count(); ++i) {
        m_layout->setStretch(i, stretched ? 1 : 0);
        m_layout->itemAt(i)->widget()->setSizePolicy(stretched ? QSizePolicy::Expanding : QSizePolicy::Fixed,
                                                     QSizePolicy::Fixed);
    }
}

QAbstractButton *SegmentedButtons::button(int index) const
{
    return m_group.button(index);
}

} // namespace driftbench
