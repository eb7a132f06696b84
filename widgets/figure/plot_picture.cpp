#include "widgets/figure/plot_picture.h"

#include "engine/base/atomic_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qcustomplot.h>

namespace driftbench {

static constexpr int kDpi = 96;
static constexpr double kPointsPerInch = 72.0;

// Also for pictures of pixels: QCustomPlot otherwise draws lines of 1 px as one device pixel, too thin at
// twice the size.
void paintPlot(QCustomPlot &plot, QPaintDevice &device, const QSize &size, const QColor &background)
{
    QCPPainter painter;
    painter.begin(&device);
    painter.setMode(QCPPainter::pmVectorized, true);
    painter.setMode(QCPPainter::pmNoCaching, true);
    painter.fillRect(QRect(QPoint(0, 0), size), background);
    plot.toPainter(&painter, size.width(), size.height());
    painter.end();
}

QByteArray plotAsSvg(QCustomPlot &plot, const QSize &size, const QColor &background, const QString &title,
                     const QString &description)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kDpi);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setTitle(title);
    generator.setDescription(description);
    paintPlot(plot, generator, size, background);
    return bytes;
}

QByteArray plotAsPdf(QCustomPlot &plot, const QSize &size, const QColor &background, const QString &title)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kDpi);
    writer.setPageSize(
        QPageSize(QSizeF(size) * kPointsPerInch / kDpi, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Driftbench"));
    paintPlot(plot, writer, size, background);
    return bytes;
}

QByteArray plotAsPng(QCustomPlot &plot, const QSize &size, const QColor &background, double pixelRatio)
{
    QImage image(size * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    paintPlot(plot, image, size, background);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

Status savePlot(QCustomPlot &plot, const QString &file, const QString &title, const QColor &background,
                const PlotTable &table)
{
    const QString ending = QFileInfo(file).suffix().toLower();
    const QSize size = plot.size();
    QByteArray bytes;
    if (ending == QLatin1String("svg"))
        bytes = plotAsSvg(plot, size, background, title);
    else if (ending == QLatin1String("pdf"))
        bytes = plotAsPdf(plot, size, background, title);
    else if (ending == QLatin1String("png"))
        bytes = plotAsPng(plot, size, background);
    else if (ending == QLatin1String("csv"))
        bytes = plotTableAsCsv(table);
    else
        return Error{Errc::InvalidOption, "A plot can't be saved as " + file.toStdString() +
                                              ": give it the ending .png, .svg, .pdf or .csv."};
    return writeFileAtomically(file.toStdString(),
                               std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

} // namespace driftbench
