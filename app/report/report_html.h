// A report as one HTML file: plots as inline SVG, no other file, no script.
#pragma once

#include "app/report/report_document.h"

#include <QByteArray>

namespace driftbench {

QByteArray reportAsHtml(const ReportDocument &document, const Palette &look);

} // namespace driftbench
