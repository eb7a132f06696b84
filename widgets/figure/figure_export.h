// Views as files: SVG and PDF as true vectors with selectable text, PNG at twice the size. The picture is
// laid out for size (px at 96 dpi), whatever size the view has on the screen. Needs a QApplication; no
// display.
#pragma once

#include "engine/base/result.h"
#include "widgets/plot/plot_view.h"

#include <QByteArray>
#include <QImage>
#include <QPicture>

#include <filesystem>

namespace driftbench {

struct FigureText
{
    QString title;
    QString description;
};

QByteArray figureAsSvg(PlotView &view, const QSize &size, const FigureText &text);
QByteArray figureAsPdf(PlotView &view, const QSize &size, const FigureText &text);
QImage figureAsImage(PlotView &view, const QSize &size, double pixelRatio = 2.0);
// To be drawn again by any painter at 96 dpi, on any thread, as vectors.
QPicture figureAsPicture(PlotView &view, const QSize &size);
QByteArray figureAsPng(PlotView &view, const QSize &size, double pixelRatio = 2.0);

// The format follows the ending: .svg, .pdf or .png (else Errc::InvalidOption). The size is the view's own.
Status saveFigure(PlotView &view, const std::filesystem::path &file, const FigureText &text);

} // namespace driftbench
