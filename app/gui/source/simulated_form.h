// The simulated bridge: which gyro, how it drifts, how noisy it is, how fast its time passes.
#pragma once

#include "app/gui/source/choice_form.h"

class QComboBox;

namespace driftbench {

class FormRows;

class SimulatedForm : public ChoiceForm
{
    Q_OBJECT

public:
    explicit SimulatedForm(QWidget *parent = nullptr);

    SourceChoice choice() const override;
    void setChoice(const SourceChoice &choice); // silent
    QString settingsText() const;               // "L3GD20H, 245 dps, curved drift"
    void retranslate() override;

private:
    void addSpeeds();

    FormRows *m_rows;
    QComboBox *m_sensor, *m_drift, *m_speed;
    RateFields *m_reference;
    NumberField *m_rate, *m_noise, *m_spread;
};

} // namespace driftbench
