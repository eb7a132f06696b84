#include "app/gui/step_rail.h"

#include "widgets/controls/icon.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace driftbench {

static constexpr int kWidth = 184;
static constexpr int kStepHeight = 48;
static constexpr int kTop = 8;
static constexpr int kNameLeft = 44;
static constexpr int kMarkRight = 9;

void StepModel::setState(Step step, const StepState &state)
{
    m_states[static_cast<std::size_t>(step)] = state;
    const QModelIndex changed = index(static_cast<int>(step));
    emit dataChanged(changed, changed);
}

const StepState &StepModel::state(Step step) const
{
    return m_states[static_cast<std::size_t>(step)];
}

void StepModel::retranslate()
{
    emit dataChanged(index(0), index(rowCount() - 1));
}

int StepModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(kSteps.size());
}

static QString markWord(StepMark mark)
{
    switch (mark) {
    case StepMark::Done:
        return StepRail::tr("done");
    case StepMark::Warning:
        return StepRail::tr("has warnings");
    case StepMark::Recording:
        return StepRail::tr("recording");
    case StepMark::Working:
        return StepRail::tr("working");
    case StepMark::None:
        break;
    }
    return {};
}

QVariant StepModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Step step = kSteps[static_cast<std::size_t>(index.row())];
    const StepState &own = state(step);
    const QString note = own.note.isEmpty() ? stepPurpose(step) : own.note;
    switch (role) {
    case Qt::DisplayRole:
        return stepName(step);
    case Qt::ToolTipRole:
        return StepRail::tr("%1 (Alt+%2)").arg(stepName(step)).arg(index.row() + 1);
    case Qt::AccessibleTextRole:
        return QStringList({stepName(step), note, markWord(own.mark)}).join(QStringLiteral(", "));
    case NoteRole:
        return note;
    case HoldsRole:
        return own.holds;
    case MarkRole:
        return static_cast<int>(own.mark);
    case IconRole:
        return stepIcon(step);
    default:
        return {};
    }
}

namespace {

struct MarkPaint
{
    QString icon;
    QColor color;
};

MarkPaint markPaint(StepMark mark, const Palette &look)
{
    switch (mark) {
    case StepMark::Done:
        return {QStringLiteral("check"), look.good};
    case StepMark::Warning:
        return {QStringLiteral("warn"), look.caution};
    case StepMark::Recording:
        return {QStringLiteral("dot"), look.bad};
    case StepMark::Working:
        return {QStringLiteral("half"), look.accent};
    case StepMark::None:
        break;
    }
    return {};
}

class StepDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override
    {
        const int text = QFontMetrics(bodyFont()).height() + QFontMetrics(noteFont()).height() + 8;
        return {kWidth, std::max(kStepHeight, text)};
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const Palette &look = lookOf(option.palette);
        const QRect row = option.rect;
        const bool current = option.state & QStyle::State_Selected;
        const bool holds = current || index.data(StepModel::HoldsRole).toBool();
        if (current) {
            painter->fillRect(row, look.page);
            painter->fillRect(QRect(row.left(), row.top(), 3, row.height()), look.accent);
        } else if (option.state & QStyle::State_MouseOver) {
            painter->fillRect(row.adjusted(0, 0, -1, 0), look.grid);
        }
        const QColor color = holds ? look.text : look.mutedText;
        paintIcon(*painter, QRect(row.left() + 16, row.top() + (row.height() - kIcon) / 2, kIcon, kIcon),
                  index.data(StepModel::IconRole).toString(), color);
        const auto mark = static_cast<StepMark>(index.data(StepModel::MarkRole).toInt());
        const int right = mark == StepMark::None ? 8 : kMarkRight + kSmallIcon + 4;
        paintTexts(*painter, row.adjusted(kNameLeft, 0, -right, 0), index, current, color, look);
        if (const MarkPaint paint = markPaint(mark, look); !paint.icon.isEmpty()) {
            const QRect place(row.right() - kMarkRight - kSmallIcon + 1,
                              row.top() + (row.height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon);
            paintIcon(*painter, place, paint.icon, paint.color);
        }
        if (current && (option.state & QStyle::State_HasFocus))
            paintBox(*painter, row.adjusted(5, 2, -3, -2), {QColor(), look.accent, 2});
    }

private:
    static void paintTexts(QPainter &painter, const QRect &place, const QModelIndex &index, bool current,
                           const QColor &color, const Palette &look)
    {
        const QFont name = current ? sectionFont() : bodyFont();
        const QFontMetrics nameMetrics(name);
        const QFontMetrics noteMetrics(noteFont());
        const int apart = noteMetrics.height() - 1;
        const int nameBase =
            place.top() + (place.height() - nameMetrics.capHeight() - apart) / 2 + nameMetrics.capHeight();
        painter.setFont(name);
        painter.setPen(color);
        painter.drawText(place.left(), nameBase, index.data(Qt::DisplayRole).toString());
        painter.setFont(noteFont());
        painter.setPen(look.mutedText);
        const QString note =
            noteMetrics.elidedText(index.data(StepModel::NoteRole).toString(), Qt::ElideRight, place.width());
        painter.drawText(place.left(), nameBase + apart, note);
    }
};

} // namespace

StepRail::StepRail(QWidget *parent) : QListView(parent)
{
    setModel(&m_model);
    setItemDelegate(new StepDelegate(this));
    setFixedWidth(kWidth);
    setFrameShape(QFrame::NoFrame);
    setViewportMargins(0, kTop, 0, 0);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setMouseTracking(true);
    setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
    setAccessibleName(tr("Steps"));
}

void StepRail::setCurrentStep(Step step)
{
    m_silent = true;
    setCurrentIndex(m_model.index(static_cast<int>(step)));
    m_silent = false;
}

void StepRail::clearCurrentStep()
{
    m_silent = true;
    setCurrentIndex({});
    m_silent = false;
}

void StepRail::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QListView::currentChanged(current, previous);
    if (!m_silent && current.isValid())
        emit stepChosen(kSteps[static_cast<std::size_t>(current.row())]);
}

// The ground under the steps, also above the first.
bool StepRail::event(QEvent *event)
{
    if (event->type() == QEvent::Paint) {
        const Palette &look = lookOf(palette());
        QPainter painter(this);
        painter.fillRect(rect(), look.window);
        painter.fillRect(width() - 1, 0, 1, height(), look.border);
    }
    return QListView::event(event);
}

} // namespace driftbench
