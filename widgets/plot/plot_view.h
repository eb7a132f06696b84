// What all views have in common: a widget that holds one plot, a look (light or dark), and a sentence in
// place of the plot where there is nothing to show. A view is given plain engine values and draws them; it
// changes nothing. Its texts come from build() and from its name, which are asked again when the language
// changes. The legend is part of the plot, so a picture of the plot is a picture of the view; a page that has
// its own row for it (LegendRow) takes it out.
#pragma once

#include "widgets/plot/legend_painter.h"
#include "widgets/plot/tick_room.h"
#include "widgets/style/palette.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCPAxisRect;
class QCPLayoutGrid;
class QCPMarginGroup;
class QCustomPlot;

namespace driftbench {

class PlotInteraction;

class PlotView : public QWidget
{
    Q_OBJECT

public:
    ~PlotView() override;

    const Palette &look() const { return m_look; }
    void setLook(const Palette &look);
    // For views in the window: light or dark as their palette is, now and when it changes.
    void followTheme();

    // Where the data come from, where that must be said: "Simulated data". Stands in the legend of a picture;
    // in the window the head of the page says it.
    void setOrigin(const QString &origin);

    // Mouse and keys, for views in the window; pictures need none. A view that the user has moved stays where
    // it is when new data of the same kind come. Such a view follows the theme.
    PlotInteraction &enableInteraction();
    PlotInteraction *interaction() const { return m_interaction; }

    void setLegendInside(bool inside); // default: yes
    const std::vector<LegendEntry> &legend() const { return m_legend; }

    bool isEmpty() const { return m_empty; } // shows a sentence instead of data
    QCustomPlot &plot() const { return *m_plot; }
    virtual QSize figureSize() const = 0; // in px at 96 dpi, for pictures in reports

    QSize sizeHint() const override { return figureSize(); }

signals:
    void rebuilt(); // data, look or legend changed

protected:
    // name: what the plot shows, for those who don't see it and for files.
    PlotView(std::function<QString()> name, const Palette &look, QWidget *parent);

    void changeEvent(QEvent *event) override;

    void rebuild(); // after the data or the look changed
    virtual void build() = 0;

    // For build(): rows of the plot from top to bottom.
    void showEmpty(const QString &headline, const QString &sentence);
    void addLegend(std::vector<LegendEntry> entries);
    // Panels of one call share their right margins, and their left ones too unless only the first column has
    // numbers on its left axis (sharedValues): then that column is wider instead.
    QCPLayoutGrid &addPanels(bool sharedValues = false);
    QCPAxisRect &addPanel(QCPLayoutGrid &grid, int row, int column);

private:
    void clearPlot();
    void showName();

    std::function<QString()> m_name;
    Palette m_look;
    QCustomPlot *m_plot;
    std::vector<QCPMarginGroup *> m_marginGroups;
    PlotInteraction *m_interaction = nullptr;
    std::vector<LegendEntry> m_legend;
    bool m_legendInside = true;
    QString m_origin;
    bool m_empty = true;
    bool m_followsTheme = false;
    bool m_sharedValues = false; // of the panels being added
    TickRoom m_tickRoom;
};

} // namespace driftbench
