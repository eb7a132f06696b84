// index.html of a report: verdicts in words, the table of the comparison, and all figures with their
// captions.
#pragma once

#include "app/report/figure_list.h"
#include "app/report/report_data.h"
#include "widgets/style/palette.h"

#include <QString>

namespace driftbench {

// For other pages in the same look: all up to the body's first line, and one figure with its caption and
// links. The title is HTML.
QString pageStart(const QString &title, const Palette &look);
QString figureBlock(const WrittenFigure &figure);

QString indexPage(const ReportData &data, const std::vector<WrittenFigure> &figures, const Palette &look);

} // namespace driftbench
