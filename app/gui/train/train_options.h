// The options of the training: what they are now in the session's calibration plan, and edits of it. Each
// change is one step that can be undone.
#pragma once

#include "app/session/calibration_plan.h"
#include "app/session/session_records.h"

#include <QWidget>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;

namespace driftbench {

class FormRows;
class NumberField;
class SectionHead;
class SegmentedButtons;
class TextLabel;

class TrainOptions : public QWidget
{
    Q_OBJECT

public:
    explicit TrainOptions(QWidget *parent = nullptr);

    void show(const CalibrationPlan &plan, const std::vector<RunRecord> &runs);
    void setNote(const QString &note); // how the numbers of centres were chosen
    void retranslate();

signals:
    void edited(const driftbench::CalibrationPlan &plan, const QString &step);

private:
    enum Preset
    {
        Best,
        Paper,
        Both
    };
    enum Row
    {
        Centres,
        Widths,
        Ridge,
        Hidden,
        Starts,
        Seed,
        HoldOut,
        Judged
    };

    void buildModels();
    void buildForm();
    void edit(const QString &step, const std::function<void(CalibrationPlan &)> &change);
    void takeModels();
    void showModels();
    void showHoldOut();
    void fillChoices();
    void explain();

    CalibrationPlan m_plan;
    std::vector<RunRecord> m_runs;
    bool m_showing = false;

    SectionHead *m_presetHead, *m_modelsHead, *m_inputsHead, *m_optionsHead;
    SegmentedButtons *m_preset;
    QCheckBox *m_rbf;
    std::map<std::string, QCheckBox *> m_models; // but the RBF networks
    std::array<QCheckBox *, 3> m_inputs;
    QCheckBox *m_dynamic;
    FormRows *m_form;
    QComboBox *m_centres, *m_widths, *m_holdOut, *m_judged;
    NumberField *m_ridge, *m_hidden, *m_starts, *m_seed;
    TextLabel *m_note;
};

} // namespace driftbench
