// The rail at the left: the seven steps, what each holds, and which is shown. No step is ever locked.
#pragma once

#include "app/gui/step.h"

#include <QAbstractListModel>
#include <QListView>

#include <array>

namespace driftbench {

class StepModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role
    {
        NoteRole = Qt::UserRole,
        HoldsRole,
        MarkRole,
        IconRole
    };

    using QAbstractListModel::QAbstractListModel;

    void setState(Step step, const StepState &state);
    const StepState &state(Step step) const;
    void retranslate(); // after the language changed

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    std::array<StepState, kSteps.size()> m_states;
};

class StepRail : public QListView
{
    Q_OBJECT

public:
    explicit StepRail(QWidget *parent = nullptr);

    StepModel &steps() { return m_model; }
    void setCurrentStep(Step step); // silent
    void clearCurrentStep();        // the start page is no step

signals:
    void stepChosen(Step step);

protected:
    bool event(QEvent *event) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    StepModel m_model;
    bool m_silent = false;
};

} // namespace driftbench
