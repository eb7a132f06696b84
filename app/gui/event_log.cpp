#include "app/gui/event_log.h"

#include "widgets/controls/icon.h"
#include "widgets/controls/state_word.h"
#include "widgets/style/theme.h"

#include <QGuiApplication>

namespace driftbench {

enum Column
{
    kTime,
    kSentence,
    kColumns
};

EventLog::EventLog(QObject *parent) : QAbstractTableModel(parent) {}

void EventLog::add(EventKind kind, const QString &sentence)
{
    if (static_cast<int>(m_events.size()) == kMostEvents) {
        beginRemoveRows({}, 0, 0);
        m_events.pop_front();
        endRemoveRows();
    }
    const int row = static_cast<int>(m_events.size());
    beginInsertRows({}, row, row);
    m_events.push_back({QDateTime::currentDateTime(), kind, sentence});
    endInsertRows();
}

int EventLog::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_events.size());
}

int EventLog::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

static Tone toneOf(EventKind kind)
{
    return kind == EventKind::Info ? Tone::Plain : kind == EventKind::Caution ? Tone::Caution : Tone::Bad;
}

QVariant EventLog::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Event &event = m_events[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return index.column() == kTime ? event.when.toString(QStringLiteral("HH:mm:ss")) : event.sentence;
    if (role == Qt::ToolTipRole && index.column() == kSentence)
        return event.sentence;
    if (role == Qt::DecorationRole && index.column() == kSentence) {
        const Tone tone = toneOf(event.kind);
        const QColor color = textColor(TextRole::Note, tone, lookOf(QGuiApplication::palette()));
        return iconPixmap(iconOfTone(tone), kSmallIcon, color, qApp->devicePixelRatio());
    }
    return {};
}

QVariant EventLog::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == kTime ? tr("Time") : tr("What happened");
}

QString EventLog::asText() const
{
    QString text;
    for (const Event &event : m_events)
        text += event.when.toString(Qt::ISODate) + QLatin1Char(' ') + event.sentence + QLatin1Char('\n');
    return text;
}

} // namespace driftbench
