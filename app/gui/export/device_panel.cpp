#include "app/gui/export/device_panel.h"

#include "app/gui/export/device_words.h"
#include "app/gui/export/upload_steps.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/section_head.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"
#include "widgets/style/theme.h"
#include "widgets/tables/data_table.h"
#include "widgets/tables/pairs_table_model.h"
#include "widgets/views/table_error_view.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace driftbench {

static constexpr int kFactRows = 6;

DevicePanel::DevicePanel(Workbench &bench, QAction *restore, QAction *cancel, QAction *look,
                         QAction *toSource, QWidget *parent)
    : QWidget(parent)
    , m_bench(bench)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(QStringLiteral("chip")))
    , m_head(new SectionHead)
    , m_restoreButton(new ActionButton(restore, ButtonSize::Small))
    , m_restore(restore)
    , m_cancel(cancel)
    , m_look(look)
    , m_toSource(toSource)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    m_head->addControl(m_restoreButton);
    rows->addWidget(m_head);
    rows->addWidget(m_stack, 1);
    auto *emptyPanel = new Panel;
    emptyPanel->rows()->addWidget(m_empty);
    m_stack->addWidget(emptyPanel);
    auto *device = new QWidget;
    auto *deviceRows = new QVBoxLayout(device);
    deviceRows->setContentsMargins(0, 0, 0, 0);
    deviceRows->setSpacing(kGap);
    deviceRows->addWidget(buildFacts());
    deviceRows->addWidget(buildUpload());
    m_stack->addWidget(device);
    connectJob();
    showUploadIdle();
    showFacts();
}

QWidget *DevicePanel::buildFacts()
{
    auto *facts = new QWidget;
    auto *columns = new QHBoxLayout(facts);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    m_pairs = new DataTable(QString());
    m_pairsModel = new PairsTableModel(this);
    m_pairs->setTableModel(m_pairsModel);
    m_pairs->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_pairs->setKeptInView(true);
    auto *table = new Panel;
    table->setFlush();
    table->rows()->addWidget(m_pairs);
    table->setFixedHeight(m_pairs->heightOfRows(kFactRows) + 8);
    columns->addWidget(table, 2);
    m_difference = new TableDifferenceView;
    m_difference->enableInteraction();
    auto *plot = new Panel;
    plot->setFlush();
    plot->rows()->addWidget(m_difference);
    plot->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored); // as high as the table
    columns->addWidget(plot, 1);
    return facts;
}

QWidget *DevicePanel::buildUpload()
{
    auto *panel = new Panel;
    panel->rows()->setSpacing(kGap);
    auto *head = new QHBoxLayout;
    m_title = new TextLabel(TextRole::Section);
    m_note = new TextLabel(TextRole::Note);
    m_note->setElided(true);
    m_note->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_cancelButton = new ActionButton(m_cancel, ButtonSize::Small);
    head->addWidget(m_title);
    head->addWidget(m_note, 1);
    head->addWidget(m_cancelButton);
    panel->rows()->addLayout(head);
    auto *bar = new QHBoxLayout;
    m_bar = new QProgressBar;
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(8);
    m_percent = new TextLabel(TextRole::StrongNote);
    m_percent->setFixedWidth(40);
    m_percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    bar->addWidget(m_bar, 1);
    bar->addWidget(m_percent);
    panel->rows()->addLayout(bar);
    m_steps = new UploadSteps;
    panel->rows()->addWidget(m_steps);
    m_result = new TextLabel(TextRole::Note);
    m_result->setWordWrap(true);
    m_result->hide();
    panel->rows()->addWidget(m_result);
    return panel;
}

void DevicePanel::connectJob()
{
    UploadJob &job = m_bench.upload();
    connect(&job, &UploadJob::looked, this, &DevicePanel::lookedAt);
    connect(&job, &UploadJob::uploaded, this, &DevicePanel::uploaded);
    connect(&job, &UploadJob::rolledBack, this, &DevicePanel::rolledBack);
    connect(&job, &Job::progress, this, &DevicePanel::showProgress);
    connect(&job, &Job::runningChanged, this, [this](bool running) {
        if (!running && std::exchange(m_lookAgain, false))
            look();
        emit stateChanged();
    });
    connect(&m_bench.acquisition(), &Acquisition::stateChanged, this, [this](Acquisition::State state) {
        if (state == Acquisition::State::Idle && std::exchange(m_lookAgain, false))
            look();
    });
    // Plugged in again, perhaps.
    connect(&m_bench, &Workbench::devicesChanged, this, [this] {
        if (m_problem && isVisible())
            look();
    });
    connect(&m_bench, &Workbench::sourceChanged, this, [this] {
        m_tables.reset();
        m_problem.reset();
        showUploadIdle();
        showFacts();
        if (isVisible())
            look();
    });
}

void DevicePanel::setPreview(std::shared_ptr<const ExportPreview> preview, const TrainedModel *model)
{
    m_preview = std::move(preview);
    m_modelName = model != nullptr ? deviceModelName(model->name, model).toStdString() : std::string();
    showFacts();
}

void DevicePanel::setPreviewStale(bool stale)
{
    if (std::exchange(m_previewStale, stale) != stale)
        emit stateChanged();
}

bool DevicePanel::canWrite() const
{
    return m_preview && !m_previewStale && !m_preview->image.empty() && m_tables &&
           !m_bench.upload().isRunning();
}

bool DevicePanel::canRestore() const
{
    return m_tables && m_tables->status.activeBank && !m_bench.upload().isRunning();
}

DeviceThermometer DevicePanel::thermometer() const
{
    const auto &choice = m_bench.sourceChoice();
    const bool external = choice && choice->thermometer != ThermometerChoice::Die && m_tables &&
                          m_tables->device.can(BRIDGE_CAN_EXTERNAL);
    return external ? DeviceThermometer::External : DeviceThermometer::Die;
}

void DevicePanel::look()
{
    if (!m_bench.sourceChoice()) {
        m_tables.reset();
        showFacts();
        return;
    }
    if (m_bench.upload().isRunning()) {
        m_lookAgain = !m_writing;
        return;
    }
    // A device has one user at a time: it is watched by another page no longer.
    const bool watched =
        m_bench.acquisition().state() != Acquisition::State::Idle && m_bench.sourceUse() == SourceUse::Watch;
    if (watched && !m_bench.isSourceSimulated()) {
        m_lookAgain = true;
        return m_bench.stopSource();
    }
    m_bench.upload().look(m_bench.clientOpener());
}

void DevicePanel::write()
{
    if (!canWrite())
        return;
    m_writing = m_bench.upload().upload(m_bench.clientOpener(), m_preview->image);
    if (!m_writing)
        return;
    m_result->hide();
    showProgress({}, 0.0);
    emit stateChanged();
}

void DevicePanel::restore()
{
    if (canRestore())
        m_bench.upload().rollBack(m_bench.clientOpener());
}

void DevicePanel::cancel()
{
    if (m_writing)
        m_bench.upload().cancel();
}

void DevicePanel::lookedAt(const Result<DeviceTables> &tables)
{
    const DeviceThermometer before = thermometer();
    m_tables.reset();
    m_problem.reset();
    if (tables)
        m_tables = *tables;
    else
        m_problem = tables.error();
    showFacts();
    if (thermometer() != before)
        emit thermometerKnown();
    emit looked();
    emit stateChanged();
}

void DevicePanel::uploaded(const Result<UploadOutcome> &outcome)
{
    m_writing = false;
    m_cancelButton->hide();
    QTimer::singleShot(0, this, &DevicePanel::look);
    if (!outcome)
        return showFailed(outcome.error());
    const TableUploadReport &report = outcome->report;
    m_steps->setState(report.rolledBack ? UploadSteps::State::Failed : UploadSteps::State::Done,
                      UploadSteps::Activate);
    m_bar->setValue(1000);
    m_note->setText(QString::fromStdString(outcome->device.sensor.text()));
    m_showOutcome = [this, report] { showUploaded(report); };
    m_showOutcome();
    record(*outcome);
    emit told(report.rolledBack,
              report.rolledBack ? tr("The new table was rolled back.") : tr("The table is on the device."),
              checkText(report));
    emit stateChanged();
}

void DevicePanel::record(const UploadOutcome &outcome)
{
    UploadRecord made = uploadRecord(outcome, m_bench.session().exportChoice().deviceTable,
                                     checkText(outcome.report).toStdString());
    if (m_preview)
        made.model = m_bench.session().modelId(m_preview->model);
    made.device = m_bench.sourceName().toStdString();
    if (const Status kept = m_bench.session().addUpload(std::move(made)); !kept)
        emit m_bench.problem(kept.error());
}

void DevicePanel::rolledBack(const Result<TableRollbackReport> &outcome)
{
    QTimer::singleShot(0, this, &DevicePanel::look);
    if (!outcome) {
        showWord(QString::fromStdString(outcome.error().message), int(Tone::Bad));
        emit told(true, tr("The table before was not restored."),
                  QString::fromStdString(outcome.error().message));
        return;
    }
    showUploadIdle();
    const auto &active = outcome->after.activeBank;
    const QString now = active ? tr("Bank %1, generation %2, is in use again.")
                                     .arg(bankName(*active))
                                     .arg(outcome->after.banks[*active].generation)
                               : tr("No table is in use any more; the device sends raw rates.");
    showWord(now, int(Tone::Good));
    emit told(false, tr("The table was taken out of use."), now);
}

QString DevicePanel::statusText() const
{
    if (!m_tables)
        return {};
    const auto &active = m_tables->status.activeBank;
    const QString now = active ? tr("Bank %1 active").arg(bankName(*active)) : tr("No table active");
    return m_writing ? tr("%1, the spare bank being written").arg(now) : now;
}

void DevicePanel::retranslate()
{
    m_pairs->setAccessibleName(tr("On the device now against what would be written"));
    if (m_showOutcome)
        m_showOutcome();
    else if (!m_writing)
        showUploadIdle();
    showFacts();
}

} // namespace driftbench
