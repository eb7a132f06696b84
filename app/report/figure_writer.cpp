#include "app/report/figure_writer.h"

#include "widgets/figure/figure_export.h"

namespace driftbench {

void FigureWriter::write(PlotView &view, const std::string &stem, const QString &title,
                         const QString &caption)
{
    if (!m_status.ok() || view.isEmpty())
        return;
    if (!m_origin.isEmpty())
        view.setOrigin(m_origin);
    const QString origin = m_origin.isEmpty() ? QString() : QStringLiteral(" %1.").arg(m_origin);
    for (const char *ending : {".svg", ".pdf", ".png"}) {
        m_status = saveFigure(view, m_folder / (stem + ending), {title, caption + origin});
        if (!m_status.ok())
            return;
    }
    m_figures.push_back({stem, title, caption});
}

Result<std::vector<WrittenFigure>> FigureWriter::finish()
{
    if (!m_status.ok())
        return m_status.error();
    return std::move(m_figures);
}

} // namespace driftbench
