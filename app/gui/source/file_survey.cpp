#include "app/gui/source/file_survey.h"

#include "app/session/session_file.h"
#include "engine/base/axes.h"
#include "engine/evaluation/hysteresis.h"
#include "engine/features/run_features.h"
#include "engine/formats/log_reader.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"
#include "engine/recording/run_report.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

// A log beyond this is not read unasked.
constexpr std::uintmax_t kLargestLookBytes = std::uintmax_t{400} << 20;
// Heating and cooling part when their difference is more than this share of the axis's swing and more than so
// many times its noise.
constexpr double kHysteresisShare = 0.1;
constexpr double kHysteresisNoise = 3.0;
constexpr int kSurveyCellFactor = 25; // cells of 0.5 degrees for the swing

class SurveyWords
{
    Q_DECLARE_TR_FUNCTIONS(driftbench::FileSurvey)
};

QString formatText(std::string_view name)
{
    if (name == logFormatName(LogFormat::ULog))
        return QStringLiteral("ULog");
    return name == logFormatName(LogFormat::DataFlash) ? QStringLiteral("DataFlash") : QStringLiteral("CSV");
}

void expectOf(FileSurvey &survey, const QString &words, Tone tone)
{
    survey.expect = words;
    survey.tone = tone;
}

void expectRefusal(FileSurvey &survey, const Error &refusal)
{
    switch (refusal.code) {
    case Errc::SpanTooSmall:
        return expectOf(survey, SurveyWords::tr("Span too small to fit"), Tone::Caution);
    case Errc::ConstantTemperature:
        return expectOf(survey, SurveyWords::tr("Temperature stands still"), Tone::Caution);
    case Errc::TooShort:
    case Errc::TooFewSamples:
        return expectOf(survey, SurveyWords::tr("Too short to fit"), Tone::Caution);
    default:
        return expectOf(survey, SurveyWords::tr("Can't be used as it is"), Tone::Caution);
    }
}

double swingDps(const ThermalCurve &curve, int axis)
{
    double lowest = INFINITY, highest = -INFINITY;
    for (const ThermalCell &cell : curve.cells()) {
        if (cell.count <= 0.0)
            continue;
        lowest = std::min(lowest, cell.meanTdeDps()[axis]);
        highest = std::max(highest, cell.meanTdeDps()[axis]);
    }
    return highest - lowest;
}

// "x, z", the axes on which heating and cooling part.
QString hystereticAxes(const Run &run)
{
    auto campaign = makeCampaign({run});
    if (!campaign)
        return {};
    const TrainingSet set = makeTrainingSet(*campaign, chooseReferenceTemperature(*campaign, std::nullopt));
    const Hysteresis hysteresis = analyseHysteresis(set);
    if (!hysteresis.heatingAndCooling)
        return {};
    // From sample to sample: what varies within a cell of temperature has the hysteresis in it.
    const RunReport report = summarise(run);
    const ThermalCurve curve = set.runs.front()->curve.coarsened(kSurveyCellFactor);
    QStringList axes;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const double rms = hysteresis.rmsDps[axis];
        if (rms > kHysteresisShare * swingDps(curve, axis) &&
            rms > kHysteresisNoise * report.axes[static_cast<std::size_t>(axis)].noiseDifferencesDps)
            axes << QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
    }
    return axes.join(QStringLiteral(", "));
}

void surveyRecording(FileSurvey &survey, Recording recording)
{
    survey.origin = recording.info.simulated ? Origin::Simulated : Origin::Real;
    survey.samples = recording.size();
    survey.sensor = recording.info.sensor;
    if (!recording.empty()) {
        survey.durationS = recording.timeS[recording.size() - 1] - recording.timeS[0];
        survey.hasTemperature = true;
        survey.lowestC = recording.temperatureC.minCoeff();
        survey.highestC = recording.temperatureC.maxCoeff();
    }
    const CheckedRun checked = checkRun(std::move(recording));
    const auto &findings = checked.run.findings;
    const bool noDrift = std::any_of(findings.begin(), findings.end(),
                                     [](const Finding &finding) { return finding.kind == "no drift"; });
    if (noDrift)
        return expectOf(survey, SurveyWords::tr("No drift found"), Tone::Plain);
    if (checked.refusal)
        return expectRefusal(survey, *checked.refusal);
    survey.isTrainable = true;
    if (const QString axes = hystereticAxes(checked.run); !axes.isEmpty())
        return expectOf(survey, SurveyWords::tr("%1: hysteresis").arg(axes), Tone::Caution);
}

void surveySession(FileSurvey &survey)
{
    survey.kind = FileKind::Session;
    survey.format = SurveyWords::tr("Session");
    const auto file = SessionFile::open(survey.path, SessionAccess::ReadOnly);
    if (!file)
        return expectOf(survey, SurveyWords::tr("Can't be opened"), Tone::Bad);
    const auto runs = file->runs();
    const auto plan = file->plan();
    if (!runs)
        return expectOf(survey, SurveyWords::tr("Can't be opened"), Tone::Bad);
    survey.runs = static_cast<int>(runs->size());
    survey.plannedRuns = plan && *plan ? (*plan)->runs : 0;
    bool simulated = false;
    for (const RunRecord &run : *runs) {
        simulated = simulated || run.description.simulated;
        const auto overview = file->overview(run.id);
        if (!overview || overview->size() == 0)
            continue;
        const double low = overview->lowest.col(0).minCoeff();
        const double high = overview->highest.col(0).maxCoeff();
        survey.lowestC = survey.hasTemperature ? std::min(survey.lowestC, low) : low;
        survey.highestC = survey.hasTemperature ? std::max(survey.highestC, high) : high;
        survey.hasTemperature = true;
    }
    if (!runs->empty())
        survey.origin = simulated ? Origin::Simulated : Origin::Real;
    if (survey.runs < survey.plannedRuns)
        expectOf(survey, SurveyWords::tr("Run %1 to do").arg(survey.runs + 1), Tone::Plain);
    else
        expectOf(survey, runs->empty() ? SurveyWords::tr("No runs yet") : SurveyWords::tr("Ready to train"),
                 Tone::Plain);
}

void surveyLog(FileSurvey &survey, const ProgressHook &hook)
{
    survey.kind = FileKind::Log;
    const auto format = detectFormat(survey.path);
    if (!format)
        return expectOf(survey,
                        format.error().code == Errc::FileNotFound ? SurveyWords::tr("Not there any more")
                                                                  : SurveyWords::tr("Unknown format"),
                        Tone::Bad);
    survey.format = formatText(logFormatName(*format));
    std::error_code code;
    if (std::filesystem::file_size(survey.path, code) > kLargestLookBytes)
        return expectOf(survey, SurveyWords::tr("Large: looked at when opened"), Tone::Plain);
    const auto instances = listInstances(survey.path, {}, hook);
    if (!instances)
        return expectOf(survey, SurveyWords::tr("Can't be read"), Tone::Bad);
    ReadOptions read;
    // Of several gyros the first that has a temperature stands for the log until the user chooses.
    const auto first = std::find_if(instances->begin(), instances->end(),
                                    [](const LogInstance &instance) { return instance.hasTemperature(); });
    if (instances->size() > 1 && first != instances->end())
        survey.instance = read.instance = first->instance;
    auto recording = readLog(survey.path, read, hook);
    if (!recording)
        return expectOf(survey, SurveyWords::tr("Can't be read"), Tone::Bad);
    surveyRecording(survey, *std::move(recording));
}

} // namespace

FileSurvey surveyFile(const std::filesystem::path &path, const ProgressHook &hook)
{
    FileSurvey survey;
    survey.path = path;
    if (path.extension() == kSessionEnding)
        surveySession(survey);
    else
        surveyLog(survey, hook);
    return survey;
}

} // namespace driftbench
