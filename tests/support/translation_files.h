// The files in translations/, read as they are: what the programs say and what is said instead.
#pragma once

#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QStringList>
#include <QXmlStreamReader>

#include <vector>

namespace driftbench::test {

struct TranslationEntry
{
    QString context;
    QString source;
    QString comment;
    QString state; // of the file: "unfinished", "vanished", "obsolete"; empty: finished
    bool plural = false;
    QStringList forms; // one, or the plurals

    QString key() const { return context + " | " + source + (comment.isEmpty() ? "" : " | " + comment); }
};

inline QString translationFile(const QString &language)
{
    return QDir(sourceFolder()).filePath("translations/driftbench_" + language + ".ts");
}

inline void readTranslation(QXmlStreamReader &xml, TranslationEntry &entry)
{
    entry.state = xml.attributes().value("type").toString();
    if (!entry.plural) {
        entry.forms << xml.readElementText();
        return;
    }
    while (xml.readNextStartElement())
        entry.forms << xml.readElementText();
}

inline TranslationEntry readTranslationEntry(QXmlStreamReader &xml, const QString &context)
{
    TranslationEntry entry;
    entry.context = context;
    entry.plural = xml.attributes().value("numerus") == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source"))
            entry.source = xml.readElementText();
        else if (xml.name() == QLatin1String("comment"))
            entry.comment = xml.readElementText();
        else if (xml.name() == QLatin1String("translation"))
            readTranslation(xml, entry);
        else
            xml.skipCurrentElement();
    }
    return entry;
}

// Empty where it can't be read.
inline std::vector<TranslationEntry> readTranslations(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::vector<TranslationEntry> entries;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("message"))
            entries.push_back(readTranslationEntry(xml, context));
    }
    return xml.hasError() ? std::vector<TranslationEntry>() : entries;
}

} // namespace driftbench::test
