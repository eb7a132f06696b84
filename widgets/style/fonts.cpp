#include "widgets/style/fonts.h"

#include <QFontDatabase>

namespace driftbench {

static QFont sansFont(int points, QFont::Weight weight)
{
    static const QString kPreferred = QStringLiteral("Open Sans");
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    if (QFontDatabase::hasFamily(kPreferred))
        font.setFamily(kPreferred);
    font.setPointSize(points);
    font.setWeight(weight);
    return font;
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
