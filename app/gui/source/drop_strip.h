// The dashed strip that says that files can be dropped, and what kinds. Dropping works on the whole window; a
// click opens the file dialog.
#pragma once

#include <QAbstractButton>

namespace driftbench {

class DropStrip : public QAbstractButton
{
    Q_OBJECT

public:
    explicit DropStrip(QWidget *parent = nullptr);

    QSize sizeHint() const override { return {300, 40}; }

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace driftbench
