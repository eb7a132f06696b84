// Right of the lists: the fields of whichever source is chosen, under its name and origin.
#pragma once

#include "app/gui/source/bridge_forms.h"
#include "app/gui/source/log_form.h"
#include "app/gui/source/simulated_form.h"

#include <QWidget>

class QStackedWidget;

namespace driftbench {

class OriginChip;
class SectionHead;

class SourceForm : public QWidget
{
    Q_OBJECT

public:
    explicit SourceForm(QWidget *parent = nullptr);

    void showDevice(const DeviceEntry &device);
    void showFile(const FileSurvey &survey);
    void showNothing();

    ChoiceForm *current() const; // null: nothing is chosen
    SimulatedForm &simulated() const { return *m_simulated; }
    LogForm &log() const { return *m_log; }
    bool isLog() const { return current() == m_log; }
    void retranslate();

signals:
    void edited();

private:
    SectionHead *m_head;
    OriginChip *m_chip;
    QStackedWidget *m_stack;
    QWidget *m_nothing;
    SimulatedForm *m_simulated;
    NativeForm *m_native;
    I2cForm *m_i2c;
    LogForm *m_log;
};

} // namespace driftbench
