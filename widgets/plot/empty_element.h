// Two lines in the middle of a plot that has nothing to show: what is missing, and what to do.
#pragma once

#include "widgets/style/palette.h"

#include <qcustomplot.h>

namespace driftbench {

class EmptyElement : public QCPLayoutElement
{
    Q_OBJECT

public:
    EmptyElement(QCustomPlot *plot, QString headline, QString sentence, const Palette &palette);

protected:
    void draw(QCPPainter *painter) override;

private:
    QString m_headline;
    QString m_sentence;
    QColor m_textColor;
    QColor m_mutedColor;
};

} // namespace driftbench
