// Export: the table of the chosen model with its errors, the files to write with what each loses, and the
// device: what is on it now, what would be written, the upload and the way back.
#pragma once

#include "app/gui/export/export_preview.h"
#include "app/gui/page.h"
#include "app/session/job.h"
#include "app/session/session_records.h"

#include <filesystem>
#include <memory>

class QComboBox;
class QPlainTextEdit;
class QStackedWidget;

namespace driftbench {

class ActionButton;
class DataTable;
class DevicePanel;
class EmptyState;
class FileChoices;
class KnotsTableModel;
class SectionHead;
class TableErrorView;

class ExportPage : public Page
{
    Q_OBJECT

public:
    explicit ExportPage(AppContext &context, QWidget *parent = nullptr);
    ~ExportPage() override;

    StepState stepState() const override;
    QString hints() const override;
    std::vector<StatusPart> statusParts() const override;
    QAction *saveAction() const override { return m_save; }
    void entered() override;

    void saveFiles(const std::filesystem::path &folder);
    QAction *writeAction() const { return m_write; } // into the device
    DevicePanel &device() const { return *m_device; }
    FileChoices &files() const { return *m_files; }
    DataTable &knots() const { return *m_knots; }
    TableErrorView &errors() const { return *m_errors; }
    const ExportPreview *preview() const { return m_preview.get(); } // null while it is made
    QString previewText() const;                                     // of the chosen form; empty: the table
    void choosePreview(int form);                                    // 0: the table, then the files

protected:
    void retranslate() override;

private:
    static constexpr const char *kNotes = "axes"; // key of the banner

    QWidget *buildLeft();
    QWidget *buildRight();
    void connectSession();
    void choiceEdited(const ExportChoice &choice);
    void chooseModel(int index);
    void makePreview();
    void previewReady(const Status &outcome);
    void showModels();
    void showPreview();
    void showForm();
    void showButtons();
    void savedFiles(const Status &outcome);
    void askFolder();

    QStackedWidget *m_stack;
    EmptyState *m_empty;
    QComboBox *m_model;
    SectionHead *m_tableHead;
    QComboBox *m_form;
    QStackedWidget *m_forms;
    DataTable *m_knots;
    KnotsTableModel *m_knotsModel;
    QPlainTextEdit *m_text;
    FileChoices *m_files;
    TableErrorView *m_errors;
    DevicePanel *m_device = nullptr;
    QAction *m_save, *m_write, *m_restore, *m_cancel, *m_look, *m_toSource, *m_toTrain;

    TaskJob m_previewing;
    std::shared_ptr<ExportPreview> m_pending;
    std::shared_ptr<const ExportPreview> m_preview;
    bool m_previewAgain = false;
    TaskJob m_saving;
    std::vector<ExportRecord> m_records; // of what is being saved
    QString m_folder;
};

} // namespace driftbench
