#include "app/gui/export/device_panel.h"

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
static constexpr int kDifferenceWidth = 210;
static constexpr double kWrittenShare = 0.45; // of an upload (device/table_upload.cpp)
static constexpr double kReadBackShare = 0.9;

static QString bankName(std::uint8_t bank)
{
    return QString(QChar(u'A' + bank));
}

static QString crcText(std::uint32_t crc)
{
    return QStringLiteral("%1").arg(crc, 8, 16, QLatin1Char('0')).toUpper();
}

DevicePanel::DevicePanel(Workbench &bench, QAction *restore, QAction *cancel, QAction *toSource,
                         QWidget *parent)
    : QWidget(parent)
    , m_bench(bench)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(QStringLiteral("chip")))
    , m_head(new SectionHead)
    , m_restoreButton(new ActionButton(restore, ButtonSize::Small))
    , m_restore(restore)
    , m_cancel(cancel)
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
    deviceRows->addWidget(buildFacts(), 1);
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
    auto *table = new Panel;
    table->setFlush();
    table->rows()->addWidget(m_pairs);
    table->setFixedHeight(m_pairs->heightOfRows(kFactRows) + 8);
    columns->addWidget(table, 1, Qt::AlignTop);
    m_difference = new TableDifferenceView;
    m_difference->enableInteraction();
    auto *plot = new Panel;
    plot->setFlush();
    plot->rows()->addWidget(m_difference);
    plot->setFixedWidth(kDifferenceWidth);
    m_difference->setMinimumSize(100, 100);
    columns->addWidget(plot);
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
    m_modelName = model != nullptr ? modelTitle(model->name, model).toStdString() : std::string();
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

void DevicePanel::showProgress(const QString &stage, double fraction)
{
    if (!m_writing)
        return;
    m_fraction = fraction;
    using State = UploadSteps::State;
    const bool reading = fraction >= kWrittenShare && fraction < kReadBackShare;
    const bool activating = fraction >= kReadBackShare;
    const UploadSteps::Step step = activating        ? UploadSteps::Activate
                                   : reading         ? UploadSteps::ReadBack
                                   : stage.isEmpty() ? UploadSteps::Begin
                                                     : UploadSteps::Write;
    if (step >= UploadSteps::Write)
        showBytes(UploadSteps::Write, fraction / kWrittenShare);
    if (step >= UploadSteps::ReadBack)
        showBytes(UploadSteps::ReadBack, (fraction - kWrittenShare) / (kReadBackShare - kWrittenShare));
    m_steps->setState(State::Running, step);
    m_bar->setValue(static_cast<int>(1000.0 * fraction));
    m_percent->setText(tr("%1 %").arg(numberText(100.0 * fraction, 0)));
    m_title->setText(activating && !stage.isEmpty() ? tr("Activating and checking")
                                                    : tr("Writing the spare bank"));
    m_note->setText(tr("The table in use stays active until the last step."));
    m_cancelButton->show();
    emit stateChanged();
}

void DevicePanel::showBytes(int step, double share)
{
    const double bytes = m_preview ? static_cast<double>(m_preview->image.size()) : 0.0;
    m_steps->setDetail(
        static_cast<UploadSteps::Step>(step),
        tr("%1 of %2 B").arg(numberText(std::min(1.0, share) * bytes, 0), numberText(bytes, 0)));
}

void DevicePanel::showUploadIdle()
{
    m_fraction = 0.0;
    m_showOutcome = {};
    m_steps->setState(UploadSteps::State::Idle);
    for (int step = 0; step < UploadSteps::kSteps; ++step)
        m_steps->setDetail(static_cast<UploadSteps::Step>(step), {});
    m_bar->setValue(0);
    m_percent->setText({});
    m_title->setText(tr("Write to the device"));
    m_note->setText(tr("The table in use stays active until the last step."));
    m_cancelButton->hide();
}

void DevicePanel::showWord(const QString &text, int tone)
{
    m_result->setTone(static_cast<Tone>(tone));
    m_result->setText(text);
    m_result->setVisible(!text.isEmpty());
}

// What was compared at work, where the device can stream its own samples beside the raw ones.
static QString checkText(const TableUploadReport &report)
{
    if (!report.check)
        return DevicePanel::tr("Read back and verified. This device can't show its compensation at work.");
    const CompensationCheck &check = *report.check;
    if (report.rolledBack)
        return DevicePanel::tr(
                   "Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.")
            .arg(check.differing)
            .arg(check.samples)
            .arg(numberText(check.worstDps, 4));
    return DevicePanel::tr(
        "Verified at work: %n sample(s) compared with what the host computes, none differs.", nullptr,
        check.samples);
}

void DevicePanel::uploaded(const Result<UploadOutcome> &outcome)
{
    m_writing = false;
    m_cancelButton->hide();
    QTimer::singleShot(0, this, &DevicePanel::look);
    if (!outcome) {
        const bool cancelled = outcome.error().code == Errc::Cancelled;
        m_steps->setState(UploadSteps::State::Failed, m_steps->current());
        m_showOutcome = [this, cancelled] {
            m_title->setText(cancelled ? tr("Cancelled") : tr("Not written"));
            m_note->setText({});
        };
        m_showOutcome();
        showWord(QString::fromStdString(outcome.error().message), int(cancelled ? Tone::Plain : Tone::Bad));
        emit told(!cancelled, cancelled ? tr("The upload was cancelled.") : tr("The table was not written."),
                  QString::fromStdString(outcome.error().message));
        emit stateChanged();
        return;
    }
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

void DevicePanel::showUploaded(const TableUploadReport &report)
{
    // The last of the progress may never have come, where it all went fast.
    showBytes(UploadSteps::Write, 1.0);
    showBytes(UploadSteps::ReadBack, 1.0);
    m_steps->setDetail(UploadSteps::Verify, crcText(report.crc));
    m_steps->setDetail(UploadSteps::Commit, tr("gen. %1").arg(report.generation));
    m_steps->setDetail(UploadSteps::Activate, tr("bank %1").arg(bankName(report.bank)));
    m_percent->setText(tr("%1 %").arg(100));
    m_title->setText(report.rolledBack ? tr("Rolled back")
                                       : tr("Bank %1 is in use").arg(bankName(report.bank)));
    showWord(checkText(report), int(report.rolledBack ? Tone::Bad : Tone::Good));
}

void DevicePanel::record(const UploadOutcome &outcome)
{
    const TableUploadReport &report = outcome.report;
    UploadRecord made;
    if (m_preview)
        made.model = m_bench.session().modelId(m_preview->model);
    made.sensor = outcome.device.sensor;
    made.device = m_bench.sourceName().toStdString();
    const DeviceTableKind kind = m_bench.session().exportChoice().deviceTable;
    made.kind = kind == DeviceTableKind::FixedPoint ? "fixed" : "float";
    made.bank = report.bank;
    made.generation = report.generation;
    made.bytes = report.bytes;
    made.crc32 = report.crc;
    made.verified = true;
    made.activated = report.activated;
    made.outcome = checkText(report).toStdString();
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

// By this session's uploads; an image itself does not say.
QString DevicePanel::modelOf(std::uint32_t crc) const
{
    for (const UploadRecord &upload : m_bench.session().uploads()) {
        if (upload.crc32 != crc)
            continue;
        const auto models = m_bench.session().file().models();
        if (!models || !upload.model)
            break;
        for (const ModelRecord &model : *models) {
            if (model.id == *upload.model)
                return modelLabel(model.name);
        }
    }
    return tr("not known here");
}

static QString rangeText(const CompensationTable &table)
{
    return DevicePanel::tr("%1 to %2 °C, %3 rows")
        .arg(numberText(table.firstTemperatureC(), 1), numberText(table.lastTemperatureC(), 1))
        .arg(table.size());
}

static QString kindText(DeviceTableKind kind)
{
    return kind == DeviceTableKind::FixedPoint ? DevicePanel::tr("fixed point") : DevicePanel::tr("float32");
}

static QString thermometerText(DeviceThermometer thermometer)
{
    return thermometer == DeviceThermometer::Die ? DevicePanel::tr("on the die")
                                                 : DevicePanel::tr("external");
}

static std::optional<DeviceImage> decoded(const std::vector<std::uint8_t> &bytes)
{
    auto image = decodeDeviceImage(bytes, "the table");
    return image ? std::optional(*std::move(image)) : std::nullopt;
}

void DevicePanel::showFacts()
{
    const QString none = QStringLiteral("–");
    std::vector<FactPair> pairs{{tr("Bank, generation"), tr("none"), none},
                                {tr("Model"), none, none},
                                {tr("Range, rows"), none, none},
                                {tr("Kind, thermometer"), none, none},
                                {tr("Sensor"), none, none},
                                {tr("CRC-32"), none, none}};
    std::shared_ptr<const CompensationTable> current, fresh;
    const auto fill = [&pairs](const DeviceImage &image, std::uint32_t crc, QString FactPair::*side) {
        pairs[2].*side = rangeText(image.table);
        pairs[3].*side = tr("%1, %2").arg(kindText(image.kind()), thermometerText(image.thermometer));
        pairs[4].*side = QString::fromStdString(image.table.provenance.sensor.text());
        pairs[5].*side = crcText(crc);
    };
    if (m_tables && m_tables->image) {
        if (const auto image = decoded(*m_tables->image)) {
            const std::uint32_t crc = deviceImageCrc(*m_tables->image);
            fill(*image, crc, &FactPair::here);
            pairs[1].here = modelOf(crc);
            current = std::make_shared<const CompensationTable>(image->table);
        }
    }
    if (m_tables && m_tables->status.activeBank) {
        const std::uint8_t bank = *m_tables->status.activeBank;
        pairs[0].here = tr("%1, %2, active").arg(bankName(bank)).arg(m_tables->status.banks[bank].generation);
    }
    if (m_preview && !m_preview->image.empty()) {
        if (const auto image = decoded(m_preview->image)) {
            fill(*image, deviceImageCrc(m_preview->image), &FactPair::there);
            pairs[1].there = QString::fromStdString(m_modelName);
            fresh = std::make_shared<const CompensationTable>(image->table);
        }
        if (m_tables) {
            std::uint32_t latest = 0;
            for (const BridgeBank &bank : m_tables->status.banks)
                latest = std::max(latest, bank.generation);
            const std::uint8_t spare = m_tables->status.activeBank == std::uint8_t{0} ? 1 : 0;
            pairs[0].there = tr("%1, %2").arg(bankName(spare)).arg(latest + 1);
        }
    } else if (m_preview && m_preview->imageRefusal) {
        pairs[1].there = tr("no image: see Files");
    }
    m_pairsModel->setHeads(tr("On the device now"), tr("Would be written"));
    m_pairsModel->setPairs(std::move(pairs));
    m_difference->setData(current, fresh);
    const bool simulated = m_bench.sourceChoice() && m_bench.isSourceSimulated();
    if (m_tables) {
        m_head->setTitle(tr("Device %1").arg(QString::fromStdString(m_tables->device.sensor.serial)));
        const QString firmware = QString::fromStdString(m_tables->device.firmwareText());
        const QString model = QString::fromStdString(m_tables->device.sensor.model);
        m_head->setNote(simulated ? tr("%1, firmware %2, simulated").arg(model, firmware)
                                  : tr("%1, firmware %2").arg(model, firmware));
    } else {
        m_head->setTitle(tr("Device"));
        m_head->setNote({});
    }
    m_stack->setCurrentIndex(m_tables ? 1 : 0);
    if (!m_bench.sourceChoice())
        m_empty->setTexts(tr("No device chosen"),
                          tr("Choose the simulated bridge or a plugged-in one as source."));
    else if (m_problem)
        m_empty->setTexts(tr("No tables there"), QString::fromStdString(m_problem->message));
    else
        m_empty->setTexts(tr("Looking at the device"), m_bench.sourceName());
    m_empty->setActions(m_bench.sourceChoice() && !m_problem ? std::vector<QAction *>{}
                                                             : std::vector<QAction *>{m_toSource});
    emit stateChanged();
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
