// The type sizes of the workbench. Open Sans where it is installed (tabular figures, a minus as wide as a
// figure), else the system's sans. Nothing is set smaller than 9 pt.
#pragma once

#include <QFont>

namespace driftbench {

QFont bodyFont();       // 10 pt: text, tables, controls
QFont sectionFont();    // 10 pt semibold: section heads, the axis name over a plot
QFont noteFont();       // 9 pt: notes, table heads, plot text
QFont strongNoteFont(); // 9 pt semibold: the main series in a margin, the head of a legend
QFont resultFont();     // 12 pt semibold: verdicts and results
QFont pageTitleFont();  // 15 pt semibold

} // namespace driftbench
