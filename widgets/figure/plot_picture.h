// A plot as it stands on the screen, as a file: what is visible, in the size it has there. SVG and PDF as
// true vectors, PNG at twice the size, CSV the data in view.
#pragma once

#include "engine/base/result.h"
#include "widgets/plot/plot_table.h"

#include <QByteArray>
#include <QColor>
#include <QSize>
#include <QString>

class QCustomPlot;
class QPaintDevice;

namespace driftbench {

// At 96 dpi, for any size.
void paintPlot(QCustomPlot &plot, QPaintDevice &device, const QSize &size, const QColor &background);

QByteArray plotAsSvg(QCustomPlot &plot, const QSize &size, const QColor &background, const QString &title,
                     const QString &description = {});
QByteArray plotAsPdf(QCustomPlot &plot, const QSize &size, const QColor &background, const QString &title);
QByteArray plotAsPng(QCustomPlot &plot, const QSize &size, const QColor &background, double pixelRatio = 2.0);

// The format follows the ending: .png, .svg, .pdf or .csv (else Errc::InvalidOption).
Status savePlot(QCustomPlot &plot, const QString &file, const QString &title, const QColor &background,
                const PlotTable &table);

} // namespace driftbench
