// Real bridges: the native gyro bridge, and a gyro behind a USB-to-I2C chip.
#pragma once

#include "app/gui/source/choice_form.h"
#include "device/discovery/device_list.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace driftbench {

class FormRows;

class NativeForm : public ChoiceForm
{
    Q_OBJECT

public:
    explicit NativeForm(QWidget *parent = nullptr);

    void setDevice(const DeviceEntry &device);
    SourceChoice choice() const override;
    void retranslate() override;

private:
    NativeChoice m_device;
    FormRows *m_rows;
    NumberField *m_rate;
    QComboBox *m_range, *m_thermometer;
    QCheckBox *m_compensate;
};

class I2cForm : public ChoiceForm
{
    Q_OBJECT

public:
    explicit I2cForm(QWidget *parent = nullptr);

    void setDevice(const DeviceEntry &device);
    SourceChoice choice() const override;
    void retranslate() override;

private:
    void offerAddresses();

    I2cChoice m_device;
    FormRows *m_rows;
    QComboBox *m_gyro, *m_address, *m_range, *m_thermometer, *m_speed;
    NumberField *m_rate, *m_offset;
    QLineEdit *m_serial;
};

} // namespace driftbench
