// The part of InspectPage that speaks: head, banner, findings, rail and status bar.
#include "app/gui/inspect/inspect_side.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/workbench.h"
#include "widgets/plot/plot_table.h"
#include "widgets/style/number_text.h"

#include <cmath>

namespace driftbench {

static QString listed(const QStringList &names)
{
    if (names.size() < 2)
        return names.join(QString());
    return InspectPage::tr("%1 and %2")
        .arg(names.mid(0, names.size() - 1).join(QStringLiteral(", ")), names.last());
}

// "Heating, run 2", "Cooling, runs 1 and 3": while the runs are few.
std::pair<QString, QString> InspectPage::directionTexts() const
{
    constexpr std::size_t kFew = 4;
    QStringList heating, cooling;
    for (std::size_t r = 0; r < m_seen->runs.size(); ++r) {
        if (m_seen->runs[r].heating)
            heating.append(QString::number(r + 1));
        if (m_seen->runs[r].cooling)
            cooling.append(QString::number(r + 1));
    }
    const auto text = [&](const QString &word, const QStringList &runs) {
        if (m_seen->runs.size() < 2 || m_seen->runs.size() > kFew || runs.isEmpty())
            return word;
        return runs.size() == 1 ? tr("%1, run %2").arg(word, runs.front())
                                : tr("%1, runs %2").arg(word, listed(runs));
    };
    return {text(tr("Heating"), heating), text(tr("Cooling"), cooling)};
}

void InspectPage::showHead()
{
    if (!m_seen) {
        head().setOrigin(Origin::None);
        head().setContext(tr("TDE against the temperature quantities"));
        return;
    }
    head().setOrigin(m_seen->simulated ? Origin::Simulated : Origin::Real);
    QString reference = numberText(0.0, 0);
    const auto &runs = m_seen->prepared->plan.runs;
    if (m_seen->prepared->plan.referenceFromHold)
        reference = QString();
    else if (!runs.empty() && runs.front().referenceRateDps[m_axis] != 0.0)
        reference = numberText(runs.front().referenceRateDps[m_axis], 2);
    head().setContext(
        reference.isEmpty()
            ? tr("TDE of %1 against temperature, reference from the holds").arg(axisLetter(m_axis))
            : tr("TDE of %1 against temperature, reference %2 dps").arg(axisLetter(m_axis), reference));
}

// "−3.99 (cooling), −4.21 (heating) and −3.42 dps (cooling again)"
static QString passagesText(const Hysteresis &hysteresis, int axis)
{
    QStringList parts;
    int heated = 0, cooled = 0;
    for (std::size_t i = 0; i < hysteresis.passages.size(); ++i) {
        const Passage &passage = hysteresis.passages[i];
        const bool again = (passage.heating ? heated : cooled)++ > 0;
        const QString how = passage.heating
                                ? (again ? InspectPage::tr("heating again") : InspectPage::tr("heating"))
                                : (again ? InspectPage::tr("cooling again") : InspectPage::tr("cooling"));
        const QString value = numberText(passage.tdeDps[axis], 2);
        parts.append(i + 1 == hysteresis.passages.size() ? InspectPage::tr("%1 dps (%2)").arg(value, how)
                                                         : QStringLiteral("%1 (%2)").arg(value, how));
    }
    return listed(parts);
}

void InspectPage::showBanner()
{
    const QString refused = QStringLiteral("refusal");
    const QString shape = QStringLiteral("shape");
    banners().withdraw(refused);
    banners().withdraw(shape);
    if (!m_seen)
        return;
    if (m_seen->prepared->refusal) {
        BannerContent content;
        content.kind = BannerKind::Bad;
        content.what = tr("These runs can't be calibrated as they are.");
        content.toDo = QString::fromStdString(m_seen->prepared->refusal->message);
        content.actions = {m_findings};
        content.closable = false;
        banners().post(refused, content);
    } else if (m_seen->inspection &&
               m_seen->inspection->axes[static_cast<std::size_t>(m_axis)].kind == CurveKind::Not) {
        const Hysteresis &hysteresis = m_seen->inspection->hysteresis;
        BannerContent content;
        content.kind = BannerKind::Caution;
        content.what = tr("%1 is not a curve of temperature.").arg(axisLetter(m_axis));
        content.toDo = tr("No table over temperature can remove this.");
        if (hysteresis.passages.size() > 1)
            content.toDo =
                tr("At %1 °C it reads %2.")
                    .arg(numberText(hysteresis.meetingTemperatureC, 0), passagesText(hysteresis, m_axis)) +
                QLatin1Char(' ') + content.toDo;
        banners().post(shape, content);
    }
}

void InspectPage::showFindings()
{
    if (!m_seen)
        return;
    PlotTable table;
    table.columns = {
        {tr("Run"), {}, {}}, {tr("From"), {}, {}}, {tr("To"), {}, {}}, {tr("What was found"), {}, {}}};
    for (std::size_t r = 0; r < m_seen->runs.size(); ++r) {
        const PreparedRun &run = m_seen->prepared->runs[r];
        for (const Finding &finding : run.checked.run.findings) {
            const bool somewhere = finding.endS > finding.startS;
            table.columns[0].texts.append(QString::fromStdString(m_seen->runs[r].name));
            table.columns[1].texts.append(somewhere ? clockText(finding.startS) : tr("all over"));
            table.columns[2].texts.append(somewhere ? clockText(finding.endS) : QString());
            table.columns[3].texts.append(QString::fromStdString(finding.message));
        }
    }
    showPlotTable(std::move(table), tr("Findings of the checks"), this);
}

void InspectPage::showButtons()
{
    const bool own = m_picked && m_seen && m_seen->excluded[*m_picked].own;
    m_exclude->setText(own ? tr("Include") : tr("Exclude"));
    m_exclude->setEnabled(own || !m_selection.empty());
    m_exclude->setToolTip(m_exclude->isEnabled() ? QString()
                                                 : tr("Drag in the time strip to select a stretch first."));
    std::size_t findings = 0;
    if (m_seen) {
        for (const PreparedRun &run : m_seen->prepared->runs)
            findings += run.checked.run.findings.size();
    }
    m_findings->setText(tr("Findings (%1)").arg(findings));
    m_findings->setEnabled(findings > 0);
}

StepState InspectPage::stepState() const
{
    if (!m_seen) {
        const auto runs = static_cast<int>(context().workbench->session().runs().size());
        if (runs == 0)
            return {stepPurpose(Step::Inspect), false, StepMark::None};
        return {tr("%n run(s)", nullptr, runs), true, StepMark::None};
    }
    if (m_seen->prepared->refusal)
        return {tr("Can't be calibrated"), true, StepMark::Warning};
    QStringList not_;
    for (int axis = 0; m_seen->inspection && axis < 3; ++axis) {
        if (m_seen->inspection->axes[static_cast<std::size_t>(axis)].kind == CurveKind::Not)
            not_.append(axisLetter(axis));
    }
    if (not_.isEmpty())
        return {tr("%n run(s)", nullptr, static_cast<int>(m_seen->runs.size())), true, StepMark::Done};
    return {tr("%1: hysteresis").arg(not_.join(QStringLiteral(", "))), true, StepMark::Warning};
}

QString InspectPage::hints() const
{
    return tr("Drag in the time strip to select · Delete exclude · Ctrl+Z undo · X, Y, Z choose the axis · "
              "Double-click fit");
}

std::vector<StatusPart> InspectPage::statusParts() const
{
    if (!m_seen)
        return {};
    const QString runs = tr("%n run(s)", nullptr, static_cast<int>(m_seen->runs.size()));
    const QString samples = numberText(double(m_seen->samples), 0);
    std::vector<StatusPart> parts{
        {tr("%1, %2 samples at %3 Hz")
             .arg(runs, samples, numberText(m_seen->sampleRateHz, m_seen->sampleRateHz < 10.0 ? 2 : 1)),
         Tone::Plain}};
    if (m_seen->samplesAPoint > 1)
        parts.push_back({tr("Each point is the mean of %1 samples").arg(m_seen->samplesAPoint), Tone::Plain});
    parts.push_back({tr("%1 excluded").arg(numberText(double(m_seen->excludedSamples), 0)), Tone::Plain});
    return parts;
}

} // namespace driftbench
