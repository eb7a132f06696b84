// The fields of one kind of source, right of the lists.
#pragma once

#include "device/source_choice.h"

#include <QWidget>

namespace driftbench {

class NumberField;

class ChoiceForm : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    virtual SourceChoice choice() const = 0;
    virtual void retranslate() = 0;

signals:
    void edited();
};

inline constexpr int kFormLabelWidth = 120;

// Three rates beside each other, x, y, z, with their unit.
class RateFields : public QWidget
{
    Q_OBJECT

public:
    explicit RateFields(QWidget *parent = nullptr);

    Eigen::Vector3d rateDps() const;
    void setRateDps(const Eigen::Vector3d &rateDps);
    void retranslate();

signals:
    void edited();

private:
    std::array<NumberField *, 3> m_fields;
};

} // namespace driftbench
