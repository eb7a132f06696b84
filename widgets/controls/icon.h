// The icons of resources/icons (20 x 20, strokes in currentColor), drawn in the colour that is asked for:
// each is rendered once for a size and tinted over.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

class QPainter;

namespace driftbench {

inline constexpr int kSmallIcon = 16; // in buttons and tags
inline constexpr int kIcon = 20;

// name: without folder and ending, "source". sizePx in device-independent pixels.
QPixmap iconPixmap(const QString &name, int sizePx, const QColor &color, qreal devicePixelRatio = 1.0);
void paintIcon(QPainter &painter, const QRect &rect, const QString &name, const QColor &color);

// In the text colour of the application's palette at the time it is painted: follows light and dark.
QIcon themedIcon(const QString &name);

// Of the program itself, in its own colours.
QIcon applicationIcon();

} // namespace driftbench
