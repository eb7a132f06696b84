// The finding of one axis as a card: name, icon and word, how many runs pass, and in words what to do, the
// figures of each run, the reason. The same words stand in reports.
#pragma once

#include "engine/evaluation/axis_finding.h"
#include "engine/evaluation/hysteresis.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/text_label.h"

#include <QString>

namespace driftbench {

class StateWord;

QString verdictWord(Verdict verdict); // "Yes", "With care", "No", "No drift"
Tone verdictTone(Verdict verdict);
QString passText(const AxisFinding &finding); // "passes on 2 of 3 runs"; empty without a limit

struct FindingText
{
    QString toDo;    // "Write the table."
    QString figures; // "It leaves 0.089, 0.058, 0.093 dps rms, 11 to 19 times less than a constant."
    QString reason;  // "The rest is hysteresis, 3 times the noise."; may be empty

    QString whole() const;
};
// hysteresisRmsDps: NaN where heating and cooling were not both seen.
FindingText findingText(const AxisFinding &finding, double hysteresisRmsDps);

class VerdictCard : public Panel
{
    Q_OBJECT

public:
    explicit VerdictCard(QWidget *parent = nullptr);

    // details: the engine's own sentence, as a tooltip.
    void setFinding(const AxisFinding &finding, double hysteresisRmsDps, const QString &details);

protected:
    void changeEvent(QEvent *event) override;

private:
    void showEdge();

    TextLabel *m_axis;
    StateWord *m_word;
    TextLabel *m_passes;
    TextLabel *m_text;
    Verdict m_verdict = Verdict::NotRepeatable;
    bool m_known = false;
};

} // namespace driftbench
