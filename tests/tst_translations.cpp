// The translations against the sources and against their own originals: nothing is missing, left over or
// unfinished, and what a program puts into a text or reads out of it is in the translation too.
#include "support/translation_files.h"

#include <QFileInfo>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

using namespace driftbench::test;

class TestTranslations : public QObject
{
    Q_OBJECT

private slots:
    void files_everyLanguage_isThere();
    void entries_everyOne_isFinished_data() { addLanguages(); }
    void entries_everyOne_isFinished();
    void entries_everyOne_keepsItsForm_data() { addLanguages(); }
    void entries_everyOne_keepsItsForm();
    void entries_ofTheSources_areAllThere_data() { addLanguages(); }
    void entries_ofTheSources_areAllThere();
    void check_knownOffence_isFound();

private:
    static void addLanguages();
};

namespace {

const QStringList kLanguages{"de", "en", "fr", "ja", "zh_CN"};

QStringList found(const QString &text, const QRegularExpression &pattern)
{
    QStringList parts;
    auto matches = pattern.globalMatch(text);
    while (matches.hasNext())
        parts << matches.next().captured();
    parts.sort();
    return parts;
}

QString blanksAround(const QString &text)
{
    static const QRegularExpression around(R"(^(\s*).*?(\s*)$)",
                                           QRegularExpression::DotMatchesEverythingOption);
    const auto match = around.match(text);
    return match.captured(1) + '.' + match.captured(2);
}

// What is wrong with this form of the entry; empty: nothing.
QString offence(const QString &source, const QString &form)
{
    static const QRegularExpression placeholder(R"(%L?(\d+|n))");
    static const QRegularExpression mnemonic(R"(&(?=[^&\s]))");
    static const QRegularExpression tag(R"(</?[A-Za-z][^>]*>)");
    static const QRegularExpression separator(R"([\n|])"); // lines of a table's head; keys and what they do
    static const QRegularExpression ending(R"(\*\.\w+)");  // of files
    if (form.trimmed().isEmpty())
        return "is empty";
    if (found(source, placeholder) != found(form, placeholder))
        return "has other placeholders";
    if (found(source, mnemonic).size() != found(form, mnemonic).size())
        return "has more or fewer mnemonics";
    if (found(source, tag) != found(form, tag))
        return "has other tags";
    if (found(source, separator) != found(form, separator))
        return "has other line ends or bars";
    if (found(source, ending) != found(form, ending))
        return "has other file endings";
    if (blanksAround(source) != blanksAround(form))
        return "has other blanks around it";
    if (source.endsWith(QChar(0x2026)) != form.endsWith(QChar(0x2026)))
        return "differs in the dots at its end";
    return {};
}

QString lupdate()
{
    const QString program = QDir(QLibraryInfo::path(QLibraryInfo::BinariesPath)).filePath("lupdate");
    return QFile::exists(program) ? program : QString();
}

QStringList keysOf(const std::vector<TranslationEntry> &entries)
{
    QStringList keys;
    for (const TranslationEntry &entry : entries)
        keys << entry.key();
    keys.sort();
    return keys;
}

QStringList without(QStringList all, const QStringList &some)
{
    all.removeIf([&](const QString &one) { return some.contains(one); });
    return all;
}

} // namespace

void TestTranslations::addLanguages()
{
    QTest::addColumn<QString>("language");
    for (const QString &language : kLanguages)
        QTest::newRow(qPrintable(language)) << language;
}

void TestTranslations::files_everyLanguage_isThere()
{
    QStringList files;
    for (const QString &language : kLanguages)
        files << QFileInfo(translationFile(language)).fileName();
    QCOMPARE(QDir(QFileInfo(translationFile("en")).path()).entryList({"*.ts"}, QDir::Files, QDir::Name),
             files);
}

void TestTranslations::entries_everyOne_isFinished()
{
    QFETCH(QString, language);
    const auto entries = readTranslations(translationFile(language));
    QVERIFY(!entries.empty());
    const QSet<QString> plain{"ja", "zh_CN"}; // languages without a plural form
    QStringList offences;
    for (const TranslationEntry &entry : entries) {
        if (!entry.state.isEmpty())
            offences << entry.key() + " is " + entry.state;
        const qsizetype forms = entry.plural && !plain.contains(language) ? 2 : 1;
        if (entry.forms.size() != forms)
            offences << entry.key() + QString(" has %1 forms").arg(entry.forms.size());
        if (language == "en" && !entry.plural)
            offences << entry.key() + " is no plural: the sources say it";
    }
    QVERIFY2(offences.isEmpty(), qPrintable(offences.join('\n')));
}

void TestTranslations::entries_everyOne_keepsItsForm()
{
    QFETCH(QString, language);
    const auto entries = readTranslations(translationFile(language));
    QVERIFY(!entries.empty());
    QStringList offences;
    for (const TranslationEntry &entry : entries) {
        for (const QString &form : entry.forms) {
            if (const QString why = offence(entry.source, form); !why.isEmpty())
                offences << entry.key() + ": \"" + form + "\" " + why;
        }
    }
    QVERIFY2(offences.isEmpty(), qPrintable(offences.join('\n')));
}

// As the target update_translations reads them.
void TestTranslations::entries_ofTheSources_areAllThere()
{
    QFETCH(QString, language);
    if (lupdate().isEmpty())
        QSKIP("lupdate is not installed (qt6-l10n-tools): the sources' texts are not compared.");
    QTemporaryDir folder;
    const QString copy = folder.filePath("copy.ts");
    QStringList arguments{"-silent", "-I", ".", "app", "widgets", "-locations", "none"};
    if (language == "en")
        arguments << "-pluralonly";
    QProcess process;
    process.setWorkingDirectory(sourceFolder());
    process.start(lupdate(), arguments + QStringList{"-ts", copy});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 0);
    // A text in a class that lupdate does not find would never be found by the program either.
    QCOMPARE(QString::fromUtf8(process.readAllStandardError()), QString());
    const QStringList here = keysOf(readTranslations(translationFile(language)));
    const QStringList there = keysOf(readTranslations(copy));
    QVERIFY(!there.isEmpty());
    const QString advice = "cmake --build BUILD --target update_translations, then translate:\n";
    QVERIFY2(without(there, here).isEmpty(), qPrintable(advice + without(there, here).join('\n')));
    QVERIFY2(without(here, there).isEmpty(), qPrintable("Left over:\n" + without(here, there).join('\n')));
}

void TestTranslations::check_knownOffence_isFound()
{
    QVERIFY(offence("%1 of %2", "%2 von %1").isEmpty());
    QVERIFY(offence("&File", "文件(&F)").isEmpty());
    QVERIFY(!offence("%1 of %2", "%1 von %1").isEmpty());
    QVERIFY(!offence("%n runs", "Läufe").isEmpty());
    QVERIFY(!offence("%L1 runs", "%1 Läufe").isEmpty());
    QVERIFY(!offence("&File", "Datei").isEmpty());
    QVERIFY(!offence("File", "&Datei").isEmpty());
    QVERIFY(!offence("<b>a</b>", "<i>a</i>").isEmpty());
    QVERIFY(!offence("T\n°C", "T °C").isEmpty());
    QVERIFY(!offence("PDF (*.pdf)", "PDF (*.pdff)").isEmpty());
    QVERIFY(!offence(" · opening", "· öffnet").isEmpty());
    QVERIFY(!offence("Open…", "Öffnen").isEmpty());
    QVERIFY(!offence("Open", " ").isEmpty());
}

QTEST_APPLESS_MAIN(TestTranslations)
#include "tst_translations.moc"
