// The six steps of an upload: what is done, what is under way, what comes.
#pragma once

#include <QString>
#include <QWidget>

#include <array>

namespace driftbench {

class UploadSteps : public QWidget
{
    Q_OBJECT

public:
    enum Step
    {
        Begin,
        Write,
        ReadBack,
        Verify,
        Commit,
        Activate,
        kSteps
    };
    enum class State
    {
        Idle,    // none is under way
        Running, // all before the current one are done
        Done,
        Failed // at the current one
    };

    explicit UploadSteps(QWidget *parent = nullptr);

    void setState(State state, Step current = Begin);
    void setDetail(Step step, const QString &detail); // below its name: "19 of 27"
    State state() const { return m_state; }
    Step current() const { return m_current; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showName();
    QString nameOf(int step) const;
    QString iconOf(int step) const;

    State m_state = State::Idle;
    Step m_current = Begin;
    std::array<QString, kSteps> m_details;
};

} // namespace driftbench
