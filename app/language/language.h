// The language of a program, switched while it runs: the translations that are built in, English always.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTranslator>

namespace driftbench {

class Language : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    static QStringList available();                 // "en", "de", "zh_CN", ...
    static QString nativeName(const QString &code); // "Deutsch"

    // Empty: the system's. Numbers on screen follow it. Widgets get LanguageChange.
    void set(const QString &code);
    const QString &code() const { return m_code; } // as it was set

private:
    QString m_code;
    QTranslator m_own;
    QTranslator m_qt;
};

} // namespace driftbench
