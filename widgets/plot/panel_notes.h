// What stands around one panel: the axis name over its left end, a muted note over its right end, and labels
// of lines in the right margin. Drawn from the panel's place at the moment of drawing, so it is right in any
// size.
#pragma once

#include "widgets/style/palette.h"

#include <qcustomplot.h>

#include <vector>

namespace driftbench {

struct MarginLabel
{
    double value = 0.0; // where the line ends, on the left axis
    QPen pen;           // colour and dash of the line, for the lead
    QString text;
    bool main = false; // semibold and in the line's colour; the others are muted
};

class PanelNotes : public QCPAbstractItem
{
    Q_OBJECT

public:
    PanelNotes(QCPAxisRect *rect, const Palette &palette);

    // Both make room above the panel.
    void setName(const QString &name);
    void setNote(const QString &note);
    // Makes room right of the panel. Labels whose value is not finite are left out.
    void setMarginLabels(std::vector<MarginLabel> labels);
    // At least so much room for them, so that figures that change do not move the panel.
    void setMarginRoom(const QString &widestLabel);

    double selectTest(const QPointF &, bool, QVariant *) const override { return -1.0; }

protected:
    void draw(QCPPainter *painter) override;

private:
    void makeRoom();
    void drawMarginLabels(QCPPainter &painter) const;

    QCPAxisRect *m_rect;
    QColor m_textColor;
    QColor m_mutedColor;
    QString m_name;
    QString m_note;
    std::vector<MarginLabel> m_labels;
    QString m_widestLabel;
};

} // namespace driftbench
