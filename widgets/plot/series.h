// The few kinds of series that the views draw, in the style of all plots.
#pragma once

#include <qcustomplot.h>

namespace driftbench {

// A series with a name is read out at the mouse and named in tables. Values that are not finite break the
// line.
void addLine(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values, const QPen &pen,
             const QString &name = {});

// Opaque fill between low and high, without an outline.
void addRange(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &low,
              const QVector<double> &high, const QColor &fill, const QString &name = {});

// Dots of 1.5 px unless told otherwise, drawn as one path of one colour: vector files stay small.
void addDots(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values,
             const QColor &color, double diameter = 1.5, const QString &name = {});

void addVertical(QCPAxisRect &rect, double key, const QPen &pen);
void addHorizontal(QCPAxisRect &rect, double value, const QPen &pen);

} // namespace driftbench
