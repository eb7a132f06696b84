// The system's file dialogs without blocking the window, starting in the folder that was used last.
#pragma once

#include <QString>

#include <filesystem>
#include <functional>
#include <vector>

class QWidget;

namespace driftbench {

class Workbench;

using OnFile = std::function<void(const std::filesystem::path &)>;
using OnFiles = std::function<void(const std::vector<std::filesystem::path> &)>;

void askOpenFile(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                 OnFile chosen);
void askOpenFiles(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                  OnFiles chosen);
void askSaveFile(QWidget &parent, Workbench &bench, const QString &title, const QString &filter,
                 const QString &name, OnFile chosen);

} // namespace driftbench
