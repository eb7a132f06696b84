// Which figures a report has, and how each is made from the data.
//
// What takes long (predictions over whole runs, Allan deviations, dots) is done by prepareFigures, on any
// thread; each figure is then a widget, made and drawn in the thread of the application, one at a time.
#pragma once

#include "app/report/report_data.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/evaluation/judged_traces.h"
#include "widgets/plot/plot_view.h"
#include "widgets/style/palette.h"
#include "widgets/views/residual_view.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QString>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace driftbench {

// A figure that was written as <stem>.svg, .pdf and .png.
struct WrittenFigure
{
    std::string stem;
    QString title;
    QString caption;
};

// A run that was held out, with the model that never saw it.
struct HeldOutRun
{
    const ReportRun *run = nullptr;
    const TrainedModel *model = nullptr;
    Eigen::MatrixX3d residualDps;
    JudgedTraces traces;
};

struct PreparedFigures
{
    std::shared_ptr<const ReportData> data;
    std::vector<HeldOutRun> heldOut;       // points into data
    std::array<TcqScatterData, 3> scatter; // of each axis
    std::array<TcqDots, 3> dots;           // likewise
    ResidualTraces residuals;
};

// Errc::Cancelled if the hook says Stop.
Result<PreparedFigures> prepareFigures(std::shared_ptr<const ReportData> data, const ProgressHook &hook = {});

struct FigureTask
{
    std::string stem; // of its files
    QString title;
    QString caption;
    // origin: what the figure says about where its data come from; may be empty. The view may turn out empty.
    std::function<std::unique_ptr<PlotView>(const QString &origin)> make;
};

// judged: the held-out runs as the page Compare shows them, beside the rest.
std::vector<FigureTask> figureTasks(const std::shared_ptr<const PreparedFigures> &prepared,
                                    const Palette &look, bool judged = false);

// Of the data's first and last fold: "trained on run1, run3".
QString trainedOnText(const TrainedModel &model);

// fig7_tcq_over_time, fig8_tcq_against_tde_<axis>, fig10_before_after_<run>, residuals, allan_<run>, centres;
// those for which there are data. Errors: OutputNotWritable, OutputFull.
Result<std::vector<WrittenFigure>> writeFigures(const ReportData &data, const Palette &look,
                                                const std::filesystem::path &folder);

} // namespace driftbench
