// The head of a section: semibold words at the left, a muted note or small controls at the right.
#pragma once

#include "widgets/controls/text_label.h"

class QHBoxLayout;

namespace driftbench {

class SectionHead : public QWidget
{
    Q_OBJECT

public:
    explicit SectionHead(const QString &title = {}, QWidget *parent = nullptr);

    void setTitle(const QString &title) { m_title->setText(title); }
    void setAside(const QString &text);                         // muted, straight after the title
    void setNote(const QString &note, Tone tone = Tone::Plain); // at the right end
    void addControl(QWidget *control);                          // at the right end
    TextLabel &note() const { return *m_note; }

private:
    QHBoxLayout *m_layout;
    TextLabel *m_title;
    TextLabel *m_aside;
    TextLabel *m_note;
};

} // namespace driftbench
