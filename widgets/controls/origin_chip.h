// Says beside a title where its data come from: simulated, a device that is plugged in, or a real log.
#pragma once

#include <QWidget>

namespace driftbench {

enum class Origin
{
    None, // no data: the chip is not shown
    Simulated,
    Device,
    Real
};

class OriginChip : public QWidget
{
    Q_OBJECT

public:
    explicit OriginChip(QWidget *parent = nullptr);

    void setOrigin(Origin origin);
    Origin origin() const { return m_origin; }
    static QString words(Origin origin); // "Simulated data", "Real device", "Real log"

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    Origin m_origin = Origin::None;
};

} // namespace driftbench
