// driftbench-report: the figures of a fit, or of the physics of the combs, as SVG, PDF, PNG and one page that
// shows them all. Needs no display.
#include "app/report/figure_list.h"
#include "app/report/index_page.h"
#include "app/report/physics_figures.h"
#include "app/report/report_data_loader.h"
#include "engine/base/atomic_file.h"
#include "widgets/style/palette.h"

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QHashSeed>
#include <QLocale>

#include <cstdio>
#include <filesystem>
#include <string>

namespace driftbench {

static constexpr int kUsageError = 2; // as of driftbench-cli

static Status writePage(const std::filesystem::path &report, const QString &page, std::size_t figures)
{
    const QByteArray text = page.toUtf8();
    const Status written = writeFileAtomically(
        report / "index.html", std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
    if (written)
        std::printf("%zu figures in %s\n", figures, (report / "index.html").string().c_str());
    return written;
}

static Status writePhysicsReport(const std::filesystem::path &folder, const std::filesystem::path &report,
                                 const Palette &look)
{
    const auto physics = readPhysicsFile(folder / kPhysicsFileName);
    if (!physics)
        return physics.error();
    if (const Status ready = ensureWritableFolder(report); !ready)
        return ready;
    const auto figures = writePhysicsFigures(*physics, look, report);
    if (!figures)
        return figures.error();
    return writePage(report, physicsPage(*physics, *figures, look), figures->size());
}

static Status writeReport(const std::filesystem::path &fit, const std::filesystem::path &report,
                          const Palette &look)
{
    std::error_code code;
    if (std::filesystem::exists(fit / kPhysicsFileName, code))
        return writePhysicsReport(fit, report, look);
    const auto data = loadReportData(fit);
    if (!data)
        return data.error();
    if (const Status folder = ensureWritableFolder(report); !folder)
        return folder;
    const auto figures = writeFigures(*data, look, report);
    if (!figures)
        return figures.error();
    for (const std::string &warning : data->warnings)
        std::fprintf(stderr, "driftbench-report: %s\n", warning.c_str());
    return writePage(report, indexPage(*data, *figures, look), figures->size());
}

} // namespace driftbench

int main(int argc, char **argv)
{
    using namespace driftbench;
    CLI::App app(
        "Draws the figures of a fit, or of the combs' physics, as SVG, PDF and PNG, with an index.html that "
        "shows them all.",
        "driftbench-report");
    app.footer("Example:\n"
               "  driftbench-cli fit run1.csv run2.csv run3.csv --out fit\n"
               "  driftbench-report fit --out report\n"
               "Exit status: 0, or the number of the error as listed for driftbench-cli.");
    std::string fit;
    std::string report;
    bool dark = false;
    app.add_option("DIR", fit, "Folder that `driftbench-cli fit --out` or `physics --out` wrote, or session")->required();
    app.add_option("--out", report, "Folder for the report; made if it is not there")->required();
    app.add_flag("--dark", dark, "Dark figures");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp &help) {
        return app.exit(help);
    } catch (const CLI::ParseError &problem) {
        std::fprintf(stderr, "driftbench-report: %s; see --help.\n", problem.what());
        return kUsageError;
    }

    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // The order in which axes are drawn follows a hash: the same fit shall give the same files.
    QHashSeed::setDeterministicGlobalSeed();
    const QApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    const Status status = writeReport(fit, report, dark ? darkPalette() : lightPalette());
    if (!status) {
        std::fprintf(stderr, "driftbench-report: %s\n", status.error().message.c_str());
        return static_cast<int>(status.error().code);
    }
    return 0;
}
