#include "widgets/style/fonts.h"

#include <QFontDatabase>
#include <QHash>

namespace driftbench {

static QFont makeFont(const QFont &system, int points, QFont::Weight weight)
{
    static const QString kPreferred = QStringLiteral("Open Sans");
    QFont font = system;
    if (QFontDatabase::hasFamily(kPreferred))
        font.setFamily(kPreferred);
    font.setPointSize(points);
    font.setWeight(weight);
    return font;
}

// Copies of one font share what has been looked up for it; to find that anew for each cell of a table holds
// up the window. Reports are drawn on threads of their own.
static QFont sansFont(int points, QFont::Weight weight)
{
    thread_local QFont system;
    thread_local QHash<int, QFont> made;
    const QFont now = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    if (now != system) {
        system = now;
        made.clear();
    }
    const int key = points * 1000 + weight;
    auto found = made.find(key);
    if (found == made.end())
        found = made.insert(key, makeFont(now, points, weight));
    return *found;
}

QFont bodyFont()
{
    return sansFont(10, QFont::Normal);
}

QFont sectionFont()
{
    return sansFont(10, QFont::DemiBold);
}

QFont noteFont()
{
    return sansFont(9, QFont::Normal);
}

QFont strongNoteFont()
{
    return sansFont(9, QFont::DemiBold);
}

QFont resultFont()
{
    return sansFont(12, QFont::DemiBold);
}

QFont pageTitleFont()
{
    return sansFont(15, QFont::DemiBold);
}

} // namespace driftbench
