// What happened, for whoever wants to look it up: every message that was a banner, and what the device and
// the jobs said beside it. The latest events of this start of the program, oldest first.
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>

#include <deque>

namespace driftbench {

enum class EventKind
{
    Info,
    Caution,
    Bad
};

class EventLog : public QAbstractTableModel
{
    Q_OBJECT

public:
    static constexpr int kMostEvents = 5000; // older ones go

    explicit EventLog(QObject *parent = nullptr);

    void add(EventKind kind, const QString &sentence);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QString asText() const; // one line an event, for the clipboard

private:
    struct Event
    {
        QDateTime when;
        EventKind kind;
        QString sentence;
    };

    std::deque<Event> m_events;
};

} // namespace driftbench
