#include "app/gui/source/choice_form.h"

#include "engine/base/axes.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/text_label.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace driftbench {

static constexpr double kMostDps = 2000.0;

RateFields::RateFields(QWidget *parent) : QWidget(parent)
{
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(4);
    for (NumberField *&field : m_fields) {
        field = new NumberField({}, {}, 0, -kMostDps, kMostDps, 1.0);
        field->setArrows(false);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        field->setMinimumWidth(40);
        columns->addWidget(field, 1);
        connect(field, &QDoubleSpinBox::valueChanged, this, &RateFields::edited);
    }
    columns->addWidget(new TextLabel(TextRole::Note, tr("dps")));
    setFocusProxy(m_fields.front());
    retranslate();
}

void RateFields::retranslate()
{
    for (std::size_t axis = 0; axis < m_fields.size(); ++axis)
        m_fields[axis]->setAccessibleName(
            tr("Reference rate, %1").arg(QString::fromUtf8(kAxisNames[axis].data())));
}

Eigen::Vector3d RateFields::rateDps() const
{
    return {m_fields[0]->value(), m_fields[1]->value(), m_fields[2]->value()};
}

void RateFields::setRateDps(const Eigen::Vector3d &rateDps)
{
    for (std::size_t axis = 0; axis < m_fields.size(); ++axis) {
        const QSignalBlocker silent(m_fields[axis]);
        m_fields[axis]->setValue(rateDps[static_cast<Eigen::Index>(axis)]);
    }
}

} // namespace driftbench
