// The page Inspect.
#pragma once

#include "app/gui/page.h"

namespace driftbench {

class EmptyState;

class InspectPage : public Page
{
    Q_OBJECT

public:
    explicit InspectPage(AppContext &context, QWidget *parent = nullptr);

    StepState stepState() const override;
    QString hints() const override;

protected:
    void retranslate() override;

private:
    EmptyState *m_empty;
};

} // namespace driftbench
