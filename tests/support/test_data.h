// Where tests find the project's own files, its programs and recorded data of others, and how they skip, by
// name and aloud, where the data are missing. Paths are known here only: what else is compiled is the same in
// every checkout.
#pragma once

#include <QString>
#include <QTest>

#include <filesystem>

namespace driftbench::test {

QString sourceFolder();  // of the checkout
QString programFolder(); // driftbench-cli and the others, as built

// The shared data folder beside the checkout (or DRIFTBENCH_SHARED_DATA); empty if it is not there.
std::filesystem::path sharedData();

// Folder for what a test writes; goes with the test program.
std::filesystem::path scratchFolder();

} // namespace driftbench::test

// Leaves the test function with a skip that names the missing file; else `variable` names it.
#define REQUIRE_SHARED_DATA(variable, relative)                                                              \
    const std::filesystem::path variable = driftbench::test::sharedData() / (relative);                      \
    if (driftbench::test::sharedData().empty() || !std::filesystem::exists(variable))                        \
    QSKIP(qPrintable(QStringLiteral("the shared data folder has no ") + QString::fromUtf8(relative)))
