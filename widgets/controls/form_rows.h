// A form: a muted label at the left, its field at the right, 32 px a row; under a field, when it cannot be as
// it is, the sentence that says why.
#pragma once

#include <QWidget>

#include <vector>

class QGridLayout;

namespace driftbench {

class TextLabel;

class FormRows : public QWidget
{
    Q_OBJECT

public:
    explicit FormRows(int labelWidth, QWidget *parent = nullptr);

    int addRow(const QString &label, QWidget *field); // its number
    void addWide(QWidget *field);                     // over both columns
    void setLabel(int row, const QString &label);
    void setError(int row, const QString &sentence); // also on the field ("invalid"); empty: fine
    void setRowVisible(int row, bool visible);

private:
    struct Row
    {
        TextLabel *label;
        QWidget *field;
        TextLabel *error;
    };

    QGridLayout *m_grid;
    std::vector<Row> m_rows;
};

} // namespace driftbench
