#include "support/cli_process.h"

#include "support/test_data.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

namespace driftbench::test {

QString cliPath()
{
    return programFolder() + "/driftbench-cli";
}

Outcome finish(QProcess &process)
{
    constexpr int kPatienceMs = 300000; // the longest command takes a minute under the sanitizers
    if (!process.waitForFinished(kPatienceMs))
        qFatal("%s did not end", qPrintable(process.program()));
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

Outcome runCli(const QStringList &arguments)
{
    QProcess process;
    process.start(cliPath(), arguments);
    return finish(process);
}

std::optional<Outcome> runOnSmallDisk(const QString &folder, const QString &size, const QString &script)
{
    const QStringList ownMounts{"-r", "-m"};
    QProcess probe;
    probe.start("unshare", ownMounts + QStringList{"mount", "-t", "tmpfs", "tmpfs", folder});
    if (!probe.waitForFinished() || probe.exitStatus() != QProcess::NormalExit || probe.exitCode() != 0)
        return std::nullopt;
    QProcess process;
    process.start("unshare",
                  ownMounts + QStringList{"sh", "-c",
                                          "mount -t tmpfs -o size=" + size + " tmpfs \"$1\" && " + script,
                                          "sh", folder, cliPath()});
    return finish(process);
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("can't read %s", qPrintable(path));
    return file.readAll();
}

void writeBytes(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("can't write %s", qPrintable(path));
}

QStringList filesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

QStringList filesBelow(const QString &folder)
{
    QStringList files;
    QDirIterator all(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (all.hasNext())
        files.append(QDir(folder).relativeFilePath(all.next()));
    files.sort();
    return files;
}

bool isOneSentence(const QByteArray &errors)
{
    return errors.startsWith("driftbench-cli: ") && errors.endsWith(".\n") && errors.count('\n') == 1;
}

void simulateQuietly(const QString &folder, const QStringList &more)
{
    const Outcome outcome = runCli(QStringList{"simulate", "--out", folder, "--profile", "quick"} + more);
    if (outcome.exitCode != 0 || !outcome.errors.isEmpty())
        qFatal("simulate failed: %s", outcome.errors.constData());
}

} // namespace driftbench::test
