#include "engine/evaluation/judged_traces.h"

namespace driftbench {

namespace {

Eigen::MatrixX3d leftBy(const RunFeatures &run, const TrainedModel &model)
{
    const Eigen::VectorXd temperatureC = run.deltaT.array() + model.referenceTemperatureC;
    return run.tdeDps - predictAtTemperature(model, temperatureC).tdeDps;
}

void anchor(Eigen::MatrixX3d &valuesDps, Eigen::Index startSamples)
{
    if (startSamples == 0)
        return;
    const Eigen::RowVector3d start = valuesDps.topRows(startSamples).colwise().mean();
    valuesDps.rowwise() -= start;
}

} // namespace

JudgedTraces judgedTraces(const std::shared_ptr<const RunFeatures> &run, const TrainedModel &model,
                          const TrainedModel *constant, Judging judging)
{
    JudgedTraces traces;
    traces.run = run->name;
    traces.model = model.name;
    traces.trainedOn = model.trainedOn;
    traces.lessConstant = constant != nullptr;
    traces.timeS = run->timeS;
    traces.beforeDps = constant != nullptr ? leftBy(*run, *constant) : run->tdeDps;
    traces.afterDps = leftBy(*run, model);
    const Eigen::Index start = prepareForJudging(run, run, judging).startSamples;
    anchor(traces.beforeDps, start);
    anchor(traces.afterDps, start);
    traces.allanBefore = allanDeviation(traces.timeS, traces.beforeDps);
    traces.allanAfter = allanDeviation(traces.timeS, traces.afterDps);
    return traces;
}

} // namespace driftbench
