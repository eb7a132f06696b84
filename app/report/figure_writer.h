// Saves one figure after another as SVG, PDF and PNG and remembers the first failure.
#pragma once

#include "app/report/figure_list.h"
#include "widgets/plot/plot_view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace driftbench {

class FigureWriter
{
public:
    // origin: where the figures' data come from, where that must be said ("Simulated data").
    FigureWriter(std::filesystem::path folder, QString origin)
        : m_folder(std::move(folder)), m_origin(std::move(origin))
    {
    }

    // Nothing for a view that has nothing to show.
    void write(PlotView &view, const std::string &stem, const QString &title, const QString &caption);

    Result<std::vector<WrittenFigure>> finish();

private:
    std::filesystem::path m_folder;
    QString m_origin;
    Status m_status;
    std::vector<WrittenFigure> m_figures;
};

} // namespace driftbench
