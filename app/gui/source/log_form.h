// A log: which of its gyros, which columns, in which units, at which reference rate; whose it is, where the
// log does not say.
#pragma once

#include "app/gui/source/choice_form.h"
#include "app/gui/source/file_survey.h"
#include "app/session/load_job.h"

class QComboBox;
class QLineEdit;

namespace driftbench {

class FormRows;

class LogForm : public ChoiceForm
{
    Q_OBJECT

public:
    explicit LogForm(QWidget *parent = nullptr);

    void setLog(const FileSurvey &survey);
    // Read in whole, or played back as a source.
    bool isPlayedBack() const;
    LoadInput loadInput() const; // without files
    SourceChoice choice() const override;
    void retranslate() override;

private:
    ReadOptions readOptions() const;

    FileSurvey m_log;
    FormRows *m_rows;
    QComboBox *m_how, *m_instance, *m_timeUnit, *m_rateUnit, *m_temperatureUnit;
    std::array<QLineEdit *, kCsvQuantityCount> m_columns;
    NumberField *m_sensitivity;
    RateFields *m_reference;
    QLineEdit *m_model, *m_serial;
};

} // namespace driftbench
