#include "widgets/controls/form_rows.h"

#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"

#include <QGridLayout>

namespace driftbench {

static constexpr int kPitch = 32;

FormRows::FormRows(int labelWidth, QWidget *parent) : QWidget(parent), m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(kLabelGap);
    m_grid->setVerticalSpacing(0);
    m_grid->setColumnMinimumWidth(0, labelWidth);
    m_grid->setColumnStretch(1, 1);
}

int FormRows::addRow(const QString &label, QWidget *field)
{
    Row row{new TextLabel(TextRole::Muted, label, this), field, new TextLabel(TextRole::Note, this)};
    row.label->setBuddy(field);
    row.error->setTone(Tone::Bad);
    row.error->setWordWrap(true);
    row.error->hide();
    const int at = m_grid->rowCount();
    m_grid->addWidget(row.label, at, 0);
    m_grid->addWidget(field, at, 1);
    m_grid->addWidget(row.error, at + 1, 0, 1, 2);
    m_grid->setRowMinimumHeight(at, kPitch);
    m_rows.push_back(row);
    return static_cast<int>(m_rows.size()) - 1;
}

void FormRows::addWide(QWidget *field)
{
    const int at = m_grid->rowCount();
    m_grid->addWidget(field, at, 0, 1, 2);
    m_grid->setRowMinimumHeight(at, kPitch);
}

void FormRows::setLabel(int row, const QString &label)
{
    m_rows[static_cast<std::size_t>(row)].label->setText(label);
}

void FormRows::setError(int row, const QString &sentence)
{
    const Row &which = m_rows[static_cast<std::size_t>(row)];
    which.error->setText(sentence);
    which.error->setVisible(!sentence.isEmpty());
    which.field->setProperty("invalid", !sentence.isEmpty());
    which.field->setAccessibleDescription(sentence);
    which.field->update();
}

void FormRows::setRowVisible(int row, bool visible)
{
    const Row &which = m_rows[static_cast<std::size_t>(row)];
    which.label->setVisible(visible);
    which.field->setVisible(visible);
    which.error->setVisible(visible && !which.error->text().isEmpty());
    int at = 0, column = 0, rows = 0, columns = 0;
    m_grid->getItemPosition(m_grid->indexOf(which.field), &at, &column, &rows, &columns);
    m_grid->setRowMinimumHeight(at, visible ? kPitch : 0);
}

} // namespace driftbench
