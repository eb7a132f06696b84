#include "app/session/settings.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <array>
#include <cmath>

namespace driftbench {

namespace {

constexpr std::array<const char *, 3> kThemeNames{"system", "light", "dark"};

ThemeChoice themeNamed(const QString &name)
{
    for (std::size_t i = 0; i < kThemeNames.size(); ++i) {
        if (name == QLatin1String(kThemeNames[i]))
            return static_cast<ThemeChoice>(i);
    }
    return ThemeChoice::System;
}

QStringList filesIn(const QSettings &store, const QString &key)
{
    QStringList files = store.value(key).toStringList();
    files.removeAll(QString());
    files.removeDuplicates();
    return files.mid(0, Settings::kMostRecent);
}

double positiveOr(const QVariant &value, double otherwise)
{
    bool isNumber = false;
    const double number = value.toDouble(&isNumber);
    return isNumber && std::isfinite(number) && number > 0.0 ? number : otherwise;
}

const QString kSplitters = QStringLiteral("window/splitters");

} // namespace

Settings loadSettings(const QSettings &store)
{
    Settings settings;
    settings.theme = themeNamed(store.value("theme").toString());
    settings.language = store.value("language").toString();
    settings.recentSessions = filesIn(store, "files/sessions");
    settings.recentLogs = filesIn(store, "files/logs");
    settings.lastSession = store.value("files/last_session").toString();
    settings.lastFolder = store.value("files/last_folder").toString();
    settings.bridgeIds = store.value("source/bridge_ids").toStringList();
    settings.lastSource = store.value("source/last").toString();
    settings.chartHistoryS = positiveOr(store.value("source/history_s"), settings.chartHistoryS);
    settings.windowGeometry = store.value("window/geometry").toByteArray();
    settings.windowState = store.value("window/state").toByteArray();
    const QVariantMap splitters = store.value(kSplitters).toMap();
    for (auto each = splitters.begin(); each != splitters.end(); ++each)
        settings.splitters.insert(each.key(), each.value().toByteArray());
    return settings;
}

void saveSettings(const Settings &settings, QSettings &store)
{
    store.setValue("theme", QString::fromLatin1(kThemeNames[static_cast<std::size_t>(settings.theme)]));
    store.setValue("language", settings.language);
    store.setValue("files/sessions", settings.recentSessions);
    store.setValue("files/logs", settings.recentLogs);
    store.setValue("files/last_session", settings.lastSession);
    store.setValue("files/last_folder", settings.lastFolder);
    store.setValue("source/bridge_ids", settings.bridgeIds);
    store.setValue("source/last", settings.lastSource);
    store.setValue("source/history_s", settings.chartHistoryS);
    store.setValue("window/geometry", settings.windowGeometry);
    store.setValue("window/state", settings.windowState);
    QVariantMap splitters;
    for (auto each = settings.splitters.begin(); each != settings.splitters.end(); ++each)
        splitters.insert(each.key(), each.value());
    store.setValue(kSplitters, splitters);
    store.sync();
}

void addRecent(QStringList &recent, const QString &file)
{
    const QString absolute = QFileInfo(file).absoluteFilePath();
    recent.removeAll(absolute);
    recent.prepend(absolute);
    recent = recent.mid(0, Settings::kMostRecent);
}

} // namespace driftbench
