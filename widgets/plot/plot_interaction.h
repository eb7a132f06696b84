// Mouse and keys of every plot of the workbench:
//
//   wheel               zooms at the mouse; over an axis only that axis
//   drag                pans; a cursor within 4 px is moved instead; or selects, where the plot says so
//   Shift+drag          zooms to the box
//   Ctrl+drag           selects the box, where somebody listens
//   double click, F     fits
//   arrows, + and -     pan and zoom
//   A, B                set a cursor at the mouse
//   Ctrl+E              exports what is visible: PNG, SVG, PDF, CSV
//   context menu        the same, and the data as a table
//   resting the mouse   the nearest values, after 300 ms
//
// The plot may be built anew at any time; its panels are asked for when they are needed. After building, the
// owner says rememberHome(): that view is where fit() goes.
#pragma once

#include "widgets/plot/plot_cursors.h"
#include "widgets/plot/plot_table.h"
#include "widgets/style/palette.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QPointer>
#include <QRectF>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QCPAxis;
class QCPAxisRect;
class QCPRange;
class QCustomPlot;
class QKeyEvent;
class QMenu;
class QMouseEvent;
class QRubberBand;
class QWheelEvent;

namespace driftbench {

class FocusOutline;

class PlotInteraction : public QObject
{
    Q_OBJECT

public:
    enum class DragAction
    {
        Pan,
        SelectKeys // a stretch of keys, as in a strip of time
    };

    PlotInteraction(QCustomPlot *plot, const Palette &look);
    ~PlotInteraction() override;

    void setLook(const Palette &look);
    // What wheel, drag and keys move inside a panel. Horizontal for strips over time, whose values fit
    // themselves; the wheel over the axis of values still zooms it.
    void setFreeAxes(Qt::Orientations axes) { m_freeAxes = axes; }
    void setDragAction(DragAction action) { m_dragAction = action; }
    void setBoxSelection(bool on) { m_boxSelection = on; }
    PlotCursors &enableCursors();
    PlotCursors *cursors() const { return m_cursors; }

    // In place of the nearest point of each series.
    void setHoverText(std::function<QString(const QPointF &)> textAt) { m_hoverText = std::move(textAt); }
    // In place of the points of all series in view.
    void setTable(std::function<PlotTable()> table) { m_table = std::move(table); }
    // In place of the remembered view.
    void setFit(std::function<void()> fit) { m_fit = std::move(fit); }
    // Who writes the pictures; the file's ending says which. Default: the plot as it stands.
    void setPictureBackground(const QColor &color) { m_background = color; }
    void setTitle(const QString &title) { m_title = title; } // of files, tables
    void addMenuAction(QAction *action);                     // above the others; not owned

    void rememberHome();
    bool isMoved() const { return m_moved; } // by the user, away from home
    // A view to put back after the plot was built anew with the same panels.
    struct View
    {
        struct Panel
        {
            QString keyLabel, valueLabel;
            double keyLow, keyHigh, valueLow, valueHigh;
        };
        std::vector<Panel> panels;
    };
    View view() const;
    void putBack(const View &view);

    // True if the key is one of the plot's and has been used. For pages that hand on keys while the mouse is
    // over a plot that has no focus.
    bool handleKey(QKeyEvent *event);
    bool isUnderMouse() const;

public slots:
    void fit();
    void zoomBy(double factor); // about the mouse, or the middle
    void setCursorHere(driftbench::Cursor cursor);
    void exportVisible(); // asks for a file
    void showTable();

signals:
    void viewChanged(); // by the user
    void fitted();
    void keysSelected(QCPAxisRect *panel, double low, double high); // while dragging, and at its end
    void selectionEnded(QCPAxisRect *panel);
    void boxSelected(QCPAxisRect *panel, const QRectF &box); // in values; left/top: the lower ones
    void clicked(QCPAxisRect *panel, const QPointF &place);
    void exported(const QString &file);
    void exportFailed(const QString &sentence);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    enum class Drag
    {
        None,
        Pending, // pressed, not moved yet
        Pan,
        Box,
        SelectBox,
        SelectKeys,
        MoveCursor
    };

    bool mousePressed(QMouseEvent *event);
    bool mouseMoved(QMouseEvent *event);
    bool mouseReleased(QMouseEvent *event);
    bool wheelTurned(QWheelEvent *event);
    void startDrag(Qt::KeyboardModifiers modifiers);
    void panTo(const QPointF &place);
    void selectTo(const QPointF &place);
    void endBox(const QPointF &place);
    void stretchBand(const QPointF &place);
    void updateShape(const QPointF &place);
    void panBySteps(double keySteps, double valueSteps);
    void zoomAt(const QPointF &place, double factor, Qt::Orientations axes);
    void changed();
    void fillMenu(QMenu &menu);
    void openMenu(const QPoint &globalPlace);
    void showHover();
    QString nearestValues(const QPointF &place) const;
    double keyAt(const QPointF &place) const;
    QPointF actionPlace() const; // the mouse, or the middle of the plot
    QCPRange homeOf(const QCPAxisRect &panel, Qt::Orientation axis) const;

    QCustomPlot *m_plot;
    Palette m_look;
    FocusOutline *m_outline;
    PlotCursors *m_cursors = nullptr;
    QColor m_background;
    QString m_title;
    std::function<QString(const QPointF &)> m_hoverText;
    std::function<PlotTable()> m_table;
    std::function<void()> m_fit;
    QList<QPointer<QAction>> m_menuActions;
    Qt::Orientations m_freeAxes = Qt::Horizontal | Qt::Vertical;
    DragAction m_dragAction = DragAction::Pan;
    bool m_boxSelection = false;

    View m_home;
    bool m_moved = false;
    Drag m_drag = Drag::None;
    Cursor m_dragged = Cursor::A;
    QPointer<QCPAxisRect> m_pressedPanel;
    QPointF m_pressedAt, m_lastAt;
    Qt::KeyboardModifiers m_pressedWith;
    QRubberBand *m_band = nullptr;
    QTimer m_hoverTimer;
};

} // namespace driftbench
