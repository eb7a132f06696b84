#include "app/gui/source/source_form.h"

#include "app/gui/source/bridge_list.h"
#include "widgets/controls/origin_chip.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/control_paint.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace driftbench {

namespace {

// As high as the page that is shown: the strips below take what a short form leaves.
class FormStack : public QStackedWidget
{
public:
    FormStack()
    {
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        connect(this, &QStackedWidget::currentChanged, this, [this] { updateGeometry(); });
    }
    QSize sizeHint() const override { return currentWidget() ? currentWidget()->sizeHint() : QSize(); }
    QSize minimumSizeHint() const override
    {
        return currentWidget() ? currentWidget()->minimumSizeHint() : QSize();
    }
};

} // namespace

SourceForm::SourceForm(QWidget *parent)
    : QWidget(parent)
    , m_head(new SectionHead)
    , m_chip(new OriginChip)
    , m_stack(new FormStack)
    , m_nothing(new QWidget)
    , m_simulated(new SimulatedForm)
    , m_native(new NativeForm)
    , m_i2c(new I2cForm)
    , m_log(new LogForm)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    m_head->addControl(m_chip);
    rows->addWidget(m_head);
    rows->addWidget(m_stack);
    m_stack->addWidget(m_nothing);
    for (ChoiceForm *form : {static_cast<ChoiceForm *>(m_simulated), static_cast<ChoiceForm *>(m_native),
                             static_cast<ChoiceForm *>(m_i2c), static_cast<ChoiceForm *>(m_log)}) {
        m_stack->addWidget(form);
        connect(form, &ChoiceForm::edited, this, [this, form] {
            if (current() == form)
                emit edited();
        });
    }
    showNothing();
}

void SourceForm::showDevice(const DeviceEntry &device)
{
    m_head->setTitle(bridgeName(device));
    m_chip->setOrigin(device.kind == DeviceKind::SimulatedBridge ? Origin::Simulated : Origin::Device);
    switch (device.kind) {
    case DeviceKind::SimulatedBridge:
        m_stack->setCurrentWidget(m_simulated);
        break;
    case DeviceKind::NativeBridge:
        m_native->setDevice(device);
        m_stack->setCurrentWidget(m_native);
        break;
    case DeviceKind::I2cChip:
        m_i2c->setDevice(device);
        m_stack->setCurrentWidget(m_i2c);
        break;
    }
}

void SourceForm::showFile(const FileSurvey &survey)
{
    m_head->setTitle(QString::fromStdString(survey.path.filename().string()));
    m_chip->setOrigin(survey.origin);
    if (survey.kind == FileKind::Session) {
        m_stack->setCurrentWidget(m_nothing);
        return;
    }
    m_log->setLog(survey);
    m_stack->setCurrentWidget(m_log);
    m_stack->updateGeometry();
}

void SourceForm::showNothing()
{
    m_head->setTitle(tr("No source chosen"));
    m_chip->setOrigin(Origin::None);
    m_stack->setCurrentWidget(m_nothing);
}

ChoiceForm *SourceForm::current() const
{
    return qobject_cast<ChoiceForm *>(m_stack->currentWidget());
}

void SourceForm::retranslate()
{
    for (ChoiceForm *form : {static_cast<ChoiceForm *>(m_simulated), static_cast<ChoiceForm *>(m_native),
                             static_cast<ChoiceForm *>(m_i2c), static_cast<ChoiceForm *>(m_log)})
        form->retranslate();
}

} // namespace driftbench
