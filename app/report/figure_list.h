// Which figures a report has, and how each is made from the data.
#pragma once

#include "app/report/report_data.h"
#include "engine/base/result.h"
#include "widgets/style/palette.h"

#include <QString>

#include <filesystem>
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

// fig7_tcq_over_time, fig8_tcq_against_tde_<axis>, fig10_before_after_<run>, residuals, allan_<run>, centres;
// those for which there are data. Errors: OutputNotWritable, OutputFull.
Result<std::vector<WrittenFigure>> writeFigures(const ReportData &data, const Palette &look,
                                                const std::filesystem::path &folder);

} // namespace driftbench
