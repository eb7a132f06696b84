#include "app/language/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

namespace driftbench {

static const QString kFolder = QStringLiteral(":/i18n");
static const QString kStem = QStringLiteral("driftbench_");

QStringList Language::available()
{
    QStringList codes{QStringLiteral("en")};
    for (const QString &file : QDir(kFolder).entryList({kStem + QStringLiteral("*.qm")})) {
        const QString code = file.mid(kStem.size(), file.size() - kStem.size() - 3);
        if (!codes.contains(code))
            codes << code;
    }
    return codes;
}

QString Language::nativeName(const QString &code)
{
    if (code == QLatin1String("en"))
        return QStringLiteral("English");
    QString name = QLocale(code).nativeLanguageName();
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

void Language::set(const QString &code)
{
    m_code = code;
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale);
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    // English is what the sources say, all but the plurals: those are in its file.
    if (m_own.load(locale, kStem.chopped(1), QStringLiteral("_"), kFolder) ||
        m_own.load(kStem + QStringLiteral("en"), kFolder))
        QCoreApplication::installTranslator(&m_own);
    if (m_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    // A language without a translator of its own still has to reach the widgets.
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
}

} // namespace driftbench
