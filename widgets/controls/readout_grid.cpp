#include "widgets/controls/readout_grid.h"

#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"

#include <QGridLayout>
#include <QPainter>

namespace driftbench {

static constexpr int kRowHeight = 20;
static constexpr int kFirstRow = 2; // after heads and rule

ReadoutGrid::ReadoutGrid(int columns, QWidget *parent)
    : QWidget(parent), m_grid(new QGridLayout(this)), m_columns(columns)
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(kGap);
    m_grid->setVerticalSpacing(0);
    for (int column = 1; column <= columns; ++column)
        m_grid->setColumnStretch(column, 1);
}

void ReadoutGrid::setHeads(const QStringList &heads)
{
    if (m_heads.empty()) {
        for (int column = 1; column <= m_columns; ++column) {
            auto *head = new TextLabel(TextRole::Note, this);
            head->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            head->setMinimumHeight(kRowHeight);
            m_grid->addWidget(head, 0, column);
            m_heads.push_back(head);
        }
        m_grid->addWidget(new Rule(this), 1, 0, 1, m_columns + 1);
    }
    for (int column = 0; column < m_columns && column < heads.size(); ++column)
        m_heads[static_cast<std::size_t>(column)]->setText(heads[column]);
}

int ReadoutGrid::addRow(const QString &name)
{
    Row row;
    const int at = kFirstRow + rowCount();
    row.name = new TextLabel(m_nameRole, name, this);
    row.name->setMinimumHeight(kRowHeight);
    m_grid->addWidget(row.name, at, 0);
    for (int column = 1; column <= m_columns; ++column) {
        auto *value = new TextLabel(TextRole::NoteText, this);
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(value, at, column);
        row.values.push_back(value);
    }
    m_rows.push_back(std::move(row));
    return rowCount() - 1;
}

void ReadoutGrid::setName(int row, const QString &name)
{
    m_rows[static_cast<std::size_t>(row)].name->setText(name);
}

void ReadoutGrid::setValue(int row, int column, const QString &text, Tone tone, bool strong)
{
    TextLabel &label = *m_rows[static_cast<std::size_t>(row)].values[static_cast<std::size_t>(column)];
    const TextRole role = strong ? TextRole::StrongNote : TextRole::NoteText;
    if (label.font() != textFont(role))
        label.setRole(role);
    label.setTone(tone);
    if (label.text() != text)
        label.setText(text);
}

QString ReadoutGrid::value(int row, int column) const
{
    return m_rows[static_cast<std::size_t>(row)].values[static_cast<std::size_t>(column)]->text();
}

void ReadoutGrid::setRowVisible(int row, bool visible)
{
    const Row &which = m_rows[static_cast<std::size_t>(row)];
    which.name->setVisible(visible);
    for (TextLabel *value : which.values)
        value->setVisible(visible);
}

void ReadoutGrid::setNameRole(TextRole role)
{
    m_nameRole = role;
}

Rule::Rule(QWidget *parent) : QWidget(parent)
{
    setFixedHeight(1);
}

void Rule::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), lookOf(palette()).border);
}

} // namespace driftbench
