// The files that an export can write: a box each, with what it holds or loses; and the few things that the
// autopilots need to know.
#pragma once

#include "app/gui/export/export_preview.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QLineEdit;

namespace driftbench {

class NumberField;
class SectionHead;
class TextLabel;

class FileChoices : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kFiles = 6; // the five formats of ExportFormat and the image

    explicit FileChoices(QWidget *parent = nullptr);

    void show(const ExportChoice &choice);
    void setPreview(const ExportPreview *preview); // null: nothing to export
    bool imageChosen() const;
    int chosen() const; // boxes that are on
    QCheckBox *box(int file) const { return m_boxes[static_cast<std::size_t>(file)]; }
    TextLabel *note(int file) const { return m_notes[static_cast<std::size_t>(file)]; }
    void retranslate();

signals:
    void edited(const driftbench::ExportChoice &choice);
    void chosenChanged();

private:
    void takeBoxes();
    void takeDeviceId();
    void showNotes();
    void note(int file, const QString &text, int tone);
    void noteAutopilot(const FilePreview &file);

    ExportChoice m_choice;
    const ExportPreview *m_preview = nullptr;
    bool m_showing = false;
    SectionHead *m_head;
    std::array<QCheckBox *, kFiles> m_boxes;
    std::array<TextLabel *, kFiles> m_notes;
    QCheckBox *m_force;
    TextLabel *m_idLabel, *m_boundLabel;
    QLineEdit *m_deviceId;
    NumberField *m_bound;
};

} // namespace driftbench
