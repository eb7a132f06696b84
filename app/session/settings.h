// What the programs remember of their user from one start to the next: a plain value, read once and passed
// in, written in one place.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

class QSettings;

namespace driftbench {

enum class ThemeChoice
{
    System,
    Light,
    Dark,
};

struct Settings
{
    static constexpr int kMostRecent = 12;

    ThemeChoice theme = ThemeChoice::System;
    QString language;           // "zh"; empty: the system's
    QStringList recentSessions; // the newest first, absolute
    QStringList recentLogs;
    QString lastSession;         // open at the end, to be opened again; empty: none
    QString lastFolder;          // of the file dialogs
    QStringList bridgeIds;       // "1209:0001": what else counts as a native bridge
    QString lastSource;          // text of the source choice
    double chartHistoryS = 60.0; // shown of a live source
    QByteArray windowGeometry;   // opaque
    QByteArray windowState;
    QMap<QString, QByteArray> splitters; // by name, opaque

    bool operator==(const Settings &) const = default;
};

// What is missing or can't be has its default.
Settings loadSettings(const QSettings &store);
void saveSettings(const Settings &settings, QSettings &store);

// Puts it in front, each file once, at most kMostRecent.
void addRecent(QStringList &recent, const QString &file);

} // namespace driftbench
