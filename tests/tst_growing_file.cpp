// The file that grows: what was appended is there for others at once, and never is another file replaced
// unasked.
#include "engine/base/growing_file.h"
#include "support/test_data.h"

#include <QFile>
#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestGrowingFile : public QObject
{
    Q_OBJECT

private slots:
    void append_bytes_areThereAtOnce();
    void create_existing_isReplacedOnlyIfAsked();
    void create_noFolder_isNotWritable();
    void append_fullDisk_isSaid();
};

namespace {

QByteArray bytesIn(const std::filesystem::path &path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("can't be read");
}

} // namespace

void TestGrowingFile::append_bytes_areThereAtOnce()
{
    const auto path = scratchFolder() / "grows.txt";
    auto file = GrowingFile::create(path, false);
    QVERIFY(file.ok());
    QByteArray expected;
    for (int i = 0; i < 200; ++i) {
        const std::string line = "line " + std::to_string(i) + '\n';
        QVERIFY(file->append(line).ok());
        expected += line.c_str();
        QCOMPARE(bytesIn(path), expected);
    }
    QVERIFY(file->sync().ok());
    const GrowingFile moved(*std::move(file));
    QVERIFY(moved.sync().ok());
}

void TestGrowingFile::create_existing_isReplacedOnlyIfAsked()
{
    const auto path = scratchFolder() / "there.txt";
    QVERIFY(GrowingFile::create(path, false)->append("old").ok());
    const auto refused = GrowingFile::create(path, false);
    QCOMPARE(refused.error().code, Errc::OutputNotWritable);
    QVERIFY(refused.error().message.find("there already") != std::string::npos);
    QCOMPARE(bytesIn(path), QByteArray("old"));
    QVERIFY(GrowingFile::create(path, true).ok());
    QCOMPARE(bytesIn(path), QByteArray());
}

void TestGrowingFile::create_noFolder_isNotWritable()
{
    QCOMPARE(GrowingFile::create("/no/such/folder/x", true).error().code, Errc::OutputNotWritable);
}

void TestGrowingFile::append_fullDisk_isSaid()
{
    auto full = GrowingFile::create("/dev/full", true);
    if (!full)
        QSKIP("there is no /dev/full");
    QCOMPARE(full->append("x").error().code, Errc::OutputFull);
}

QTEST_APPLESS_MAIN(TestGrowingFile)
#include "tst_growing_file.moc"
