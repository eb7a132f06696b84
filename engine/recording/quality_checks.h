// The detectors behind quality.h, one function a check. Private to this folder.
#pragma once

#include "engine/base/axes.h"
#include "engine/recording/quality.h"

#include <array>
#include <string>
#include <vector>

namespace driftbench::quality {

// The columns of the samples that are usable so far.
struct UsableColumns
{
    std::vector<Eigen::Index> rows; // in the recording
    std::vector<double> timeS;
    std::vector<double> temperatureC;
    std::array<std::vector<double>, kAxisCount> rateDps;

    std::size_t size() const { return rows.size(); }
};

// A run while it is being checked.
class Draft
{
public:
    explicit Draft(Recording recordingToCheck);

    Recording recording;
    std::vector<Finding> findings;
    std::optional<Error> refusal;
    double intervalS = 0.0; // median between usable samples; known after checkTimes

    const Mask &mask() const { return m_mask; }
    void exclude(Eigen::Index sample, MaskReason reason);
    void replaceTemperature(const std::vector<Eigen::Index> &rows, const std::vector<double> &temperatureC);

    // As of this call; stays as it is until the next call after a change.
    const UsableColumns &usable();

    void note(FindingSeverity severity, std::string kind, std::string message, double startS = 0.0,
              double endS = 0.0);
    // Keeps the first refusal as the error of the run.
    void refuse(Errc code, std::string kind, std::string message);

private:
    Mask m_mask;
    UsableColumns m_usable;
    bool m_usableIsCurrent = false;
};

// "4 590" for figures in sentences; "1 sample", "3 samples".
std::string countText(Eigen::Index count);
std::string countOf(Eigen::Index count, const std::string &thing);
// "71.2 to 163.0 s"
std::string rangeText(double startS, double endS);
// "run1.csv: ", or nothing where the source is unknown.
std::string sourcePrefix(const Recording &recording);

void checkValues(Draft &draft, const QualityOptions &options);
void checkTimes(Draft &draft, const QualityOptions &options);
void excludeRanges(Draft &draft, const QualityOptions &options);
void checkStartUp(Draft &draft);
void checkSaturation(Draft &draft);
void checkTemperature(Draft &draft);
void interpolateStairs(Draft &draft, const QualityOptions &options);
void checkMotion(Draft &draft, const QualityOptions &options);
void checkOutliers(Draft &draft);
void checkSufficiency(Draft &draft, const QualityOptions &options);
void checkDrift(Draft &draft);

} // namespace driftbench::quality
