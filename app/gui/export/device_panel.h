// The device's tables: what is on it now against what would be written, the upload with its six steps, and
// the way back to the table before. Talks to the device by the UploadJob alone.
#pragma once

#include "app/gui/export/export_preview.h"
#include "app/session/upload_job.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QAction;
class QProgressBar;
class QStackedWidget;

namespace driftbench {

class ActionButton;
class DataTable;
class EmptyState;
class PairsTableModel;
class SectionHead;
class TableDifferenceView;
class TextLabel;
class UploadSteps;
class Workbench;

class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // The actions are the page's.
    DevicePanel(Workbench &bench, QAction *restore, QAction *cancel, QAction *look, QAction *toSource,
                QWidget *parent = nullptr);

    void setPreview(std::shared_ptr<const ExportPreview> preview, const TrainedModel *model);
    // What is shown is being made anew: it is not what would be written.
    void setPreviewStale(bool stale);
    void look(); // reads the device, unless something else is under way
    void write();
    void restore();
    void cancel();
    void retranslate();

    bool isWriting() const { return m_writing; }
    bool canWrite() const;
    bool canRestore() const;
    double fraction() const { return m_fraction; }
    const std::optional<DeviceTables> &tables() const { return m_tables; }
    QString problem() const { return m_problem ? QString::fromStdString(m_problem->message) : QString(); }
    UploadSteps &steps() const { return *m_steps; }
    DataTable &comparison() const { return *m_pairs; }
    QString statusText() const; // "Bank A active, bank B being written"

    // Of the table on the device, as the campaign was recorded with it.
    DeviceThermometer thermometer() const;

signals:
    void stateChanged();
    void looked();
    void thermometerKnown();
    void told(bool bad, const QString &what, const QString &toDo);

private:
    QWidget *buildFacts();
    QWidget *buildUpload();
    void connectJob();
    void lookedAt(const Result<DeviceTables> &tables);
    void uploaded(const Result<UploadOutcome> &outcome);
    void rolledBack(const Result<TableRollbackReport> &outcome);
    void showProgress(const QString &stage, double fraction);
    void showBytes(int step, double share); // of an UploadSteps::Step
    void showFailed(const Error &error);
    void showFacts();
    void showUploadIdle();
    void showWord(const QString &text, int tone);
    void showUploaded(const TableUploadReport &report);
    void record(const UploadOutcome &outcome);
    QString modelOf(std::uint32_t crc) const;

    Workbench &m_bench;
    QStackedWidget *m_stack;
    EmptyState *m_empty;
    SectionHead *m_head;
    ActionButton *m_restoreButton;
    DataTable *m_pairs;
    PairsTableModel *m_pairsModel;
    TableDifferenceView *m_difference;
    TextLabel *m_title, *m_note, *m_percent, *m_result;
    ActionButton *m_cancelButton;
    QProgressBar *m_bar;
    UploadSteps *m_steps;
    QAction *m_restore, *m_cancel, *m_look, *m_toSource;

    std::shared_ptr<const ExportPreview> m_preview;
    bool m_previewStale = false;
    std::string m_modelName;
    std::optional<DeviceTables> m_tables;
    std::optional<Error> m_problem;      // of looking
    std::function<void()> m_showOutcome; // of the last upload, in the language of now
    bool m_writing = false;
    bool m_lookAgain = false;
    double m_fraction = 0.0;
};

} // namespace driftbench
