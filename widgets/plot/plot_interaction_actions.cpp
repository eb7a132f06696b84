// The part of PlotInteraction that is not the mouse's: keys, menu, files, the text at the mouse.
#include "widgets/figure/plot_picture.h"
#include "widgets/plot/axis_moves.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/style/number_text.h"

#include <QAction>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QToolTip>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kPanStep = 0.1;     // of the span, for one arrow
static constexpr double kKeyZoom = 0.75;    // for one +
static constexpr double kHoverReach = 24.0; // px

void PlotInteraction::panBySteps(double keySteps, double valueSteps)
{
    QCPAxisRect *panel = panelAt(*m_plot, actionPlace());
    if (!panel)
        return;
    if (keySteps != 0.0)
        panAxis(*panel->axis(QCPAxis::atBottom), 0.0, -keySteps * panel->width());
    if (valueSteps != 0.0)
        panAxis(*panel->axis(QCPAxis::atLeft), 0.0, valueSteps * panel->height());
    changed();
}

void PlotInteraction::setCursorHere(Cursor cursor)
{
    if (m_cursors && !m_plot->axisRects().isEmpty())
        m_cursors->place(cursor, keyAt(actionPlace()));
}

bool PlotInteraction::handleKey(QKeyEvent *event)
{
    const auto modifiers = event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
    if (modifiers == Qt::ControlModifier && event->key() == Qt::Key_E) {
        exportVisible();
        return true;
    }
    if (modifiers != Qt::NoModifier)
        return false;
    switch (event->key()) {
    case Qt::Key_Left:
        panBySteps(-kPanStep, 0.0);
        return true;
    case Qt::Key_Right:
        panBySteps(kPanStep, 0.0);
        return true;
    case Qt::Key_Up:
        panBySteps(0.0, kPanStep);
        return true;
    case Qt::Key_Down:
        panBySteps(0.0, -kPanStep);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(kKeyZoom);
        return true;
    case Qt::Key_Minus:
        zoomBy(1.0 / kKeyZoom);
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_A:
    case Qt::Key_B:
        if (!m_cursors)
            return false;
        setCursorHere(event->key() == Qt::Key_A ? Cursor::A : Cursor::B);
        return true;
    default:
        return false;
    }
}

void PlotInteraction::fillMenu(QMenu &menu)
{
    for (const QPointer<QAction> &action : m_menuActions) {
        if (action)
            menu.addAction(action);
    }
    if (!m_menuActions.isEmpty())
        menu.addSeparator();
    const auto add = [&](const QString &text, const QKeySequence &keys, auto &&what) {
        QAction *action = menu.addAction(text, this, std::forward<decltype(what)>(what));
        action->setShortcut(keys);
        action->setShortcutVisibleInContextMenu(true);
    };
    add(tr("Fit"), Qt::Key_F, [this] { fit(); });
    add(tr("Zoom in"), Qt::Key_Plus, [this] { zoomBy(kKeyZoom); });
    add(tr("Zoom out"), Qt::Key_Minus, [this] { zoomBy(1.0 / kKeyZoom); });
    if (m_cursors) {
        menu.addSeparator();
        add(tr("Set cursor A here"), Qt::Key_A, [this] { setCursorHere(Cursor::A); });
        add(tr("Set cursor B here"), Qt::Key_B, [this] { setCursorHere(Cursor::B); });
        menu.addAction(tr("Remove the cursors"), m_cursors, &PlotCursors::clear);
    }
    menu.addSeparator();
    add(tr("Export what is visible…"), Qt::CTRL | Qt::Key_E, [this] { exportVisible(); });
    menu.addAction(tr("Show the data as a table"), this, &PlotInteraction::showTable);
}

void PlotInteraction::openMenu(const QPoint &globalPlace)
{
    m_hoverTimer.stop();
    auto *menu = new QMenu(m_plot);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    menu->popup(globalPlace);
}

void PlotInteraction::showTable()
{
    const QString title = m_title.isEmpty() ? m_plot->accessibleName() : m_title;
    showPlotTable(m_table ? m_table() : visibleData(*m_plot), title, m_plot);
}

void PlotInteraction::exportVisible()
{
    const QString title = m_title.isEmpty() ? m_plot->accessibleName() : m_title;
    auto *dialog = new QFileDialog(m_plot->window(), tr("Export what is visible"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("PNG picture (*.png)"), tr("SVG drawing (*.svg)"), tr("PDF document (*.pdf)"),
                            tr("CSV table (*.csv)")});
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString &filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).chopped(1));
    });
    connect(dialog, &QFileDialog::fileSelected, this, [this, title](const QString &file) {
        const Status saved =
            savePlot(*m_plot, file, title, m_background, m_table ? m_table() : visibleData(*m_plot));
        if (saved.ok())
            emit exported(file);
        else
            emit exportFailed(QString::fromStdString(saved.error().message));
    });
    dialog->open();
}

static QString axisText(const QCPAxis &axis, double coord)
{
    const double span = axis.range().size();
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 6);
    const QString name = axis.label().isEmpty() ? QString() : axis.label() + QStringLiteral(": ");
    return name + numberText(coord, decimals);
}

// Of each named series the point nearest to the mouse along the keys; of unnamed ones, the panel's reading at
// the mouse.
QString PlotInteraction::nearestValues(const QPointF &place) const
{
    const QCPAxisRect *panel = panelAt(*m_plot, place);
    if (!panel || panelPartAt(*panel, place) != PanelPart::Inside)
        return {};
    const QCPAxis &keys = *panel->axis(QCPAxis::atBottom);
    const QCPAxis &values = *panel->axis(QCPAxis::atLeft);
    const double key = keys.pixelToCoord(place.x());
    QStringList lines{axisText(keys, key)};
    for (const QCPGraph *graph : panel->graphs()) {
        const auto data = graph->data();
        if (graph->name().isEmpty() || data->isEmpty())
            continue;
        auto point = data->findBegin(key, false);
        if (point != data->constBegin() &&
            (point == data->constEnd() || point->key - key > key - (point - 1)->key))
            --point;
        if (!std::isfinite(point->value) || std::abs(keys.coordToPixel(point->key) - place.x()) > kHoverReach)
            continue;
        const double span = values.range().size();
        const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 6);
        lines.append(graph->name() + QStringLiteral(": ") + numberText(point->value, decimals));
    }
    if (lines.size() == 1)
        lines.append(axisText(values, values.pixelToCoord(place.y())));
    return lines.join(QLatin1Char('\n'));
}

void PlotInteraction::showHover()
{
    if (m_drag != Drag::None || !m_plot->underMouse())
        return;
    QString text = m_hoverText ? m_hoverText(m_lastAt) : nearestValues(m_lastAt);
    if (text.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(m_plot->mapToGlobal(m_lastAt.toPoint()), text, m_plot);
}

} // namespace driftbench
