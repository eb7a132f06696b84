// The window in every language: switched while it runs it says everything anew, and looks as if it had been
// started in that language; nothing is cut off at the smallest size; numbers are written as there.
#include "support/gui_bench.h"
#include "support/gui_window.h"
#include "support/translation_files.h"

#include "app/gui/pages/compare_page.h"
#include "app/gui/start/start_page.h"
#include "app/gui/status_line.h"
#include "app/gui/step_rail.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/judged_run_view.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>

#include <functional>
#include <map>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiLanguage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase() { m_window.reset(); }
    void language_available_isWhatIsTranslated();
    void language_switched_reachesEveryText_data() { addLanguages(); }
    void language_switched_reachesEveryText();
    void language_switched_looksAsStartedInIt();
    void menus_mnemonics_areUnique_data() { addLanguages(); }
    void menus_mnemonics_areUnique();
    void banner_switched_saysItAgain();

private:
    static void addLanguages();
    void openIn(GuiWindow &window) const;
    void switchTo(const QString &language) const;

    QTemporaryDir m_folder;
    std::filesystem::path m_session;     // with runs and trained models
    std::unique_ptr<GuiWindow> m_window; // with the session, each page shown once
};

namespace {

constexpr QSize kSmallest(1280, 720);

Settings settingsIn(const QString &language)
{
    Settings settings;
    settings.language = language;
    return settings;
}

// A text of the sources as a pattern: anything may stand at its numbered places.
QRegularExpression patternOf(const QString &source)
{
    static const QRegularExpression placeholder(R"(%L?(\d+|n))");
    QStringList parts = source.split(placeholder);
    for (QString &part : parts)
        part = QRegularExpression::escape(part);
    return QRegularExpression(QRegularExpression::anchoredPattern(parts.join(".+")),
                              QRegularExpression::DotMatchesEverythingOption);
}

QString plain(QString text)
{
    static const QRegularExpression tag("<[^>]*>");
    return text.remove(tag).remove('&').trimmed();
}

// Whether a text is one of the sources that have another translation, and no translation itself.
class English
{
public:
    explicit English(const QString &language)
    {
        for (const TranslationEntry &entry : readTranslations(translationFile(language))) {
            for (const QString &form : entry.forms)
                add(plain(form), m_translations, m_translationPatterns);
            if (!entry.forms.contains(entry.source))
                add(plain(entry.source), m_sources, m_sourcePatterns);
        }
    }

    bool isLeftIn(const QString &text)
    {
        const QString shown = plain(text);
        if (m_seen.contains(shown))
            return false;
        m_seen.insert(shown);
        return matches(shown, m_sources, m_sourcePatterns) &&
               !matches(shown, m_translations, m_translationPatterns);
    }

private:
    using Patterns = std::vector<QRegularExpression>;

    // What is hardly more than its numbers ("%1 Hz") tells nothing.
    static void add(const QString &text, QSet<QString> &whole, Patterns &patterns)
    {
        static const QRegularExpression placeholder(R"(%L?(\d+|n))");
        static const QRegularExpression words(R"(\p{L}{4}|[\x{3040}-\x{9fff}])");
        if (!text.contains(placeholder))
            whole.insert(text);
        else if (text.contains(words))
            patterns.push_back(patternOf(text));
    }

    static bool matches(const QString &text, const QSet<QString> &whole, const Patterns &patterns)
    {
        return whole.contains(text) ||
               std::any_of(patterns.begin(), patterns.end(),
                           [&](const auto &pattern) { return pattern.match(text).hasMatch(); });
    }

    QSet<QString> m_sources, m_translations, m_seen;
    Patterns m_sourcePatterns, m_translationPatterns;
};

QStringList textsOf(const QAbstractItemView &view)
{
    QStringList texts;
    const QAbstractItemModel *model = view.model();
    for (int column = 0; model && column < model->columnCount(); ++column) {
        texts << model->headerData(column, Qt::Horizontal).toString();
        for (int row = 0; row < std::min(model->rowCount(), 50); ++row)
            texts << model->index(row, column).data().toString()
                  << model->index(row, column).data(Qt::ToolTipRole).toString()
                  << model->index(row, column).data(Qt::AccessibleTextRole).toString();
    }
    return texts;
}

QStringList textsOf(const QWidget &widget)
{
    QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription(),
                      widget.windowTitle()};
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        texts << label->text();
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        texts << button->text();
    if (const auto *box = qobject_cast<const QGroupBox *>(&widget))
        texts << box->title();
    if (const auto *line = qobject_cast<const QLineEdit *>(&widget))
        texts << line->placeholderText() << line->text();
    if (const auto *combo = qobject_cast<const QComboBox *>(&widget)) {
        for (int i = 0; i < combo->count(); ++i)
            texts << combo->itemText(i);
    }
    if (const auto *view = qobject_cast<const QAbstractItemView *>(&widget))
        texts << textsOf(*view);
    if (const auto *plot = qobject_cast<const PlotView *>(&widget)) {
        for (const LegendEntry &entry : plot->legend())
            texts << entry.text;
    }
    return texts;
}

// The heads of tables whose column is narrower than they are.
QStringList cutHeads(const QWidget &window)
{
    QStringList cut;
    for (const QTableView *table : window.findChildren<QTableView *>()) {
        const QHeaderView *heads = table->horizontalHeader();
        const QFontMetrics metrics(heads->font());
        for (int column = 0; table->isVisible() && column < heads->count(); ++column) {
            const QString head = table->model()->headerData(column, Qt::Horizontal).toString();
            for (const QString &line : head.split('\n')) {
                const int room = heads->sectionSize(column);
                if (!heads->isSectionHidden(column) && metrics.horizontalAdvance(line) > room)
                    cut << QString("\"%1\" has %2, needs %3")
                               .arg(line)
                               .arg(room)
                               .arg(metrics.horizontalAdvance(line));
            }
        }
    }
    return cut;
}

// Each page that there is, the start page first.
void walkPages(GuiWindow &window, const std::function<void(const QString &name)> &look)
{
    window.main().showStart();
    QCoreApplication::processEvents();
    look("Start");
    for (const Step step : kSteps) {
        window.main().showStep(step);
        // What a page computes when it is shown comes by and by.
        if (!QTest::qWaitFor([&] { return !window.bench->training().isRunning(); }, kTrainingPatienceMs))
            qFatal("the training does not end");
        QTest::qWait(150);
        look(QString::number(static_cast<int>(step) + 1));
    }
}

// The labels and buttons whose text has less room than it needs, those that are cut on purpose aside.
QStringList cutOff(const QWidget &window)
{
    QStringList cut;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisible())
            continue;
        const auto *label = qobject_cast<const QLabel *>(widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const QString text = label ? label->text() : button ? button->text() : QString();
        if (text.isEmpty() ||
            (label && label->minimumSizeHint().width() < label->sizeHint().width() / 2 && !label->wordWrap()))
            continue; // elided: shown whole as a tooltip
        const bool wraps = label && label->wordWrap();
        const QSize needed = widget->sizeHint();
        const bool fits = wraps ? widget->height() >= label->heightForWidth(widget->width())
                                : widget->width() >= needed.width();
        if (!fits)
            cut << QString("\"%1\" has %2 x %3, needs %4 x %5")
                       .arg(text)
                       .arg(widget->width())
                       .arg(widget->height())
                       .arg(wraps ? widget->width() : needed.width())
                       .arg(wraps ? label->heightForWidth(widget->width()) : needed.height());
    }
    return cut;
}

} // namespace

void TestGuiLanguage::addLanguages()
{
    QTest::addColumn<QString>("language");
    for (const QString &language : Language::available())
        QTest::newRow(qPrintable(language)) << language;
}

void TestGuiLanguage::initTestCase()
{
    {
        GuiBench bench(2);
        bench.setModels({"constant", "linear", "rbf"});
        bench.workbench->setSourceChoice(SourceChoice{SimulatedChoice{}});
        QVERIFY(bench.workbench->useSource());
        QVERIFY(bench.train());
        m_session = m_folder.filePath("trained.driftbench").toStdString();
        QVERIFY(bench.workbench->saveSessionAs(m_session));
    }
    m_window = std::make_unique<GuiWindow>();
    openIn(*m_window);
}

void TestGuiLanguage::openIn(GuiWindow &window) const
{
    window.main().resize(kSmallest);
    QVERIFY(window.bench->openSession(m_session));
    walkPages(window, [](const QString &) {});
}

void TestGuiLanguage::switchTo(const QString &language) const
{
    m_window->language.set(language);
    QCoreApplication::processEvents();
}

void TestGuiLanguage::language_available_isWhatIsTranslated()
{
    QStringList languages = Language::available();
    languages.sort();
    QCOMPARE(languages, (QStringList{"de", "en", "fr", "ja", "zh_CN"}));
    QCOMPARE(Language::nativeName("de"), QStringLiteral("Deutsch"));
}

// None stays English, none is cut off, all numbers are written as in that language.
void TestGuiLanguage::language_switched_reachesEveryText()
{
    QFETCH(QString, language);
    static const QRegularExpression point(R"(^[^\p{L}]*\d\.\d+\s?(dps|°C|s|Hz|%)?$)");
    static const QRegularExpression comma(R"(^[^\p{L}]*\d,\d+\s?(dps|°C|s|Hz|%)?$)");
    const bool commas = QLocale(language).decimalPoint() == QLatin1String(",");
    English english(language);
    switchTo("en");
    switchTo(language);
    QStringList wrong;
    int numbers = 0;
    const auto look = [&](const QString &place, const QStringList &texts) {
        for (const QString &text : texts) {
            if (english.isLeftIn(text))
                wrong << place + ", English: " + text;
            if (text.contains(commas ? point : comma))
                wrong << place + ", number: " + text;
            numbers += text.contains(commas ? comma : point) ? 1 : 0;
        }
    };
    walkPages(*m_window, [&](const QString &page) {
        for (const QWidget *widget : m_window->main().findChildren<QWidget *>()) {
            if (widget->isVisible())
                look(page, textsOf(*widget));
        }
        look(page, m_window->main().statusLine().parts());
        for (const QString &text : cutOff(m_window->main()) + cutHeads(m_window->main()))
            wrong << page + ", cut off: " + text;
    });
    for (const QAction *action : m_window->main().findChildren<QAction *>())
        look("action", {action->text(), action->toolTip(), action->iconText()});
    look("window", {m_window->main().windowTitle(), m_window->main().sessionText()});
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    QVERIFY(numbers > 20);
}

// Whatever is drawn and not a widget's text, numbers and titles of axes for one, is in the picture. On the
// pages that show nothing live.
void TestGuiLanguage::language_switched_looksAsStartedInIt()
{
    QApplication::setCursorFlashTime(0);
    const auto picture = [](GuiWindow &window, Step step) {
        window.main().showStep(step);
        const auto &compare = static_cast<ComparePage &>(*window.main().page(Step::Compare));
        if (step == Step::Compare &&
            !QTest::qWaitFor([&] { return !compare.plots().isEmpty(); }, kTrainingPatienceMs))
            qFatal("the page has no plots");
        QTest::qWait(150);
        return window.main().page(step)->grab().toImage();
    };
    std::map<Step, QImage> switched;
    switchTo("en");
    switchTo("de");
    for (const Step step : {Step::Plan, Step::Compare})
        switched[step] = picture(*m_window, step);
    m_window.reset();
    {
        GuiWindow window(settingsIn("de"));
        openIn(window);
        for (const auto &[step, seen] : switched)
            QVERIFY2(picture(window, step) == seen, qPrintable(QString("page %1").arg(int(step) + 1)));
    }
    m_window = std::make_unique<GuiWindow>();
}

void TestGuiLanguage::menus_mnemonics_areUnique()
{
    QFETCH(QString, language);
    static const QRegularExpression mnemonic("&([^&\\s])");
    switchTo(language);
    QList<QWidget *> menus{m_window->main().menuBar()};
    for (QMenu *menu : m_window->main().findChildren<QMenu *>())
        menus << menu;
    for (const QWidget *menu : menus) {
        QSet<QString> taken;
        for (const QAction *action : menu->actions()) {
            const QString letter = mnemonic.match(action->text()).captured(1).toLower();
            QVERIFY2(letter.isEmpty() || !taken.contains(letter), qPrintable(action->text()));
            taken.insert(letter);
        }
    }
    QVERIFY(menus.size() > 5);
}

void TestGuiLanguage::banner_switched_saysItAgain()
{
    switchTo("en");
    m_window->main().showStep(Step::Compare);
    auto &compare = static_cast<ComparePage &>(*m_window->main().page(Step::Compare));
    compare.writeReport(m_folder.filePath("none.pdf").toStdString());
    const QString english = compare.banners().banner().content().what;
    QVERIFY(!english.isEmpty());
    switchTo("de");
    QVERIFY(compare.banners().banner().content().what != english);
    switchTo("en");
    QCOMPARE(compare.banners().banner().content().what, english);
}

QTEST_MAIN(TestGuiLanguage)
#include "tst_gui_language.moc"
