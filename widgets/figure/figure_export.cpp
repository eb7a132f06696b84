#include "widgets/figure/figure_export.h"

#include "engine/base/atomic_file.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qcustomplot.h>

namespace driftbench {

static constexpr int kDpi = 96;
static constexpr double kPointsPerInch = 72.0;

// Also for pictures of pixels: QCustomPlot otherwise draws lines of 1 px as one device pixel, too thin at
// twice the size.
static void paintFigure(PlotView &view, QPaintDevice &device, const QSize &size)
{
    QCPPainter painter;
    painter.begin(&device);
    painter.setMode(QCPPainter::pmVectorized, true);
    painter.setMode(QCPPainter::pmNoCaching, true);
    painter.fillRect(QRect(QPoint(0, 0), size), view.look().base);
    view.plot().toPainter(&painter, size.width(), size.height());
    painter.end();
}

QByteArray figureAsSvg(PlotView &view, const QSize &size, const FigureText &text)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kDpi);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setTitle(text.title);
    generator.setDescription(text.description);
    paintFigure(view, generator, size);
    return bytes;
}

QByteArray figureAsPdf(PlotView &view, const QSize &size, const FigureText &text)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kDpi);
    writer.setPageSize(
        QPageSize(QSizeF(size) * kPointsPerInch / kDpi, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(text.title);
    writer.setCreator(QStringLiteral("Driftbench"));
    paintFigure(view, writer, size);
    return bytes;
}

QImage figureAsImage(PlotView &view, const QSize &size, double pixelRatio)
{
    QImage image(size * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    paintFigure(view, image, size);
    return image;
}

QPicture figureAsPicture(PlotView &view, const QSize &size)
{
    QPicture picture;
    paintFigure(view, picture, size);
    return picture;
}

QByteArray figureAsPng(PlotView &view, const QSize &size, double pixelRatio)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    figureAsImage(view, size, pixelRatio).save(&buffer, "PNG");
    return bytes;
}

Status saveFigure(PlotView &view, const std::filesystem::path &file, const FigureText &text)
{
    QByteArray bytes;
    if (file.extension() == ".svg")
        bytes = figureAsSvg(view, view.figureSize(), text);
    else if (file.extension() == ".pdf")
        bytes = figureAsPdf(view, view.figureSize(), text);
    else if (file.extension() == ".png")
        bytes = figureAsPng(view, view.figureSize());
    else
        return Error{Errc::InvalidOption, "A figure can't be saved as " + file.string() +
                                              ": give it the ending .svg, .pdf or .png."};
    return writeFileAtomically(file,
                               std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

} // namespace driftbench
