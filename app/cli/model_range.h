// How much of what a model is used on lies outside the temperatures that it was trained on.
#pragma once

#include "engine/base/result.h"
#include "engine/models/trained_model.h"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <string>

namespace driftbench::cli {

class ModelRange
{
public:
    explicit ModelRange(const TrainedModel &model)
        : m_trained(model.lowestTemperatureC, model.highestTemperatureC)
    {
    }

    void add(const Eigen::VectorXd &temperatureC); // what is not finite does not count

    std::int64_t outside() const { return m_outside; }
    bool reachesBeyond() const; // by more than what the noise of a thermometer does
    bool wholly() const { return m_samples > 0 && m_outside == m_samples; }

    // OutsideTrainedRange; what: the log or logs, "run1.csv".
    Error refusal(const std::string &what, const std::string &modelFile) const;
    std::string notice(const std::string &what) const; // of a part that is outside

private:
    std::string trainedText() const;

    Eigen::Vector2d m_trained;
    std::int64_t m_samples = 0;
    std::int64_t m_outside = 0;
    double m_lowestC = INFINITY;
    double m_highestC = -INFINITY;
};

} // namespace driftbench::cli
