// Source: where the samples come from. Bridges that are plugged in, the simulated one first; files that were
// opened lately; what is set for the chosen one; and a look at what it says.
//
// Choosing a bridge lets it run, to be watched; using it makes it the session's source. Using a log reads it
// in as a run of the session, using a session opens it.
#pragma once

#include "app/gui/page.h"
#include "app/gui/source/recent_files.h"
#include "app/session/load_job.h"

#include <QTimer>

#include <filesystem>
#include <vector>

class QStackedWidget;
class QTableView;

namespace driftbench {

class BridgeList;
class BridgeModel;
class DropStrip;
class EmptyState;
class LoadingState;
class SectionHead;
class SourceForm;
class StripView;
class Workbench;

class SourcePage : public Page
{
    Q_OBJECT

public:
    explicit SourcePage(AppContext &context, QWidget *parent = nullptr);
    ~SourcePage() override;

    StepState stepState() const override;
    QString hints() const override;
    std::vector<StatusPart> statusParts() const override;
    void entered() override;

    // Logs are read in as runs, a session is opened; what can't be is said in a banner.
    void openFiles(const std::vector<std::filesystem::path> &files);
    void chooseSimulated();
    void use(); // what is chosen

    BridgeModel &bridges() const { return *m_bridges; }
    RecentFilesModel &recent() const { return *m_recent; }
    SourceForm &form() const { return *m_form; }
    StripView &strips() const { return *m_strips; }

protected:
    void retranslate() override;
    void showEvent(QShowEvent *event) override;

private:
    void buildBody();
    QWidget *buildLists();
    QWidget *buildTable();
    QWidget *buildSide();
    void buildActions();
    void connectBench();
    void connectLoading();
    void showDevices();
    void showPermission();
    void showRecent();
    void showFilesPlace();
    void showRunning();
    void showUse();
    int rowAtFirst() const;
    void chooseRow(int row);
    void chooseFile(int row);
    void applyChoice();
    void takeLoaded(const std::vector<LoadedLog> &logs);
    void tell(const Error &error);

    Workbench &m_bench;
    BridgeModel *m_bridges;
    BridgeList *m_list;
    RecentFilesModel *m_recent;
    QTableView *m_table;
    LoadingState *m_loadingState;
    QStackedWidget *m_files;
    EmptyState *m_noFiles;
    DropStrip *m_drop;
    SourceForm *m_form;
    QWidget *m_now = nullptr; // what the source sends; a log sends nothing
    StripView *m_strips = nullptr;
    SectionHead *m_bridgesHead, *m_recentHead, *m_nowHead;
    QAction *m_use, *m_lookAgain, *m_copyLine;
    std::string m_chosenSource; // of the list
    std::filesystem::path m_chosenFile;
    QString m_permissionLine;
    QTimer m_apply; // edits of a form, together
    std::int64_t m_dropped = 0;
};

} // namespace driftbench
