// driftbench-cli as its users run it: a process with arguments, an exit code and two streams.
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <optional>

namespace driftbench::test {

struct Outcome
{
    int exitCode; // -1: ended by a signal
    QByteArray output;
    QByteArray errors;
};

QString cliPath();

// Waits for the end of a process that was started; five minutes without one are fatal.
Outcome finish(QProcess &process);
Outcome runCli(const QStringList &arguments);

// A shell script in which "$1" is the folder, a file system of its own with room for so much, and "$2" the
// program; nothing where the machine does not let a test mount one.
std::optional<Outcome> runOnSmallDisk(const QString &folder, const QString &size, const QString &script);

QByteArray bytesOf(const QString &path);
void writeBytes(const QString &path, const QByteArray &bytes);

// Names, hidden ones as well, sorted.
QStringList filesIn(const QString &folder);
// All files below, as paths from there, sorted.
QStringList filesBelow(const QString &folder);

// "driftbench-cli: " and one line that ends with a full stop.
bool isOneSentence(const QByteArray &errors);

// One that is expected to succeed without a word on standard error.
void simulateQuietly(const QString &folder, const QStringList &more = {});

} // namespace driftbench::test
