#include "widgets/views/verdict_card.h"

#include "engine/base/axes.h"
#include "widgets/controls/state_word.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr int kMostRunsListed = 4;
static constexpr double kHysteresisCounts = 2.0; // times the noise
static constexpr int kWordGap = 8;

QString verdictWord(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Yes:
        return VerdictCard::tr("Yes");
    case Verdict::WithCare:
        return VerdictCard::tr("With care");
    case Verdict::NotRepeatable:
        return VerdictCard::tr("No");
    case Verdict::NoDrift:
        return VerdictCard::tr("No drift");
    }
    return {};
}

Tone verdictTone(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Yes:
        return Tone::Good;
    case Verdict::WithCare:
        return Tone::Caution;
    case Verdict::NotRepeatable:
        return Tone::Bad;
    case Verdict::NoDrift:
        break;
    }
    return Tone::Plain;
}

QString passText(const AxisFinding &finding)
{
    if (!finding.limitDps || finding.runs.empty())
        return {};
    const auto runs = static_cast<int>(finding.runs.size());
    const auto passing = finding.passing();
    if (passing == 0)
        return VerdictCard::tr("fails on %1 of %n runs", nullptr, runs).arg(runs);
    return VerdictCard::tr("passes on %1 of %n runs", nullptr, runs).arg(passing);
}

QString FindingText::whole() const
{
    QStringList parts;
    for (const QString &part : {toDo, figures, reason}) {
        if (!part.isEmpty())
            parts.append(part);
    }
    return parts.join(QLatin1Char(' '));
}

static QString axisName(const AxisFinding &finding)
{
    return QString::fromUtf8(kAxisNames[static_cast<std::size_t>(finding.axis)].data());
}

static QString toDo(const AxisFinding &finding)
{
    switch (finding.verdict) {
    case Verdict::Yes:
        return VerdictCard::tr("Write the table.");
    case Verdict::WithCare:
        return finding.losing() > 0 ? VerdictCard::tr("Write only a constant, or the table with care.")
                                    : VerdictCard::tr("Write the table with care.");
    case Verdict::NotRepeatable:
        return VerdictCard::tr("No table for %1.").arg(axisName(finding));
    case Verdict::NoDrift:
        return VerdictCard::tr("Nothing to write for %1: its bias does not move with temperature.")
            .arg(axisName(finding));
    }
    return {};
}

// Three decimals, or as many as show two figures of the smallest.
static int decimalsFor(const AxisFinding &finding)
{
    double smallest = 1.0;
    for (const RunLeft &run : finding.runs) {
        if (run.leftDps > 0.0)
            smallest = std::min(smallest, run.leftDps);
    }
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(smallest))), 3, 6);
}

// Each run, or the range where there are many.
static QString listed(const std::vector<double> &values, int decimals)
{
    if (values.size() > kMostRunsListed) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return VerdictCard::tr("%1 to %2").arg(numberText(*low, decimals), numberText(*high, decimals));
    }
    QStringList texts;
    for (const double value : values)
        texts.append(numberText(value, decimals));
    return texts.join(QStringLiteral(", "));
}

static QString timesText(double times)
{
    return numberText(times, times < 3.0 ? 1 : 0);
}

// "11 to 19 times less than a constant"; empty unless every run gains.
static QString gainText(const AxisFinding &finding)
{
    double low = INFINITY, high = 0.0;
    for (const RunLeft &run : finding.runs) {
        if (!(run.leftDps > 0.0) || !std::isfinite(run.constantDps) || run.constantDps <= run.leftDps)
            return {};
        low = std::min(low, run.constantDps / run.leftDps);
        high = std::max(high, run.constantDps / run.leftDps);
    }
    if (finding.runs.empty())
        return {};
    if (timesText(low) == timesText(high))
        return VerdictCard::tr("%1 times less than a constant").arg(timesText(low));
    return VerdictCard::tr("%1 to %2 times less than a constant").arg(timesText(low), timesText(high));
}

static QString figures(const AxisFinding &finding)
{
    if (finding.runs.empty())
        return VerdictCard::tr("It was not judged on any run.");
    const int decimals = decimalsFor(finding);
    std::vector<double> left, constant;
    for (const RunLeft &run : finding.runs) {
        left.push_back(run.leftDps);
        if (std::isfinite(run.constantDps))
            constant.push_back(run.constantDps);
    }
    QString text = finding.model.starts_with("rbf") || finding.model.empty()
                       ? VerdictCard::tr("It leaves %1 dps rms").arg(listed(left, decimals))
                       : VerdictCard::tr("With the %1 it leaves %2 dps rms")
                             .arg(modelLabel(finding.model), listed(left, decimals));
    if (finding.limitDps && finding.passing() < finding.runs.size())
        text += VerdictCard::tr(", over the limit of %1").arg(numberText(*finding.limitDps, 3));
    const QString gain = gainText(finding);
    if (finding.verdict == Verdict::Yes && !gain.isEmpty())
        text += VerdictCard::tr(", %1").arg(gain);
    else if (constant.size() == left.size())
        text += VerdictCard::tr(", a constant %1").arg(listed(constant, decimals));
    return text + QLatin1Char('.');
}

static QString losingRuns(const AxisFinding &finding)
{
    QStringList names;
    for (const RunLeft &run : finding.runs) {
        if (run.constantIsBetter)
            names.append(QString::fromStdString(run.run));
    }
    if (names.isEmpty())
        return {};
    return VerdictCard::tr("A constant does better on %1.").arg(names.join(QStringLiteral(", ")));
}

static QString reason(const AxisFinding &finding, double hysteresisRmsDps)
{
    const QString losing = finding.verdict == Verdict::NoDrift ? QString() : losingRuns(finding);
    if (!losing.isEmpty())
        return losing;
    double noise = 0.0;
    for (const RunLeft &run : finding.runs)
        noise += run.noiseDps / static_cast<double>(finding.runs.size());
    if (std::isfinite(hysteresisRmsDps) && noise > 0.0 && hysteresisRmsDps > kHysteresisCounts * noise)
        return VerdictCard::tr("The rest is hysteresis, %1 times the noise.")
            .arg(timesText(hysteresisRmsDps / noise));
    return {};
}

FindingText findingText(const AxisFinding &finding, double hysteresisRmsDps)
{
    return {toDo(finding), figures(finding), reason(finding, hysteresisRmsDps)};
}

VerdictCard::VerdictCard(QWidget *parent)
    : Panel(parent)
    , m_axis(new TextLabel(TextRole::Result))
    , m_word(new StateWord)
    , m_passes(new TextLabel(TextRole::Note))
    , m_text(new TextLabel(TextRole::NoteText))
{
    m_word->setRole(TextRole::Result);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_passes->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_passes->setElided(true);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(0, 4, 0, 0);
    head->setSpacing(kWordGap);
    head->addWidget(m_axis);
    head->addWidget(m_word);
    head->addWidget(m_passes, 1);
    rows()->addLayout(head);
    rows()->addWidget(m_text, 1);
    setFocusPolicy(Qt::StrongFocus);
}

void VerdictCard::setFinding(const AxisFinding &finding, double hysteresisRmsDps, const QString &details)
{
    m_verdict = finding.verdict;
    m_known = true;
    m_axis->setText(axisName(finding));
    const QString icon = m_verdict == Verdict::NoDrift ? QStringLiteral("check") : QString();
    m_word->setState(verdictTone(m_verdict), verdictWord(m_verdict), icon);
    m_passes->setText(passText(finding));
    const FindingText text = findingText(finding, hysteresisRmsDps);
    m_text->setText(text.whole());
    setToolTip(details);
    setAccessibleName(
        tr("Verdict for %1: %2. %3").arg(axisName(finding), verdictWord(m_verdict), text.whole()));
    showEdge();
}

void VerdictCard::showEdge()
{
    if (!m_known)
        return;
    const Palette &look = lookOf(palette());
    const Tone tone = verdictTone(m_verdict);
    setEdge(tone == Tone::Caution ? look.cautionEdge : textColor(TextRole::Note, tone, look));
}

void VerdictCard::changeEvent(QEvent *event)
{
    Panel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showEdge();
}

} // namespace driftbench
