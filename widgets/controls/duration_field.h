// A field for a length of time as h:min:s; also understands "1:30" (h:min) and "1800 s".
#pragma once

#include <QAbstractSpinBox>

namespace driftbench {

class TextLabel;

QString durationText(double seconds); // "3:05:00"

class DurationField : public QAbstractSpinBox
{
    Q_OBJECT

public:
    DurationField(const QString &accessibleName, double lowestS, double highestS, double stepS,
                  QWidget *parent = nullptr);

    double valueS() const { return m_valueS; }
    void setValueS(double seconds);

    void stepBy(int steps) override;
    QValidator::State validate(QString &text, int &position) const override;
    void fixup(QString &text) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void valueChanged(double seconds);

protected:
    StepEnabled stepEnabled() const override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void takeText();

    double m_lowestS;
    double m_highestS;
    double m_stepS;
    double m_valueS;
    TextLabel *m_unit;
};

} // namespace driftbench
