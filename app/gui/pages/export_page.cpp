#include "app/gui/pages/export_page.h"

#include "app/gui/banner_of.h"
#include "app/gui/event_log.h"
#include "app/gui/export/device_panel.h"
#include "app/gui/export/file_choices.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "engine/base/atomic_file.h"
#include "engine/base/checksum.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"
#include "widgets/tables/data_table.h"
#include "widgets/tables/knots_table_model.h"
#include "widgets/views/plot_panel.h"
#include "widgets/views/table_error_view.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace driftbench {

static constexpr int kLeftWidth = 456;
static const char *const kOutcome = "outcome";

ExportPage::ExportPage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(stepIcon(Step::Export)))
    , m_model(new QComboBox)
    , m_tableHead(new SectionHead)
    , m_form(new QComboBox)
    , m_forms(new QStackedWidget)
    , m_knots(new DataTable(QString()))
    , m_knotsModel(new KnotsTableModel(this))
    , m_text(new QPlainTextEdit)
    , m_files(new FileChoices)
    , m_errors(new TableErrorView)
{
    m_save = addPageAction({}, QStringLiteral("file"), [this] { askFolder(); });
    m_write = addPageAction(QKeySequence(Qt::CTRL | Qt::Key_U), QStringLiteral("write"), [this] {
        banners().withdraw(QString::fromLatin1(kOutcome));
        m_device->write();
    });
    m_restore = addPageAction({}, QStringLiteral("restore"), [this] { m_device->restore(); });
    m_cancel =
        addPageAction(QKeySequence(Qt::Key_Escape), QStringLiteral("stop"), [this] { m_device->cancel(); });
    m_toSource =
        addPageAction({}, QStringLiteral("source"), [this] { this->context().navigator.go(Step::Source); });
    m_toTrain =
        addPageAction({}, QStringLiteral("train"), [this] { this->context().navigator.go(Step::Train); });
    m_look = addPageAction(QKeySequence(Qt::Key_F5), QStringLiteral("refresh"), [this] { m_device->look(); });
    setPrimaryAction(m_write);
    head().addControl(m_model);
    head().addControl(new ActionButton(m_save, ButtonSize::Head));
    auto *write = new ActionButton(m_write, ButtonSize::Head);
    write->setPrimary(true);
    head().addControl(write);
    m_model->setFixedHeight(kHeadHeight);
    auto *emptyPanel = new Panel;
    emptyPanel->rows()->addWidget(m_empty);
    m_stack->addWidget(emptyPanel);
    auto *splitter = new QSplitter(Qt::Horizontal);
    splitter->setObjectName(QStringLiteral("exportSplitter"));
    splitter->setHandleWidth(kWideGap);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(buildLeft());
    splitter->addWidget(buildRight());
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({kLeftWidth, 2 * kLeftWidth});
    m_stack->addWidget(splitter);
    setBody(m_stack);
    if (context.workbench != nullptr)
        connectSession();
}

ExportPage::~ExportPage() = default;

QWidget *ExportPage::buildLeft()
{
    auto *left = new QWidget;
    auto *rows = new QVBoxLayout(left);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    left->setMinimumWidth(380);
    m_tableHead->addControl(m_form);
    rows->addWidget(m_tableHead);
    m_knots->setTableModel(m_knotsModel);
    m_knots->setYieldingColumns(KnotsTableModel::codeColumns());
    m_text->setReadOnly(true);
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setTabChangesFocus(true);
    m_forms->addWidget(m_knots);
    m_forms->addWidget(m_text);
    auto *panel = new Panel;
    panel->setFlush();
    panel->rows()->addWidget(m_forms);
    rows->addWidget(panel, 1);
    rows->addWidget(m_files);
    return left;
}

QWidget *ExportPage::buildRight()
{
    auto *right = new QWidget;
    auto *rows = new QVBoxLayout(right);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    auto *errors = new PlotPanel(m_errors);
    errors->setMinimumHeight(180);
    rows->addWidget(errors, 1);
    if (context().workbench != nullptr) {
        m_device = new DevicePanel(*context().workbench, m_restore, m_cancel, m_look, m_toSource);
        rows->addWidget(m_device);
    }
    return right;
}

void ExportPage::connectSession()
{
    Workbench &bench = *context().workbench;
    connect(&bench, &Workbench::resultChanged, this, [this] {
        showModels();
        makePreview();
    });
    connect(&bench, &Workbench::exportChoiceChanged, this, [this] {
        showModels();
        makePreview();
    });
    connect(&bench, &Workbench::sessionReplaced, this, [this] {
        banners().withdraw(QString::fromLatin1(kNotes));
        banners().withdraw(QString::fromLatin1(kOutcome));
    });
    connect(m_files, &FileChoices::edited, this, &ExportPage::choiceEdited);
    connect(m_files, &FileChoices::chosenChanged, this, &ExportPage::showButtons);
    connect(m_model, &QComboBox::activated, this, &ExportPage::chooseModel);
    connect(m_form, &QComboBox::currentIndexChanged, this, &ExportPage::showForm);
    connect(&m_previewing, &TaskJob::finished, this, &ExportPage::previewReady);
    connect(&m_saving, &TaskJob::finished, this, &ExportPage::savedFiles);
    connect(m_device, &DevicePanel::stateChanged, this, &ExportPage::showButtons);
    connect(m_device, &DevicePanel::thermometerKnown, this, [this] {
        ExportChoice choice = context().workbench->session().exportChoice();
        choice.deviceThermometer = m_device->thermometer();
        choiceEdited(choice);
    });
    connect(m_device, &DevicePanel::told, this, [this](bool bad, const QString &what, const QString &toDo) {
        context().events.add(bad ? EventKind::Bad : EventKind::Info, what + QLatin1Char(' ') + toDo);
        if (bad)
            banners().post(QString::fromLatin1(kOutcome), bannerOf(BannerKind::Bad, what, toDo, {m_look}));
    });
    showModels();
    makePreview();
}

void ExportPage::entered()
{
    if (context().workbench == nullptr)
        return;
    m_device->look();
    makePreview();
}

void ExportPage::choiceEdited(const ExportChoice &choice)
{
    Workbench &bench = *context().workbench;
    if (const Status set = bench.session().setExportChoice(choice); !set)
        emit bench.problem(set.error());
}

void ExportPage::chooseModel(int index)
{
    ExportChoice choice = context().workbench->session().exportChoice();
    choice.model = m_model->itemData(index).toString().toStdString();
    choiceEdited(choice);
}

void ExportPage::showModels()
{
    const Session &session = context().workbench->session();
    const QSignalBlocker quiet(m_model);
    m_model->clear();
    if (session.result()) {
        for (auto model = session.result()->models.rbegin(); model != session.result()->models.rend();
             ++model)
            m_model->addItem(model->name == "auto" ? tr("Recommended of each axis")
                                                   : modelTitle(model->name, &*model),
                             QString::fromStdString(model->name));
    }
    m_model->setCurrentIndex(m_model->findData(QString::fromStdString(session.exportChoice().model)));
    m_model->setVisible(session.result() != nullptr);
    m_files->show(session.exportChoice());
}

// All forms at once, off this thread; what was asked for meanwhile is made after it.
void ExportPage::makePreview()
{
    const Session &session = context().workbench->session();
    const TrainedModel *model = session.chosenModel();
    if (model == nullptr) {
        m_preview.reset();
        showPreview();
        return;
    }
    if (m_previewing.isRunning()) {
        m_previewAgain = true;
        return;
    }
    m_device->setPreviewStale(true);
    m_pending = std::make_shared<ExportPreview>();
    m_previewing.start([target = m_pending, trained = *model,
                        choice = session.exportChoice()](const ProgressHook &) -> Status {
        *target = makeExportPreview(trained, choice);
        return {};
    });
}

void ExportPage::previewReady(const Status &)
{
    m_preview = std::exchange(m_pending, nullptr);
    m_device->setPreviewStale(false);
    if (std::exchange(m_previewAgain, false))
        makePreview();
    showPreview();
}

void ExportPage::askFolder()
{
    auto *dialog = new QFileDialog(this, tr("Folder for the files"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString &folder) { saveFiles(std::filesystem::path(folder.toStdString())); });
    dialog->open();
}

void ExportPage::saveFiles(const std::filesystem::path &folder)
{
    const Session &session = context().workbench->session();
    const TrainedModel *model = session.chosenModel();
    if (model == nullptr || !m_preview || !m_preview->table || m_saving.isRunning())
        return;
    std::vector<FileText> files;
    m_records.clear();
    const auto add = [&](const std::string &format, const std::string &name, std::string text) {
        ExportRecord record;
        record.model = session.modelId(model->name);
        record.format = format;
        record.path = (folder / name).string();
        record.bytes = static_cast<std::int64_t>(text.size());
        record.crc32 = crc32(text);
        m_records.push_back(record);
        files.push_back({folder / name, std::move(text)});
    };
    for (const ExportFormat format : session.exportChoice().formats) {
        const FilePreview *file = m_preview->file(format);
        if (file != nullptr && !file->refusal)
            add(std::string(exportFormatName(format)), exportFileName(*model, format), file->exported.text);
    }
    if (m_files->imageChosen() && !m_preview->image.empty())
        add("device", imageFileName(*model), std::string(m_preview->image.begin(), m_preview->image.end()));
    m_folder = QString::fromStdString(folder.string());
    m_saving.start(
        [files = std::move(files)](const ProgressHook &) -> Status { return writeFilesTogether(files); });
    showButtons();
}

void ExportPage::savedFiles(const Status &outcome)
{
    const QString key = QString::fromLatin1(kOutcome);
    if (!outcome) {
        banners().post(key, bannerOf(
                                BannerKind::Bad, [] { return tr("The files were not written."); },
                                QString::fromStdString(outcome.error().message)));
        return showButtons();
    }
    for (const ExportRecord &record : m_records) {
        if (const Status kept = context().workbench->session().addExport(record); !kept)
            emit context().workbench->problem(kept.error());
    }
    const auto count = static_cast<int>(m_records.size());
    context().events.add(EventKind::Info, tr("%n file(s) written to %1.", nullptr, count).arg(m_folder));
    banners().post(
        key, bannerOf(
                 BannerKind::Info, [count] { return tr("%n file(s) written.", nullptr, count); }, m_folder));
    showButtons();
}

StepState ExportPage::stepState() const
{
    if (context().workbench == nullptr || m_device == nullptr)
        return {};
    if (m_device->isWriting())
        return {tr("Writing, %1 %").arg(numberText(100.0 * m_device->fraction(), 0)), true,
                StepMark::Working};
    const Session &session = context().workbench->session();
    if (!session.uploads().empty())
        return {tr("Table on %1").arg(QString::fromStdString(session.uploads().back().sensor.serial)), true,
                StepMark::Done};
    if (!session.exports().empty())
        return {tr("%n file(s) written", nullptr, static_cast<int>(session.exports().size())), true,
                StepMark::Done};
    return {session.result() ? tr("Nothing written") : QString(), false, StepMark::None};
}

QString ExportPage::hints() const
{
    if (m_device != nullptr && m_device->isWriting())
        return tr("Esc cancel, the old table stays · Ctrl+S save the files");
    return tr("Ctrl+S save the files · Ctrl+U write to the device · F5 look again · Ctrl+C copy the selected "
              "cells");
}

std::vector<StatusPart> ExportPage::statusParts() const
{
    if (m_device == nullptr || m_device->statusText().isEmpty())
        return {};
    return {{m_device->statusText()}};
}

void ExportPage::retranslate()
{
    head().setTitle(stepName(Step::Export));
    m_save->setProperty("shownShortcut", QKeySequence(QKeySequence::Save).toString(QKeySequence::NativeText));
    m_save->setText(tr("Save files…"));
    m_write->setText(tr("Write to device"));
    m_restore->setText(tr("Restore"));
    m_restore->setToolTip(tr("Takes the table out of use; the one before it takes over"));
    m_cancel->setText(tr("Cancel"));
    m_look->setText(tr("Look again"));
    m_toSource->setText(tr("Choose a source"));
    m_toTrain->setText(tr("Train"));
    m_empty->setTexts(tr("No model yet"), tr("Train a model first."));
    m_empty->setActions({m_toTrain});
    m_tableHead->setTitle(tr("Preview"));
    m_knots->setAccessibleName(tr("Table preview"));
    m_model->setAccessibleName(tr("Model"));
    m_form->setAccessibleName(tr("Shown form"));
    m_text->setAccessibleName(tr("Preview of the file"));
    {
        const QSignalBlocker quiet(m_form);
        const int form = std::max(0, m_form->currentIndex());
        m_form->clear();
        m_form->addItems({tr("Table"), tr("CSV"), tr("JSON"), tr("C header"), tr("PX4"), tr("ArduPilot"),
                          tr("Device image")});
        m_form->setCurrentIndex(form);
    }
    m_files->retranslate();
    if (m_device != nullptr) {
        m_device->retranslate();
        showModels();
        showPreview();
    }
}

} // namespace driftbench
