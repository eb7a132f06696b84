#include "widgets/figure/figure_export.h"

#include "engine/base/atomic_file.h"
#include "widgets/figure/plot_picture.h"

#include <QBuffer>

namespace driftbench {

QByteArray figureAsSvg(PlotView &view, const QSize &size, const FigureText &text)
{
    return plotAsSvg(view.plot(), size, view.look().base, text.title, text.description);
}

QByteArray figureAsPdf(PlotView &view, const QSize &size, const FigureText &text)
{
    return plotAsPdf(view.plot(), size, view.look().base, text.title);
}

QImage figureAsImage(PlotView &view, const QSize &size, double pixelRatio)
{
    QImage image(size * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    paintPlot(view.plot(), image, size, view.look().base);
    return image;
}

QPicture figureAsPicture(PlotView &view, const QSize &size)
{
    QPicture picture;
    paintPlot(view.plot(), picture, size, view.look().base);
    return picture;
}

QByteArray figureAsPng(PlotView &view, const QSize &size, double pixelRatio)
{
    return plotAsPng(view.plot(), size, view.look().base, pixelRatio);
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
