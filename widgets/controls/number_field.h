// A field for a number with its unit: the number at the left as the locale writes it, with a real minus, the
// unit in muted letters at the right, arrows unless they are turned off. Understands "-" and "−".
#pragma once

#include <QDoubleSpinBox>

namespace driftbench {

class TextLabel;

class NumberField : public QDoubleSpinBox
{
    Q_OBJECT

public:
    // accessibleName: what the number is.
    NumberField(const QString &accessibleName, const QString &unit, int decimals, double lowest,
                double highest, double step, QWidget *parent = nullptr);

    void setUnit(const QString &unit);
    void setArrows(bool shown);
    void setMark(const QString &mark); // before the number: "±"

    // Border and accessible description of a value that can't be; empty: fine.
    void setError(const QString &sentence);

    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void placeUnit();

    TextLabel *m_unit;
    QString m_mark;
};

} // namespace driftbench
