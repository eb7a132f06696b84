#include "app/gui/file_dialogs.h"

#include "app/gui/workbench.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace driftbench {

static QFileDialog *makeDialog(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                               const OnFiles &chosen)
{
    auto *dialog = new QFileDialog(&parent, title, bench.settings().lastFolder, filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::filesSelected, &bench, [&bench, chosen](const QStringList &names) {
        if (names.isEmpty())
            return;
        bench.changeSettings(
            [&](Settings &settings) { settings.lastFolder = QFileInfo(names.front()).absolutePath(); });
        std::vector<std::filesystem::path> files;
        for (const QString &name : names)
            files.emplace_back(name.toStdString());
        chosen(files);
    });
    return dialog;
}

static OnFiles firstOf(OnFile chosen)
{
    return [chosen = std::move(chosen)](const std::vector<std::filesystem::path> &files) {
        chosen(files.front());
    };
}

void askOpenFile(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                 OnFile chosen)
{
    QFileDialog *dialog = makeDialog(parent, bench, title, filter, firstOf(std::move(chosen)));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->open();
}

void askOpenFiles(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                  OnFiles chosen)
{
    QFileDialog *dialog = makeDialog(parent, bench, title, filter, std::move(chosen));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->open();
}

void askSaveFile(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                 const QString &name, OnFile chosen)
{
    QFileDialog *dialog = makeDialog(parent, bench, title, filter, firstOf(std::move(chosen)));
    dialog->setFileMode(QFileDialog::AnyFile);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    dialog->selectFile(name);
    dialog->open();
}

} // namespace driftbench
