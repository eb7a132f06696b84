// driftbench-report: the figures of a fit, or of the physics of the combs, as SVG, PDF, PNG and one page that
// shows them all. Needs no display.
#include "app/language/language.h"
#include "app/report/figure_list.h"
#include "app/report/index_page.h"
#include "app/report/physics_figures.h"
#include "app/report/report_data_loader.h"
#include "app/report/report_html.h"
#include "app/report/report_pdf.h"
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

struct ReportArguments
{
    std::string from;
    std::string out;
    std::string pdf;
    std::string html;
    bool dark = false;

    const Palette &look() const { return dark ? darkPalette() : lightPalette(); }
};

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

static Status writeBytes(const std::filesystem::path &file, const QByteArray &bytes)
{
    const Status written = writeFileAtomically(
        file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    if (written)
        std::printf("%s\n", file.string().c_str());
    return written;
}

// The same document as both files, where they are asked for.
static Status writeDocuments(const ReportArguments &arguments, const ReportData &data)
{
    if (arguments.pdf.empty() && arguments.html.empty())
        return {};
    const auto document =
        completeReport(std::make_shared<const ReportData>(data), QDateTime::currentDateTime());
    if (!document)
        return document.error();
    if (!arguments.pdf.empty()) {
        if (Status written = writeBytes(arguments.pdf, reportAsPdf(*document)); !written)
            return written;
    }
    if (arguments.html.empty())
        return {};
    return writeBytes(arguments.html, reportAsHtml(*document, arguments.look()));
}

static Status writeFolder(const ReportArguments &arguments, const ReportData &data)
{
    if (arguments.out.empty())
        return {};
    if (const Status folder = ensureWritableFolder(arguments.out); !folder)
        return folder;
    const auto figures = writeFigures(data, arguments.look(), arguments.out);
    if (!figures)
        return figures.error();
    return writePage(arguments.out, indexPage(data, *figures, arguments.look()), figures->size());
}

static Status writeReport(const ReportArguments &arguments)
{
    std::error_code code;
    const bool physics =
        std::filesystem::exists(std::filesystem::path(arguments.from) / kPhysicsFileName, code);
    if (arguments.out.empty() && (physics || (arguments.pdf.empty() && arguments.html.empty())))
        return Error{Errc::InvalidOption,
                     physics ? "The figures of the combs' physics are a folder of files: name it with --out."
                             : "Nothing to write: name a file with --pdf or --html, or a folder with --out."};
    if (physics)
        return writePhysicsReport(arguments.from, arguments.out, arguments.look());
    const auto data = loadReportData(arguments.from);
    if (!data)
        return data.error();
    for (const std::string &warning : data->warnings)
        std::fprintf(stderr, "driftbench-report: %s\n", warning.c_str());
    if (Status written = writeFolder(arguments, *data); !written)
        return written;
    return writeDocuments(arguments, *data);
}

} // namespace driftbench

int main(int argc, char **argv)
{
    using namespace driftbench;
    CLI::App app("Writes what a fit or a session found as a report, PDF or one HTML file, and its figures, "
                 "or those of "
                 "the combs' physics, as SVG, PDF and PNG with an index.html that shows them all.",
                 "driftbench-report");
    app.footer("Example:\n"
               "  driftbench-cli fit run1.csv run2.csv run3.csv --out fit\n"
               "  driftbench-report fit --pdf report.pdf --html report.html --out figures\n"
               "Exit status: 0, or the number of the error as listed for driftbench-cli.");
    ReportArguments arguments;
    app.add_option("FROM", arguments.from,
                   "Folder that `driftbench-cli fit --out` or `physics --out` wrote, or a session")
        ->required();
    app.add_option("--out", arguments.out, "Folder for the figures as files; made if it is not there");
    app.add_option("--pdf", arguments.pdf, "The report as this PDF file");
    app.add_option("--html", arguments.html, "The report as this one HTML file, with its figures inside");
    app.add_flag("--dark", arguments.dark, "Dark figures, dark HTML; PDF is light");
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
    Language language;
    language.set(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
    const Status status = writeReport(arguments);
    if (!status) {
        std::fprintf(stderr, "driftbench-report: %s\n", status.error().message.c_str());
        return static_cast<int>(status.error().code);
    }
    return 0;
}
