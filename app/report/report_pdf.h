// A report as PDF: A4 on its side, plots as vectors with selectable text, a line at the foot of every page
// that says what it is of. Any thread.
#pragma once

#include "app/report/report_document.h"

#include <QByteArray>

namespace driftbench {

QByteArray reportAsPdf(const ReportDocument &document);

} // namespace driftbench
