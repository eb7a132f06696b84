// How the Source page is put together, and its words.
#include "app/gui/pages/source_page.h"

#include "app/gui/source/bridge_list.h"
#include "app/gui/source/drop_strip.h"
#include "app/gui/source/source_form.h"
#include "app/gui/workbench.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/loading_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"
#include "widgets/tables/table_paint.h"
#include "widgets/views/strip_view.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kSideWidth = 296;

void SourcePage::buildActions()
{
    m_use = addPageAction({}, {}, [this] { use(); });
    m_use->setProperty("shownShortcut", tr("Enter"));
    setPrimaryAction(m_use);
    m_lookAgain = addPageAction(Qt::Key_F5, QStringLiteral("refresh"), [this] {
        m_bench.lookAgain();
        m_recent->lookAgain();
    });
    m_copyLine = addPageAction({}, QStringLiteral("copy"),
                               [this] { QGuiApplication::clipboard()->setText(m_permissionLine); });
    if (QAction *open = context().actions.openFiles)
        head().addControl(new ActionButton(open, ButtonSize::Head));
    auto *use = new ActionButton(m_use, ButtonSize::Head);
    use->setPrimary(true);
    head().addControl(use);
}

void SourcePage::buildBody()
{
    auto *splitter = new QSplitter(Qt::Horizontal);
    splitter->setObjectName(QStringLiteral("source"));
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(buildLists());
    splitter->addWidget(buildSide());
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 0);
    setBody(splitter);
}

static QWidget *flushPanel(QWidget *content)
{
    auto *panel = new Panel;
    panel->setFlush();
    panel->rows()->addWidget(content);
    return panel;
}

QWidget *SourcePage::buildLists()
{
    auto *lists = new QWidget;
    auto *rows = new QVBoxLayout(lists);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    m_bridgesHead = new SectionHead;
    m_list = new BridgeList;
    m_list->setModel(m_bridges);
    QWidget *bridges = flushPanel(m_list);
    bridges->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    rows->addWidget(m_bridgesHead);
    rows->addWidget(bridges);
    rows->addSpacing(kGap);
    m_recentHead = new SectionHead;
    rows->addWidget(m_recentHead);
    m_files = new QStackedWidget;
    m_files->addWidget(buildTable());
    m_loadingState = new LoadingState;
    m_files->addWidget(m_loadingState);
    m_noFiles = new EmptyState(QStringLiteral("file"));
    m_files->addWidget(m_noFiles);
    rows->addWidget(flushPanel(m_files), 1);
    rows->addSpacing(kGap);
    m_drop = new DropStrip;
    rows->addWidget(m_drop);
    connect(m_drop, &QAbstractButton::clicked, this, [this] {
        if (context().actions.openFiles)
            context().actions.openFiles->trigger();
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &row) {
                if (row.isValid() && m_bridges->device(row.row()).source != m_chosenSource)
                    chooseRow(row.row());
            });
    return lists;
}

QWidget *SourcePage::buildTable()
{
    m_table = new QTableView;
    dressTable(*m_table);
    m_table->setModel(m_recent);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(RecentFilesModel::FileColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(64);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        const QModelIndexList chosen = m_table->selectionModel()->selectedRows();
        if (!chosen.isEmpty())
            chooseFile(chosen.front().row());
    });
    connect(m_table, &QTableView::doubleClicked, this, [this] { use(); });
    connect(m_recent, &RecentFilesModel::surveyed, this, [this](int row) {
        if (m_recent->survey(row).path == m_chosenFile)
            m_form->showFile(m_recent->survey(row));
    });
    return m_table;
}

QWidget *SourcePage::buildSide()
{
    auto *side = new QWidget;
    side->setFixedWidth(kSideWidth);
    auto *rows = new QVBoxLayout(side);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    m_form = new SourceForm;
    rows->addWidget(m_form);
    rows->addSpacing(kGap);
    m_now = new QWidget;
    QSizePolicy place(QSizePolicy::Ignored, QSizePolicy::Ignored);
    place.setRetainSizeWhenHidden(true);
    m_now->setSizePolicy(place);
    rows->addWidget(m_now, 1);
    auto *nowRows = new QVBoxLayout(m_now);
    nowRows->setContentsMargins(0, 0, 0, 0);
    nowRows->setSpacing(kGap);
    m_nowHead = new SectionHead;
    nowRows->addWidget(m_nowHead);
    m_strips = new StripView(lookOf(palette()));
    m_strips->followTheme();
    QWidget *strips = flushPanel(m_strips);
    strips->setMinimumHeight(120);
    strips->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    nowRows->addWidget(strips, 1);
    connect(m_form, &SourceForm::edited, this, [this] {
        m_apply.start();
        showUse();
    });
    return side;
}

void SourcePage::showFilesPlace()
{
    if (m_bench.loading().isRunning())
        m_files->setCurrentWidget(m_loadingState);
    else if (m_recent->rowCount() == 0)
        m_files->setCurrentWidget(m_noFiles);
    else
        m_files->setCurrentWidget(m_table);
}

void SourcePage::showUse()
{
    const bool recording = m_bench.acquisition().isRecording();
    const int row = m_bridges->rowOf(m_chosenSource);
    QString text = tr("Use source");
    bool usable = false;
    QString why = tr("Choose a bridge or a file.");
    if (row >= 0) {
        const DeviceEntry &device = m_bridges->device(row);
        text = device.kind == DeviceKind::SimulatedBridge
                   ? tr("Use simulated bridge")
                   : tr("Use %1").arg(QString::fromStdString(device.name));
        usable = device.usable() || device.inUse;
        why = QString::fromStdString(device.sentence());
    } else if (!m_chosenFile.empty()) {
        const bool session = m_chosenFile.extension() == kSessionEnding;
        text = session                                           ? tr("Open session")
               : m_form->isLog() && m_form->log().isPlayedBack() ? tr("Play back")
                                                                 : tr("Read in");
        usable = !m_bench.loading().isRunning();
        why = tr("Other logs are being read.");
    }
    if (recording)
        why = tr("A run is being recorded. Stop it to take another source.");
    m_use->setText(text);
    m_use->setEnabled(usable && !recording);
    m_use->setToolTip(usable && !recording ? QString() : why);
    m_list->setEnabled(!recording);
    const auto &runs = m_bench.session().runs();
    head().setContext(runs.empty() ? tr("Where the samples come from. Nothing is recorded yet.")
                                   : tr("Where the samples come from. %n runs so far.", nullptr,
                                        static_cast<int>(runs.size())));
    // A session with runs says where they come from; what is only looked at is marked where it stands.
    head().setOrigin(runs.empty()                      ? Origin::None
                     : m_bench.session().isSimulated() ? Origin::Simulated
                                                       : Origin::Real);
}

void SourcePage::retranslate()
{
    head().setTitle(stepName(Step::Source));
    m_use->setProperty("shownShortcut", tr("Enter"));
    m_lookAgain->setText(tr("Look again"));
    m_copyLine->setText(tr("Copy line"));
    m_bridgesHead->setTitle(tr("Bridges"));
    m_bridgesHead->setAside(tr("USB-HID, looked for every second"));
    m_recentHead->setTitle(tr("Recent files"));
    m_nowHead->setTitle(tr("Now"));
    m_nowHead->setNote(tr("last 60 s"));
    m_list->setAccessibleName(tr("Bridges"));
    m_table->setAccessibleName(tr("Recent files"));
    m_drop->setText(
        tr("Drop log files here: CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content."));
    m_noFiles->setTexts(tr("No files yet"), tr("Logs and sessions that were opened stand here."));
    m_form->retranslate();
    if (const int row = m_bridges->rowOf(m_chosenSource); row >= 0)
        m_form->showDevice(m_bridges->device(row));
    m_recent->lookAgain();
    showPermission();
    showUse();
}

} // namespace driftbench
