// No long work on the thread that draws: every call of the functions that do it, from reading a log to
// writing a table into a device, is caught on its way into the engine (by the linker, see
// tests/CMakeLists.txt), and the thread is noted that it comes from.
#include "support/fault_window.h"
#include "support/plugged_board.h"

#include "app/gui/compare/report_writer.h"
#include "app/gui/export/device_panel.h"
#include "app/gui/export/upload_steps.h"
#include "app/gui/pages/compare_page.h"
#include "app/gui/pages/export_page.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/source/bridge_list.h"
#include "app/report/figure_list.h"
#include "app/report/report_html.h"
#include "app/report/report_pdf.h"
#include "device/table_upload.h"
#include "engine/base/atomic_file.h"
#include "engine/evaluation/comparison.h"
#include "engine/exports/export_model.h"
#include "engine/features/run_features.h"
#include "engine/formats/csv_writer.h"
#include "engine/formats/log_reader.h"

#include <map>
#include <mutex>

using namespace driftbench;
using namespace driftbench::test;

namespace {

// By the name of the function, the threads that called it.
class Calls
{
public:
    void note(const char *function)
    {
        const std::lock_guard lock(m_mutex);
        m_threads[function].insert(std::this_thread::get_id());
    }
    void clear()
    {
        const std::lock_guard lock(m_mutex);
        m_threads.clear();
    }
    std::set<std::thread::id> of(const char *function)
    {
        const std::lock_guard lock(m_mutex);
        return m_threads[function];
    }

private:
    std::mutex m_mutex;
    std::map<std::string, std::set<std::thread::id>> m_threads;
};

Calls &calls()
{
    static Calls all;
    return all;
}

} // namespace

// The linker leads calls of the symbol to the first of the two; the second is the function itself.
#define CAUGHT(name, symbol, returns, parameters, arguments)                                                 \
    returns caught_##name parameters __asm__("__wrap_" symbol);                                              \
    returns real_##name parameters __asm__("__real_" symbol);                                                \
    returns caught_##name parameters                                                                         \
    {                                                                                                        \
        calls().note(#name);                                                                                 \
        return real_##name arguments;                                                                        \
    }

// clang-format off
CAUGHT(readLog,
       "_ZN10driftbench7readLogERKNSt10filesystem7__cxx114pathERKNS_11ReadOptionsERKSt8functionIFNS_4FlowERKNS_8ProgressEEE",
       Result<Recording>,
       (const std::filesystem::path &path, const ReadOptions &options, const ProgressHook &hook),
       (path, options, hook))
CAUGHT(makeTrainingSet,
       "_ZN10driftbench15makeTrainingSetERKNS_8CampaignEd",
       TrainingSet, (const Campaign &campaign, double referenceC), (campaign, referenceC))
CAUGHT(compareModels,
       "_ZN10driftbench13compareModelsERKNS_11TrainingSetERKNS_13CampaignFactsERKNS_17ComparisonOptionsERKSt8functionIFNS_4FlowERKNS_8ProgressEEE",
       Result<Comparison>,
       (const TrainingSet &set, const CampaignFacts &facts, const ComparisonOptions &options, const ProgressHook &hook),
       (set, facts, options, hook))
CAUGHT(prepareFigures,
       "_ZN10driftbench14prepareFiguresESt10shared_ptrIKNS_10ReportDataEERKSt8functionIFNS_4FlowERKNS_8ProgressEEE",
       Result<PreparedFigures>, (std::shared_ptr<const ReportData> data, const ProgressHook &hook),
       (std::move(data), hook))
CAUGHT(reportAsHtml,
       "_ZN10driftbench12reportAsHtmlERKNS_14ReportDocumentERKNS_7PaletteE",
       QByteArray, (const ReportDocument &document, const Palette &look), (document, look))
CAUGHT(reportAsPdf,
       "_ZN10driftbench11reportAsPdfERKNS_14ReportDocumentE",
       QByteArray, (const ReportDocument &document), (document))
CAUGHT(writeFileAtomically,
       "_ZN10driftbench19writeFileAtomicallyERKNSt10filesystem7__cxx114pathESt17basic_string_viewIcSt11char_traitsIcEE",
       Status, (const std::filesystem::path &target, std::string_view bytes), (target, bytes))
CAUGHT(writeFilesTogether,
       "_ZN10driftbench18writeFilesTogetherERKSt6vectorINS_8FileTextESaIS1_EE",
       Status, (const std::vector<FileText> &files), (files))
CAUGHT(exportModel,
       "_ZN10driftbench11exportModelERKNS_12TrainedModelENS_12ExportFormatERKNS_13ExportOptionsE",
       Result<Exported>, (const TrainedModel &model, ExportFormat format, const ExportOptions &options),
       (model, format, options))
CAUGHT(uploadTable,
       "_ZN10driftbench11uploadTableERNS_12BridgeClientESt4spanIKhLm18446744073709551615EERKNS_18TableUploadOptionsERKSt8functionIFNS_4FlowERKNS_8ProgressEEE",
       Result<TableUploadReport>,
       (BridgeClient &client, std::span<const std::uint8_t> image, const TableUploadOptions &options, const ProgressHook &hook),
       (client, image, options, hook))
// clang-format on

class TestGuiThreads : public QObject
{
    Q_OBJECT

private slots:
    void init() { calls().clear(); }
    void guard_callByThisThread_isSeen();
    void campaign_fromLogsToReports_isNotDrawnBy();
    void device_foundAndWrittenTo_isNotDrawnBy();

private:
    static void expectElsewhere(std::initializer_list<const char *> functions);
};

// Each was called, and never by this thread, which is the window's.
void TestGuiThreads::expectElsewhere(std::initializer_list<const char *> functions)
{
    for (const char *function : functions) {
        const std::set<std::thread::id> threads = calls().of(function);
        QVERIFY2(!threads.empty(), function);
        QVERIFY2(!threads.contains(std::this_thread::get_id()), function);
    }
}

void TestGuiThreads::guard_callByThisThread_isSeen()
{
    QVERIFY(calls().of("writeFilesTogether").empty());
    QVERIFY(writeFilesTogether({}).ok());
    QVERIFY(calls().of("writeFilesTogether").contains(std::this_thread::get_id()));
}

void TestGuiThreads::campaign_fromLogsToReports_isNotDrawnBy()
{
    FaultyWindow window(0);
    std::vector<std::filesystem::path> logs;
    for (int run = 0; run < 2; ++run) {
        logs.push_back(window.folder() / ("run" + std::to_string(run + 1) + ".csv"));
        QVERIFY(writeCsv(logs.back(), shortRun(run)).ok());
    }
    window.main().openFiles(logs);
    auto &inspect = window.page<InspectPage>(Step::Inspect);
    QTRY_VERIFY_WITH_TIMEOUT(inspect.seen() && window.session().runs().size() == 2, kPatienceMs);
    expectElsewhere({"readLog", "makeTrainingSet"});
    QVERIFY(window.train());
    expectElsewhere({"compareModels"});
    window.main().showStep(Step::Compare);
    auto &compare = window.page<ComparePage>(Step::Compare);
    for (const char *name : {"report.html", "report.pdf"}) {
        QSignalSpy finished(&compare.reports(), &ReportWriter::finished);
        compare.writeReport(window.folder() / name);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatienceMs);
        QVERIFY(finished.front().front().value<Status>().ok());
    }
    expectElsewhere({"prepareFigures", "reportAsHtml", "reportAsPdf", "writeFileAtomically"});
    QVERIFY(window.exportLine());
    window.main().showStep(Step::Export);
    auto &exports = window.page<ExportPage>(Step::Export);
    QTRY_VERIFY_WITH_TIMEOUT(exports.preview() && exports.preview()->model == "linear", kPatienceMs);
    exports.saveFiles(window.folder());
    QTRY_VERIFY_WITH_TIMEOUT(!window.session().exports().empty(), kPatienceMs);
    expectElsewhere({"exportModel", "writeFilesTogether"});
}

void TestGuiThreads::device_foundAndWrittenTo_isNotDrawnBy()
{
    const PluggedBoard board(5.0);
    FaultyWindow window(2, board.access(), true);
    auto *list = window.main().page(Step::Source)->findChild<BridgeList *>();
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 2, kPatienceMs);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(1, 0)).center());
    QSignalSpy samples(&window.bench->acquisition(), &Acquisition::batch);
    QTRY_VERIFY_WITH_TIMEOUT(!samples.isEmpty(), kPatienceMs);
    QVERIFY(window.train());
    QVERIFY(window.exportLine());
    window.main().showStep(Step::Export);
    auto &exports = window.page<ExportPage>(Step::Export);
    QTRY_VERIFY_WITH_TIMEOUT(exports.preview() && exports.preview()->model == "linear" &&
                                 exports.device().canWrite(),
                             kPatienceMs);
    exports.writeAction()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(exports.device().steps().state(), UploadSteps::State::Done, kPatienceMs);
    expectElsewhere({"uploadTable"});
    QVERIFY(board.users().size() >= 2); // the watch, and jobs one after the other
    QVERIFY(!board.users().contains(std::this_thread::get_id()));
}

QTEST_MAIN(TestGuiThreads)
#include "tst_gui_threads.moc"
