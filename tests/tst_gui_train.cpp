// The page Train with real trainings.
#include "app/gui/pages/train_page.h"
#include "app/gui/train/train_options.h"
#include "engine/physics/temperature_profile.h"
#include "support/gui_bench.h"
#include "widgets/controls/banner_slot.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/tables/data_table.h"
#include "widgets/tables/models_table_model.h"
#include "widgets/views/centres_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiTrain : public QObject
{
    Q_OBJECT

private slots:
    void page_withoutRuns_saysWhatToDo();
    void page_trained_showsTheEnginesFigures();
    void options_edited_areStepsThatCanBeUndone();
    void centres_picked_areTakenAndTrained();
    void training_cancelled_keepsFinishedModels();
    void training_refused_saysWhyInPlace();
    void training_running_neverHoldsUpTheWindow();
};

static const std::vector<std::string> kFast{"constant", "linear", "cubic", "rbf"};

static QAction *action(const Page &page, const QKeySequence &keys)
{
    for (QAction *each : page.pageActions()) {
        if (each->shortcut() == keys)
            return each;
    }
    qFatal("no such action");
}

void TestGuiTrain::page_withoutRuns_saysWhatToDo()
{
    GuiBench bench(0);
    TrainPage page(*bench.context);
    showPage(page);
    QVERIFY(!action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->isEnabled());
    QVERIFY(!page.stepState().holds);
    QVERIFY(page.losses().isEmpty());
    QCOMPARE(page.origin(), Origin::None);
}

void TestGuiTrain::page_trained_showsTheEnginesFigures()
{
    GuiBench bench(3);
    bench.setModels(kFast);
    TrainPage page(*bench.context);
    showPage(page);
    action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->trigger();
    QVERIFY(bench.workbench->training().isRunning());
    QCOMPARE(page.stepState().mark, StepMark::Working);
    QVERIFY(QTest::qWaitFor([&] { return bench.session().result() != nullptr; }, kTrainingPatienceMs));
    QTRY_VERIFY(!bench.workbench->training().isRunning());
    QCOMPARE(page.origin(), Origin::Simulated);
    QCOMPARE(page.stepState().mark, StepMark::Done);
    QVERIFY(!page.losses().isEmpty() && !page.curves().isEmpty());
    const CalibrationResult &result = *bench.session().result();
    const auto &lines = page.models().shown().models;
    QCOMPARE(lines.size(), kFast.size());
    QCOMPARE(lines.front().name, std::string("rbf"));
    for (const ModelLine &line : lines) {
        QCOMPARE(line.state, ModelLine::State::Finished);
        QVERIFY(std::isfinite(line.timeS) && line.parameters > 0);
        double msd = 0.0;
        int runs = 0;
        for (const ComparisonRow &row : result.figures.rows) {
            if (row.model == line.name && row.axis == 1) {
                msd += row.msdAfter;
                ++runs;
            }
        }
        QCOMPARE(runs, 3);
        QVERIFY(std::abs(line.msd[1] - msd / 3.0) < 1e-12);
    }
    QVERIFY(page.models().rowCount() == 5); // the floor is the last
    QVERIFY(page.table().heightOfRows(5) > 0);
}

void TestGuiTrain::options_edited_areStepsThatCanBeUndone()
{
    GuiBench bench(2);
    bench.setModels(kFast);
    TrainPage page(*bench.context);
    showPage(page);
    const CalibrationPlan before = bench.session().plan();
    QCheckBox *quadratic = nullptr, *line = nullptr;
    for (QCheckBox *box : page.options().findChildren<QCheckBox *>()) {
        if (box->text() == QStringLiteral("ΔT²"))
            quadratic = box;
        if (box->text() == QStringLiteral("Line in ΔT"))
            line = box;
    }
    QVERIFY(quadratic != nullptr && line != nullptr);
    quadratic->click();
    QCOMPARE(bench.session().plan().rbf.inputs[1], false);
    line->click();
    QCOMPARE(bench.session().plan().models, (std::vector<std::string>{"constant", "cubic", "rbf"}));
    auto *preset = page.options().findChild<SegmentedButtons *>();
    preset->button(1)->click();
    QCOMPARE(bench.session().plan().models, (std::vector<std::string>{"constant", "cubic", "rbf-paper"}));
    for (int i = 0; i < 3; ++i)
        QVERIFY(bench.session().undo().ok());
    QVERIFY(bench.session().plan() == before);
    QVERIFY(quadratic->isChecked() && line->isChecked());
    QCOMPARE(preset->current(), 0);
}

void TestGuiTrain::centres_picked_areTakenAndTrained()
{
    GuiBench bench(2);
    bench.setModels({"constant", "rbf"});
    TrainPage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    emit page.losses().countPicked(3);
    QCOMPARE(bench.session().plan().rbf.centres, 3);
    QVERIFY(page.isOutdated());
    QVERIFY(QTest::qWaitFor([&] { return bench.session().result() != nullptr; }, kTrainingPatienceMs));
    const auto *network = std::get_if<RbfNetwork>(&bench.session().result()->model("rbf")->model);
    QVERIFY(network != nullptr);
    QCOMPARE(network->centreCount, (std::array<int, 3>{3, 3, 3}));
    QVERIFY(!page.isOutdated());
}

void TestGuiTrain::training_cancelled_keepsFinishedModels()
{
    GuiBench bench(3);
    bench.setModels({"constant", "linear", "bpnn"});
    TrainPage page(*bench.context);
    showPage(page);
    QSignalSpy trained(&bench.workbench->training(), &TrainingJob::modelTrained);
    action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->trigger();
    QVERIFY(QTest::qWaitFor([&] { return trained.size() >= 2; }, kTrainingPatienceMs));
    action(page, QKeySequence(Qt::Key_Escape))->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !bench.workbench->training().isRunning(); }, kTrainingPatienceMs));
    QTRY_VERIFY(bench.session().result() != nullptr);
    const auto &lines = page.models().shown().models;
    QCOMPARE(lines.front().name, std::string("bpnn"));
    QCOMPARE(lines.front().state, ModelLine::State::Stopped);
    QVERIFY(!lines.front().note.isEmpty());
    QCOMPARE(lines.back().state, ModelLine::State::Finished);
    QVERIFY(action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->isEnabled());
}

// A temperature that does not move.
static Recording stillRun()
{
    Recording recording = shortRun(0);
    recording.temperatureC.setConstant(25.0);
    return recording;
}

void TestGuiTrain::training_refused_saysWhyInPlace()
{
    GuiBench bench(0);
    {
        auto file = bench.session().anotherFile();
        QVERIFY(file.ok());
        const Recording recording = stillRun();
        QVERIFY((*file)->importRun(recording, describeRecording(recording.info, "still")).ok());
        QVERIFY(bench.session().refreshRuns().ok());
    }
    TrainPage page(*bench.context);
    showPage(page);
    action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !bench.workbench->training().isRunning(); }, kTrainingPatienceMs));
    QTRY_VERIFY(page.banners().holds(QStringLiteral("refused")));
    QVERIFY(bench.session().prepared() && bench.session().prepared()->refusal);
    QCOMPARE(page.banners().banner().content().toDo,
             QString::fromStdString(bench.session().prepared()->refusal->message));
    QVERIFY(bench.session().result() == nullptr);
}

// Not a timing assertion of a machine: the event loop must get its turn again and again while models are
// trained.
void TestGuiTrain::training_running_neverHoldsUpTheWindow()
{
    GuiBench bench(3);
    bench.setModels({"constant", "bpnn"});
    TrainPage page(*bench.context);
    showPage(page);
    int turns = 0;
    QTimer heart;
    heart.setInterval(5);
    connect(&heart, &QTimer::timeout, this, [&turns] { ++turns; });
    heart.start();
    QElapsedTimer clock;
    clock.start();
    action(page, QKeySequence(Qt::CTRL | Qt::Key_R))->trigger();
    QVERIFY(clock.elapsed() < 2000); // starting is no training
    QVERIFY(QTest::qWaitFor([&] { return !bench.workbench->training().isRunning(); }, kTrainingPatienceMs));
    QVERIFY2(turns > 1, qPrintable(QString::number(turns)));
}

QTEST_MAIN(TestGuiTrain)
#include "tst_gui_train.moc"
