// A panel: base fill, a border of one pixel, round corners. What is put in flush (tables, plots) is cut at
// the corners. Panels are not nested.
#pragma once

#include <QFrame>

class QVBoxLayout;

namespace driftbench {

class Panel : public QFrame
{
    Q_OBJECT

public:
    explicit Panel(QWidget *parent = nullptr); // margins 12, 8

    void setFlush(); // no margins: for a table or a plot
    QVBoxLayout *rows() const { return m_rows; }
    void setEdge(const QColor &edge); // 3 px along the top, for a verdict; invalid: none

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void childEvent(QChildEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QVBoxLayout *m_rows;
    QWidget *m_border = nullptr; // on top of everything else
    QColor m_edge;
};

} // namespace driftbench
