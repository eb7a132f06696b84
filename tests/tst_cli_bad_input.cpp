#include "engine/base/result.h"
#include "support/cli_process.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace driftbench;
using namespace driftbench::test;

// What is wrong with input is said in one sentence with its own exit code, and nothing is left behind. The
// table's arguments are relative to a folder with good and bad inputs; "out" does not exist there.
class TestCliBadInput : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void command_badInput_isRefused_data();
    void command_badInput_isRefused();
    void inspect_recordingThatCanNotBeFitted_isShown_data();
    void inspect_recordingThatCanNotBeFitted_isShown();
    void fit_unitsGuessedApart_namesBothRuns();
    void fullDisk_leavesTheFolderAsItWas_data();
    void fullDisk_leavesTheFolderAsItWas();
    void fullStandardOutput_isAnError_data();
    void fullStandardOutput_isAnError();
    void limitOnFileSize_leavesNothing();

private:
    void makeLogs();
    void makeModels();
    Outcome run(const QStringList &arguments) const;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

namespace {

using Row = QList<QByteArray>;

// A copy of a log whose rows, numbered as the lines of the file, were changed.
void writeChanged(const QString &from, const QString &to,
                  const std::function<void(int line, Row &row)> &change)
{
    QList<QByteArray> lines = bytesOf(from).split('\n');
    lines.removeLast();
    QByteArray text;
    for (int i = 0; i < lines.size(); ++i) {
        Row row = lines[i].split(',');
        change(i + 1, row);
        text += row.join(',') + '\n';
    }
    writeBytes(to, text);
}

auto temperatures(const std::function<double(double)> &change)
{
    return [change](int line, Row &row) {
        if (line > 1)
            row[1] = QByteArray::number(change(row[1].toDouble()), 'g', 12);
    };
}

auto oneField(int line, int column, const QByteArray &text)
{
    return [=](int at, Row &row) {
        if (at == line)
            row[column] = text;
    };
}

// Everything in the folder: names, and sizes of the files.
QStringList listing(const QString &folder)
{
    QStringList list = filesIn(folder);
    for (const QString &file : filesBelow(folder))
        list.append(file + ' ' + QString::number(QFileInfo(folder + '/' + file).size()));
    return list;
}

} // namespace

Outcome TestCliBadInput::run(const QStringList &arguments) const
{
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(cliPath(), arguments);
    return finish(process);
}

void TestCliBadInput::initTestCase()
{
    QVERIFY(m_folder.isValid());
    simulateQuietly(m_folder.path(), {"--runs", "3"});
    makeLogs();
    makeModels();
}

void TestCliBadInput::makeLogs()
{
    const QString good = path("run1.csv");
    const QString second = path("run2.csv");
    const QByteArray header = bytesOf(good).left(bytesOf(good).indexOf('\n') + 1);
    writeBytes(path("empty.csv"), "");
    QByteArray garbage;
    for (int i = 0; i < 4000; ++i)
        garbage += static_cast<char>((i * 7919 + i / 13 * 31) % 251);
    writeBytes(path("garbage.bin"), garbage);
    writeBytes(path("header.csv"), header);
    writeBytes(path("one_row.csv"), header + "0,20,1,2,3\n");
    writeChanged(good, path("wrong_column.csv"), oneField(1, 1, "pressure"));
    writeChanged(good, path("text.csv"), oneField(50, 1, "hot"));
    writeChanged(good, path("nan.csv"), oneField(70, 3, "nan"));
    writeChanged(good, path("inf.csv"), oneField(70, 4, "-inf"));
    writeChanged(good, path("backwards.csv"), oneField(500, 0, "3.25"));
    writeChanged(good, path("constant.csv"), temperatures([](double) { return 25.0; }));
    writeChanged(good, path("span.csv"), temperatures([](double t) { return 25.0 + t / 125.0 * 8.0; }));
    writeChanged(good, path("hot.csv"), temperatures([](double t) { return t + 200.0; }));
    writeChanged(good, path("short.csv"), [](int line, Row &row) {
        if (line > 1)
            row[0] = QByteArray::number(row[0].toDouble() / 10.0); // 37 s in all
    });
    writeChanged(second, path("rad.csv"), [](int line, Row &row) {
        for (int column = 2; line > 1 && column < 5; ++column)
            row[column] = QByteArray::number(row[column].toDouble() / 57.29577951308232, 'g', 15);
    });
    writeBytes(path("copy.csv"), bytesOf(good));
    writeBytes(path("other_sensor.csv"), "# sensor_model: L3GD20H\n# sensor_serial: 9\n" + bytesOf(second));
    writeBytes(path("other_sidecar.csv"), bytesOf(second));
    writeBytes(path("other_sidecar.csv.meta.json"),
               R"({"sensor": {"model": "I3G4250D", "serial": "other"}})");
    QVERIFY(QDir(m_folder.path()).mkdir("folder"));
    QVERIFY(QFile::link("run1.csv", path("link.csv")));
}

void TestCliBadInput::makeModels()
{
    const Outcome fitted =
        run({"fit", "run1.csv", "run2.csv", "run3.csv", "--models", "constant,linear", "--out", "fit"});
    QCOMPARE(fitted.exitCode, 0);
    const QByteArray model = bytesOf(path("fit/models/linear.json"));
    writeBytes(path("model.json"), model);
    writeBytes(path("cut.json"), model.left(model.size() / 2));
    writeBytes(path("edited.json"), QByteArray(model).replace("\"seed\": 1", "\"seed\": 2"));
    writeBytes(path("newer.json"), QByteArray(model).replace("\"version\": 1", "\"version\": 2"));
    for (const char *changed : {"edited.json", "newer.json"})
        QVERIFY(bytesOf(path(changed)) != model);
}

void TestCliBadInput::command_badInput_isRefused_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArrayList>("says");
    constexpr int kUsage = 2;
    const auto row = [](const QString &line, int exitCode, const QByteArrayList &says) {
        QTest::newRow(qPrintable(line)) << line.split(' ') << exitCode << says;
    };
    const auto refused = [&row](const QString &line, Errc code, const QByteArrayList &says) {
        row(line, static_cast<int>(code), says);
    };

    // Logs, for every command that reads them.
    for (const QString &command :
         {QString("inspect %1"), QString("fit run2.csv %1 --out out"),
          QString("evaluate --model model.json %1"), QString("apply --model model.json %1 out")}) {
        const auto log = [&](const QString &file, Errc code, const QByteArrayList &says) {
            refused(command.arg(file), code, QByteArrayList{file.toUtf8()} + says);
        };
        log("missing.csv", Errc::FileNotFound, {"is not there"});
        log("folder", Errc::FileUnreadable, {"can't be read"});
        log("run1.csv/below", Errc::FileNotFound, {"is not there"});
        log("empty.csv", Errc::FileEmpty, {"is empty"});
        log("garbage.bin", Errc::UnknownFormat, {"neither a table in text"});
        log("model.json", Errc::MissingColumn, {"no column", "time"});
        log("header.csv", Errc::TooFewSamples, {"no samples"});
        log("wrong_column.csv", Errc::MissingColumn, {"temperature", "pressure"});
        log("text.csv", Errc::NotANumber, {"line 50", "temperature_C", "\"hot\""});
    }

    // Recordings that can't be calibrated.
    const auto recording = [&](const QString &files, Errc code, const QByteArrayList &says) {
        refused("fit " + files + " --out out", code, says);
        refused("evaluate --model model.json " + files, code, says);
    };
    recording("run2.csv one_row.csv", Errc::TooFewSamples, {"one_row.csv", "1 sample"});
    recording("run2.csv short.csv", Errc::TooShort, {"short.csv", "at least 60 s"});
    recording("run2.csv constant.csv", Errc::ConstantTemperature, {"constant.csv", "25.0 °C"});
    recording("span.csv", Errc::SpanTooSmall, {"span.csv", "at least 10 °C"});
    recording("backwards.csv", Errc::TimeBackwards, {"backwards.csv", "3.250 s"});
    recording("nan.csv", Errc::NonFiniteValue, {"nan.csv", "sample 69", "rate of y"});
    recording("inf.csv", Errc::NonFiniteValue, {"inf.csv", "sample 69", "rate of z"});
    recording("run1.csv run2.csv rad.csv", Errc::UnitsDiffer, {"rad.csv", "57.3", "rad/s"});
    recording("run1.csv other_sensor.csv", Errc::DifferentSensors, {"L3GD20H 9", "other_sensor.csv"});
    recording("run1.csv other_sidecar.csv", Errc::DifferentSensors, {"other_sidecar.csv", "I3G4250D other"});
    recording("run1.csv run2.csv copy.csv", Errc::SameRecordingTwice, {"run1.csv", "copy.csv"});
    recording("run1.csv ./folder/../run1.csv", Errc::SameRecordingTwice, {"./folder/../run1.csv"});
    recording("run1.csv link.csv", Errc::SameRecordingTwice, {"link.csv"});
    recording("run1.csv --sensor A:B", Errc::DifferentSensors, {"run1.csv", "A B", "--sensor"});
    recording("run1.csv --exclude 0:1e9", Errc::NothingUsable, {"run1.csv"});

    // Models.
    for (const QString &command :
         {QString("apply --model %1 run1.csv out"), QString("evaluate --model %1 run1.csv"),
          QString("export --model %1 --format csv --out out")}) {
        refused(command.arg("missing.json"), Errc::FileNotFound, {"missing.json"});
        refused(command.arg("folder"), Errc::FileUnreadable, {"folder"});
        refused(command.arg("empty.csv"), Errc::ModelDamaged, {"empty"});
        refused(command.arg("run1.csv"), Errc::ModelDamaged, {"run1.csv", "not JSON"});
        refused(command.arg("fit/comparison.json"), Errc::ModelDamaged, {"comparison.json"});
        refused(command.arg("cut.json"), Errc::ModelDamaged, {"cut.json", "cut off"});
        refused(command.arg("edited.json"), Errc::ModelEdited, {"edited.json", "checksum"});
        refused(command.arg("newer.json"), Errc::ModelTooNew, {"newer.json"});
    }
    for (const QString &log : {QString("other_sensor.csv"), QString("other_sidecar.csv")}) {
        refused("apply --model model.json " + log + " out", Errc::ModelOfAnotherSensor,
                {"I3G4250D SIM-0001", log.toUtf8(), "--force"});
        refused("evaluate --model model.json " + log, Errc::ModelOfAnotherSensor, {"I3G4250D SIM-0001"});
    }
    refused("apply --model model.json copy.csv out --sensor A:B", Errc::ModelOfAnotherSensor, {"A B"});
    refused("apply --model model.json run1.csv out --sensor A:B", Errc::DifferentSensors, {"--sensor"});
    refused("apply --model model.json hot.csv out", Errc::OutsideTrainedRange,
            {"hot.csv", "160.0 to 284.", "wholly outside", "--force"});
    refused("evaluate --model model.json hot.csv", Errc::OutsideTrainedRange, {"hot.csv", "wholly outside"});

    // Where the result goes.
    for (const QString &command :
         {QString("fit run1.csv run2.csv --models linear --out %1"),
          QString("simulate --profile quick --out %1"), QString("apply --model model.json run1.csv %1"),
          QString("export --model model.json --force --format json --out %1")})
        refused(command.arg("empty.csv/out"), Errc::OutputNotWritable, {"empty.csv/out", "can't be written"});
    refused("fit run1.csv run2.csv --models linear --out run3.csv", Errc::OutputNotWritable, {"run3.csv"});
    refused("apply --model model.json run1.csv folder", Errc::OutputNotWritable, {"folder"});
    refused("apply --model model.json run1.csv missing/out.csv", Errc::OutputNotWritable,
            {"missing/out.csv"});
    refused("export --model model.json --force --format c --out folder", Errc::OutputNotWritable, {"folder"});
    refused("apply --model model.json run1.csv run1.csv", Errc::InvalidOption, {"run1.csv", "another name"});
    refused("apply --model model.json run1.csv link.csv", Errc::InvalidOption, {"run1.csv", "another name"});
    refused("apply --model model.json run1.csv model.json", Errc::InvalidOption, {"model.json"});

    // Options of fit.
    const QString fit = "fit run1.csv run2.csv --out out ";
    refused(fit + "--models linear,magic", Errc::InvalidOption, {"'magic'", "rbf-paper"});
    refused(fit + "--models linear,rbf,linear", Errc::InvalidOption, {"'linear'", "more than once"});
    refused(fit + "--models auto", Errc::InvalidOption, {"'auto'"});
    row(fit + "--models ,", kUsage, {"--models"});
    refused(fit + "--hold-out run9", Errc::InvalidOption, {"run9", "run1, run2"});
    refused(fit + "--hold-out run1 --hold-out run2", Errc::InvalidOption, {"All runs are held out"});
    row(fit + "--judge harshly", kUsage, {"\"harshly\"", "anchored"});
    row(fit + "--reference-rate 1,2", kUsage, {"three numbers"});
    row(fit + "--reference-temperature nan", kUsage, {"--reference-temperature"});
    row(fit + "--reference-temperature warm", kUsage, {"\"warm\""});
    row(fit + "--exclude 5", kUsage, {"--exclude", "120:180.5"});
    row(fit + "--exclude 9:5", kUsage, {"--exclude"});
    row(fit + "--seed many", kUsage, {"--seed"});
    row("fit --out out", kUsage, {"RUN"});
    refused("fit run1.csv", Errc::InvalidOption, {"--out"});

    // Options about logs.
    row("inspect run1.csv --columns 1,2", kUsage, {"--columns", "TIME,TEMPERATURE,X,Y,Z"});
    refused("inspect run1.csv --columns 1,2,3,4,9", Errc::MissingColumn, {"\"9\"", "gyro_z_dps"});
    refused("inspect run1.csv --columns t,T,x,y,z", Errc::MissingColumn, {"\"t\"", "time_s"});
    row("inspect run1.csv --separator x", kUsage, {"--separator", "tab"});
    row("inspect run1.csv --time-unit h", kUsage, {"--time-unit", "ms"});
    row("inspect run1.csv --rate-unit rpm", kUsage, {"--rate-unit", "rad/s"});
    row("inspect run1.csv --temperature-unit R", kUsage, {"--temperature-unit", "K"});
    refused("inspect run1.csv --rate-unit counts", Errc::InvalidOption, {"sensitivity"});
    refused("inspect run1.csv --instance 3", Errc::NoSuchInstance, {"--instance"});
    row("inspect run1.csv --instance x", kUsage, {"--instance"});

    // Options of export.
    const QString exported = "export --model model.json --force --out out --format ";
    refused(exported + "xml", Errc::InvalidOption, {"\"xml\"", "ardupilot"});
    refused(exported + "c --axes w", Errc::InvalidOption, {"--axes", "\"w\""});
    refused(exported + "c --axes ,", Errc::InvalidOption, {"No axis"});
    refused(exported + "c --symbol 9a", Errc::InvalidOption, {"\"9a\""});
    refused(exported + "csv --bound 0", Errc::InvalidOption, {"above 0"});
    refused(exported + "csv --bound nan", Errc::InvalidOption, {"above 0"});
    refused(exported + "px4", Errc::InvalidOption, {"--device-id"});
    refused(exported + "px4 --device-id 7 --gyro 4", Errc::InvalidOption, {"0 to 3"});
    refused(exported + "ardupilot --gyro 0", Errc::InvalidOption, {"1 to 3"});
}

void TestCliBadInput::command_badInput_isRefused()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QByteArrayList, says);
    const QStringList before = listing(m_folder.path());
    const Outcome outcome = run(arguments);
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QVERIFY2(outcome.exitCode == exitCode, outcome.errors.constData());
    for (const QByteArray &part : says)
        QVERIFY2(outcome.errors.contains(part), outcome.errors.constData());
    QCOMPARE(outcome.output, QByteArray());
    QCOMPARE(listing(m_folder.path()), before);
}

void TestCliBadInput::inspect_recordingThatCanNotBeFitted_isShown_data()
{
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("one_row.csv") << QByteArray("1 sample");
    QTest::newRow("constant.csv") << QByteArray("stays at 25.0 °C");
    QTest::newRow("span.csv") << QByteArray("only 8.0 °C");
    QTest::newRow("backwards.csv") << QByteArray("goes backwards");
    QTest::newRow("nan.csv") << QByteArray("rate of y");
    QTest::newRow("short.csv") << QByteArray("at least 60 s");
}

void TestCliBadInput::inspect_recordingThatCanNotBeFitted_isShown()
{
    QFETCH(QByteArray, says);
    const Outcome outcome = run({"inspect", QTest::currentDataTag()});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.errors, QByteArray());
    QVERIFY(outcome.output.contains("refusal") && outcome.output.contains(says));
    QVERIFY(outcome.output.endsWith("verdict      can't be calibrated\n"));
    const QByteArray figures =
        outcome.output.left(outcome.output.indexOf("\nrefusal")).replace("nan.csv", "");
    QVERIFY2(!figures.contains("nan") && !figures.contains("inf"), figures.constData());
}

void TestCliBadInput::fit_unitsGuessedApart_namesBothRuns()
{
    const Outcome outcome = run({"fit", "run1.csv", "rad.csv", "--out", "out"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::UnitsDiffer));
    // Told the truth about both, they go together.
    writeChanged(path("rad.csv"), path("rad_named.csv"), [](int line, Row &row) {
        for (int column = 2; line == 1 && column < 5; ++column)
            row[column].replace("_dps", "_rad_s");
    });
    const Outcome named = run({"fit", "run1.csv", "rad_named.csv", "--models", "linear", "--out", "named"});
    QVERIFY2(named.exitCode == 0, named.errors.constData());
}

void TestCliBadInput::fullDisk_leavesTheFolderAsItWas_data()
{
    QTest::addColumn<QString>("size");
    QTest::addColumn<QString>("command");
    QTest::newRow("fit") << "40k"
                         << "fit run1.csv run2.csv run3.csv --models constant,linear --out \"$1\"";
    QTest::newRow("fit, below") << "40k"
                                << "fit run1.csv run2.csv run3.csv --models constant,linear --out \"$1\"/new";
    QTest::newRow("apply") << "64k"
                           << "apply --model model.json run1.csv \"$1\"/compensated.csv";
    QTest::newRow("export") << "4k"
                            << "export --model model.json --force --format c --out \"$1\"/table.h";
}

void TestCliBadInput::fullDisk_leavesTheFolderAsItWas()
{
    QFETCH(QString, size);
    QFETCH(QString, command);
    QTemporaryDir disk;
    const auto outcome = runOnSmallDisk(disk.path(), size,
                                        "echo before > \"$1/comparison.json\" && cd " + m_folder.path() +
                                            " && \"$2\" " + command +
                                            "; echo \"exit $?\"; ls -AR \"$1\" | tail -n +2; "
                                            "cat \"$1/comparison.json\"");
    if (!outcome)
        QSKIP("this machine does not let a test mount a small file system");
    QCOMPARE(outcome->output, QByteArray("exit 31\ncomparison.json\nbefore\n"));
    QVERIFY(outcome->errors.contains("no room is left on its disk"));
}

void TestCliBadInput::fullStandardOutput_isAnError_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("inspect") << QStringList{"inspect", "run1.csv"};
    QTest::newRow("inspect --json") << QStringList{"inspect", "run1.csv", "--json"};
    QTest::newRow("evaluate") << QStringList{"evaluate", "--model", "fit/held-out/run1/linear.json",
                                             "run1.csv"};
}

void TestCliBadInput::fullStandardOutput_isAnError()
{
    QFETCH(QStringList, arguments);
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.setStandardOutputFile("/dev/full");
    process.start(cliPath(), arguments);
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::OutputFull));
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
}

void TestCliBadInput::limitOnFileSize_leavesNothing()
{
    const QStringList before = listing(m_folder.path());
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start("sh",
                  {"-c", "ulimit -f 8; exec \"$1\" apply --model model.json run1.csv out", "sh", cliPath()});
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::OutputNotWritable));
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QCOMPARE(listing(m_folder.path()), before);
}

QTEST_GUILESS_MAIN(TestCliBadInput)
#include "tst_cli_bad_input.moc"
