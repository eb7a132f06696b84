// The page Export: every form of a real model, files on the disk, and a table into the simulated bridge.
#include "app/gui/export/device_panel.h"
#include "app/gui/export/file_choices.h"
#include "app/gui/export/upload_steps.h"
#include "app/gui/pages/export_page.h"
#include "engine/exports/table_json.h"
#include "support/gui_bench.h"
#include "widgets/controls/banner_slot.h"
#include "widgets/controls/text_label.h"
#include "widgets/tables/data_table.h"
#include "widgets/views/table_error_view.h"

#include <QCheckBox>
#include <QFile>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiExport : public QObject
{
    Q_OBJECT

private slots:
    void page_withoutModel_saysWhatToDo();
    void preview_everyForm_isWhatTheEngineExports();
    void files_saved_readBackAndAreRecorded();
    void files_unwritableFolder_saysSo();
    void upload_simulatedBridge_holdsTheTable();
    void upload_cancelled_leavesTheOldTable();
    void upload_otherSensor_isRefusedInWords();
    void restore_afterTwoUploads_bringsTheFirstBack();

private:
    static std::unique_ptr<GuiBench> trained();
};

static constexpr int kPatienceMs = 60000;

static void chooseSimulatedBridge(GuiBench &bench, const std::string &serial)
{
    SimulatedChoice simulated;
    simulated.sensor = "L3GD20H";
    simulated.serial = serial;
    SourceChoice choice;
    choice.from = simulated;
    bench.workbench->setSourceChoice(choice);
}

std::unique_ptr<GuiBench> TestGuiExport::trained()
{
    auto bench = std::make_unique<GuiBench>(3);
    bench->setModels({"constant", "linear", "cubic", "rbf"});
    if (!bench->train())
        qFatal("not trained");
    ExportChoice choice = bench->session().exportChoice();
    choice.model = "rbf";
    choice.options.force = true; // what is written is the matter here, not the verdict
    if (!bench->session().setExportChoice(choice))
        qFatal("choice");
    return bench;
}

static bool hasPreview(const ExportPage &page)
{
    return QTest::qWaitFor([&page] { return page.preview() != nullptr && page.preview()->table; },
                           kPatienceMs);
}

static bool hasDevice(const ExportPage &page)
{
    return QTest::qWaitFor([&page] { return page.device().tables().has_value() && page.device().canWrite(); },
                           kPatienceMs);
}

void TestGuiExport::page_withoutModel_saysWhatToDo()
{
    GuiBench bench(1);
    ExportPage page(*bench.context);
    showPage(page);
    QVERIFY(page.preview() == nullptr);
    QVERIFY(page.errors().isEmpty());
    QVERIFY(!page.saveAction()->isEnabled());
    QCOMPARE(page.origin(), Origin::None);
}

void TestGuiExport::preview_everyForm_isWhatTheEngineExports()
{
    const auto bench = trained();
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    QCOMPARE(page.origin(), Origin::Simulated);
    const TrainedModel &model = *bench->session().chosenModel();
    const auto table = makeCompensationTable(model, {true, true, true});
    QVERIFY(table.ok());
    QCOMPARE(page.knots().model()->rowCount(), static_cast<int>(table->size()));
    QVERIFY(!page.errors().isEmpty());
    const ExportOptions options = bench->session().exportChoice().options;
    for (int form = 1; form <= 5; ++form) {
        page.choosePreview(form);
        const auto exported = exportModel(model, static_cast<ExportFormat>(form - 1), options);
        const QString wanted = QString::fromStdString(exported ? exported->text : exported.error().message);
        QCOMPARE(page.previewText(), wanted.left(400000));
        QVERIFY(!exported.ok() || wanted.contains(QStringLiteral("SIMULATED"), Qt::CaseInsensitive));
    }
    // Without a number as serial PX4 would not know the gyro again.
    QVERIFY(page.files().note(3)->text().contains(QStringLiteral("id"), Qt::CaseInsensitive));
    QVERIFY(page.files().note(4)->text().startsWith(QStringLiteral("cubic only")));
}

void TestGuiExport::files_saved_readBackAndAreRecorded()
{
    const auto bench = trained();
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    page.files().box(5)->setChecked(true);
    page.saveFiles(bench->folder.path().toStdString());
    QVERIFY(QTest::qWaitFor([&] { return bench->session().exports().size() == 4; }, kPatienceMs));
    for (const ExportRecord &record : bench->session().exports()) {
        QFile file(QString::fromStdString(record.path));
        QVERIFY2(file.open(QIODevice::ReadOnly), record.path.c_str());
        QCOMPARE(file.size(), record.bytes);
        if (record.format == "json") {
            const auto table = readTable(file.readAll().toStdString(), "json");
            QVERIFY(table.ok());
            QVERIFY(table->tdeDps == page.preview()->table->table.tdeDps);
        }
        if (record.format == "device") {
            const QByteArray bytes = file.readAll();
            QVERIFY(std::equal(bytes.begin(), bytes.end(), page.preview()->image.begin(),
                               page.preview()->image.end(),
                               [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
        }
    }
    QVERIFY(page.banners().holds(QStringLiteral("outcome")));
    QCOMPARE(page.stepState().mark, StepMark::Done);
}

void TestGuiExport::files_unwritableFolder_saysSo()
{
    const auto bench = trained();
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    page.saveFiles(bench->folder.filePath("not/there").toStdString());
    QTRY_VERIFY(page.banners().holds(QStringLiteral("outcome")));
    QVERIFY(bench->session().exports().empty());
    QVERIFY(page.saveAction()->isEnabled());
}

void TestGuiExport::upload_simulatedBridge_holdsTheTable()
{
    const auto bench = trained();
    chooseSimulatedBridge(*bench, "T-1");
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    QVERIFY(hasDevice(page));
    QTRY_VERIFY(page.preview() != nullptr); // made anew for the device's thermometer
    const std::vector<std::uint8_t> image = page.preview()->image;
    page.device().write();
    QVERIFY(page.device().isWriting());
    QCOMPARE(page.stepState().mark, StepMark::Working);
    QVERIFY(QTest::qWaitFor([&] { return !page.device().isWriting(); }, kPatienceMs));
    QCOMPARE(page.device().steps().state(), UploadSteps::State::Done);
    QCOMPARE(bench->session().uploads().size(), std::size_t(1));
    const UploadRecord upload = bench->session().uploads().front();
    QVERIFY(upload.verified && upload.activated);
    QCOMPARE(upload.crc32, deviceImageCrc(image));
    QVERIFY(QTest::qWaitFor([&] { return page.device().tables() && page.device().tables()->image; },
                            kPatienceMs));
    QCOMPARE(*page.device().tables()->image, image); // as the device gives it back
    QTRY_COMPARE(page.device().comparison().model()->index(5, 1).data().toString(),
                 page.device().comparison().model()->index(5, 2).data().toString());
}

void TestGuiExport::upload_cancelled_leavesTheOldTable()
{
    const auto bench = trained();
    chooseSimulatedBridge(*bench, "T-1");
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    QVERIFY(hasDevice(page));
    page.device().write();
    page.device().cancel();
    QVERIFY(QTest::qWaitFor([&] { return !page.device().isWriting(); }, kPatienceMs));
    QCOMPARE(page.device().steps().state(), UploadSteps::State::Failed);
    QVERIFY(bench->session().uploads().empty());
    QVERIFY(QTest::qWaitFor([&] { return page.device().canWrite(); }, kPatienceMs));
    QVERIFY(!page.device().tables()->status.activeBank);
}

void TestGuiExport::upload_otherSensor_isRefusedInWords()
{
    const auto bench = trained();
    chooseSimulatedBridge(*bench, "OTHER");
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    QVERIFY(hasDevice(page));
    page.device().write();
    QVERIFY(QTest::qWaitFor([&] { return !page.device().isWriting(); }, kPatienceMs));
    QVERIFY(page.banners().holds(QStringLiteral("outcome")));
    QVERIFY2(page.banners().banner().content().toDo.contains(QStringLiteral("OTHER")),
             qPrintable(page.banners().banner().content().toDo));
    QVERIFY(bench->session().uploads().empty());
}

void TestGuiExport::restore_afterTwoUploads_bringsTheFirstBack()
{
    const auto bench = trained();
    chooseSimulatedBridge(*bench, "T-1");
    ExportPage page(*bench->context);
    showPage(page);
    QVERIFY(hasPreview(page));
    QVERIFY(hasDevice(page));
    page.device().write();
    QVERIFY(QTest::qWaitFor(
        [&] { return bench->session().uploads().size() == 1 && page.device().canRestore(); }, kPatienceMs));
    ExportChoice choice = bench->session().exportChoice();
    choice.model = "linear";
    QVERIFY(bench->session().setExportChoice(choice).ok());
    QVERIFY(
        QTest::qWaitFor([&] { return page.preview() && page.preview()->model == "linear"; }, kPatienceMs));
    page.device().write();
    QVERIFY(QTest::qWaitFor(
        [&] { return bench->session().uploads().size() == 2 && page.device().canRestore(); }, kPatienceMs));
    const std::uint32_t first = bench->session().uploads().front().crc32;
    QTRY_VERIFY(page.device().tables()->image && deviceImageCrc(*page.device().tables()->image) != first);
    page.device().restore();
    QVERIFY(QTest::qWaitFor(
        [&] {
            const auto &tables = page.device().tables();
            return tables && tables->image && deviceImageCrc(*tables->image) == first;
        },
        kPatienceMs));
}

QTEST_MAIN(TestGuiExport)
#include "tst_gui_export.moc"
