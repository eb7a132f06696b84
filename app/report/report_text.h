// The sentences of a report, in the language of the program.
#pragma once

#include <QCoreApplication>
#include <QLocale>

namespace driftbench {

class ReportText
{
    Q_DECLARE_TR_FUNCTIONS(driftbench::ReportText)
};

// While it lives, numbers are written as files have them, whatever the user's locale is. For the thread of
// the application, and never across its event loop.
class FileNumbers
{
public:
    FileNumbers() { QLocale::setDefault(QLocale::c()); }
    ~FileNumbers() { QLocale::setDefault(m_before); }
    FileNumbers(const FileNumbers &) = delete;
    FileNumbers &operator=(const FileNumbers &) = delete;

private:
    QLocale m_before;
};

} // namespace driftbench
