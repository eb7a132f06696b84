// The fields of a test plan: sensor, chamber, profile. A preset fills the figures of its datasheet; a figure
// that is changed makes it one's own.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/test_plan.h"

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace driftbench {

class DurationField;
class FormRows;
class NumberField;
class SectionHead;

class PlanForm : public QWidget
{
    Q_OBJECT

public:
    explicit PlanForm(QWidget *parent = nullptr);

    TestPlan plan() const;                 // as the fields have it, whether it can be or not
    void setPlan(const TestPlan &plan);    // silent
    void showError(const Status &checked); // at the field that it concerns

    void retranslate();

signals:
    void edited();

private:
    void buildSensor();
    void buildChamber();
    void buildProfile();
    void takeSensorPreset();
    void takeRange();
    void takeChamberPreset();
    void fillFields();
    template <class Field>
    void watch(Field *field);

    TestPlan m_plan; // with those figures that have no field
    bool m_filling = false;
    FormRows *m_rows;
    SectionHead *m_sensorHead, *m_chamberHead, *m_profileHead;
    QComboBox *m_sensor, *m_range, *m_chamber;
    NumberField *m_sensitivity, *m_zeroRate, *m_edge, *m_thermometer;
    NumberField *m_lowest, *m_highest, *m_step, *m_period, *m_runs;
    DurationField *m_hold;
    QCheckBox *m_cycle;
    int m_sensorRow = 0, m_rangeRow = 0, m_sensitivityRow = 0, m_zeroRateRow = 0, m_chamberRow = 0,
        m_edgeRow = 0, m_thermometerRow = 0, m_spanRow = 0, m_stepRow = 0, m_periodRow = 0, m_holdRow = 0,
        m_runsRow = 0;
};

} // namespace driftbench
