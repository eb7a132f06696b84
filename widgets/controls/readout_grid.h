// Read-outs: a name in muted letters at the left, its value at the right, rows of 20 px. With columns it is a
// small table with a head. Values are set as text, by row and column.
#pragma once

#include "widgets/controls/text_label.h"

#include <vector>

class QGridLayout;

namespace driftbench {

class ReadoutGrid : public QWidget
{
    Q_OBJECT

public:
    explicit ReadoutGrid(int columns = 1, QWidget *parent = nullptr);

    void setHeads(const QStringList &heads); // over the values; a row with a rule below
    int addRow(const QString &name);         // its number
    void setName(int row, const QString &name);
    TextLabel &nameLabel(int row) const { return *m_rows[static_cast<std::size_t>(row)].name; }
    void setValue(int row, int column, const QString &text, Tone tone = Tone::Plain, bool strong = false);
    void setValue(int row, const QString &text, Tone tone = Tone::Plain, bool strong = false)
    {
        setValue(row, 0, text, tone, strong);
    }
    QString value(int row, int column = 0) const;
    void setRowVisible(int row, bool visible);
    void setNameRole(TextRole role); // of rows that are added from now on
    int rowCount() const { return static_cast<int>(m_rows.size()); }

private:
    struct Row
    {
        TextLabel *name;
        std::vector<TextLabel *> values;
    };

    QGridLayout *m_grid;
    int m_columns;
    TextRole m_nameRole = TextRole::Note;
    std::vector<TextLabel *> m_heads;
    std::vector<Row> m_rows;
};

// A rule of one pixel between blocks of a column.
class Rule : public QWidget
{
    Q_OBJECT

public:
    explicit Rule(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace driftbench
