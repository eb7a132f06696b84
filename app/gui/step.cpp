#include "app/gui/step.h"

#include <QCoreApplication>

namespace driftbench {

static QString stepText(const char *english)
{
    return QCoreApplication::translate("Step", english);
}

QString stepName(Step step)
{
    switch (step) {
    case Step::Source:
        return stepText(QT_TRANSLATE_NOOP("Step", "Source"));
    case Step::Plan:
        return stepText(QT_TRANSLATE_NOOP("Step", "Plan"));
    case Step::Record:
        return stepText(QT_TRANSLATE_NOOP("Step", "Record"));
    case Step::Inspect:
        return stepText(QT_TRANSLATE_NOOP("Step", "Inspect"));
    case Step::Train:
        return stepText(QT_TRANSLATE_NOOP("Step", "Train"));
    case Step::Compare:
        return stepText(QT_TRANSLATE_NOOP("Step", "Compare"));
    case Step::Export:
        return stepText(QT_TRANSLATE_NOOP("Step", "Export"));
    }
    return {};
}

QString stepPurpose(Step step)
{
    switch (step) {
    case Step::Source:
        return stepText(QT_TRANSLATE_NOOP("Step", "Choose one"));
    case Step::Plan:
        return stepText(QT_TRANSLATE_NOOP("Step", "Temperature steps"));
    case Step::Record:
        return stepText(QT_TRANSLATE_NOOP("Step", "Live traces"));
    case Step::Inspect:
        return stepText(QT_TRANSLATE_NOOP("Step", "Look at the drift"));
    case Step::Train:
        return stepText(QT_TRANSLATE_NOOP("Step", "Fit models"));
    case Step::Compare:
        return stepText(QT_TRANSLATE_NOOP("Step", "Judge the fit"));
    case Step::Export:
        return stepText(QT_TRANSLATE_NOOP("Step", "Write the table"));
    }
    return {};
}

QString stepIcon(Step step)
{
    static const std::array<QString, kSteps.size()> kIcons{
        QStringLiteral("source"),  QStringLiteral("plan"),  QStringLiteral("record"),
        QStringLiteral("inspect"), QStringLiteral("train"), QStringLiteral("compare"),
        QStringLiteral("export")};
    return kIcons[static_cast<std::size_t>(step)];
}

} // namespace driftbench
