#include "device/gyros/gyro_i2c_source.h"

#include "engine/base/text.h"

#include <algorithm>

namespace driftbench {

using namespace st_gyro;

namespace {

const Description *describedBy(const GyroI2cOptions &options)
{
    if (!options.model.empty())
        return descriptionOf(options.model);
    for (const Description &description : descriptions()) {
        if (std::ranges::find(description.addresses, options.address) != description.addresses.end())
            return &description;
    }
    return nullptr;
}

Result<StGyro> openGyro(I2cBus &bus, const GyroI2cOptions &options)
{
    if (options.model.empty() && options.address == 0)
        return StGyro::find(bus);
    const Description *description = describedBy(options);
    if (description == nullptr)
        return Error{Errc::InvalidOption, "There is no gyro \"" + options.model + "\" for I2C address " +
                                              hexByte(options.address) +
                                              "; choose I3G4250D or L3GD20H, or their addresses."};
    if (options.address != 0)
        return StGyro::open(bus, *description, options.address);
    Result<StGyro> gyro = StGyro::open(bus, *description, description->addresses[0]);
    if (!gyro && gyro.error().code == Errc::BusNoAcknowledge)
        gyro = StGyro::open(bus, *description, description->addresses[1]);
    return gyro;
}

// The one beside the gyro; nothing: the die's serves.
Result<std::optional<I2cThermometer>> openThermometer(I2cBus &bus, const TemperatureOptions &options)
{
    if (!options.useExternal)
        return std::optional<I2cThermometer>();
    if (options.externalModel && options.externalAddress != 0) {
        const Result<I2cThermometer> there =
            I2cThermometer::open(bus, *options.externalModel, options.externalAddress);
        if (there)
            return std::optional<I2cThermometer>(*there);
        return there.error();
    }
    const auto found = I2cThermometer::find(bus, options.externalModel);
    if (!found || *found || !options.requireExternal)
        return found;
    const std::string wanted = options.externalModel
                                   ? "No " + std::string(thermometerName(*options.externalModel))
                                   : std::string("No external thermometer");
    return Error{Errc::BusNoAcknowledge, wanted + " answers on " + bus.name() +
                                             "; check its power and its wiring, or choose the die's."};
}

constexpr std::array kAxes{'x', 'y', 'z'};

} // namespace

GyroI2cSource::GyroI2cSource(std::unique_ptr<I2cBus> bus, StGyro gyro, std::optional<I2cThermometer> external,
                             const GyroI2cOptions &options, HostClock &clock)
    : m_bus(std::move(bus))
    , m_gyro(gyro)
    , m_thermometerName(external ? std::string(thermometerName(external->model())) : std::string())
    , m_options(options)
    , m_fifo(m_gyro, clock, m_bus->limits().longestRead)
    , m_temperature(m_gyro, external, clock, options.temperature)
    , m_block(SampleBlock::withRows(kFifoSamples))
{
    m_info.sensor = {std::string(m_gyro.description().model), options.serial};
    m_info.name = m_bus->name() + " with " + m_info.sensor.model + " at " + hexByte(m_gyro.address());
    m_info.sampleRateHz = m_gyro.nominalRateHz();
    m_info.rangeDps = m_gyro.rangeDps();
}

Result<std::unique_ptr<GyroI2cSource>> GyroI2cSource::open(std::unique_ptr<I2cBus> bus,
                                                           const GyroI2cOptions &options, HostClock &clock)
{
    Result<StGyro> gyro = openGyro(*bus, options);
    if (!gyro)
        return gyro.error();
    if (const Status ok = gyro->setUp(options.gyro); !ok)
        return ok.error();
    const auto external = openThermometer(*bus, options.temperature);
    if (!external)
        return external.error();
    return std::unique_ptr<GyroI2cSource>(
        new GyroI2cSource(std::move(bus), *gyro, *external, options, clock));
}

Result<SourceStats> GyroI2cSource::run(SampleSink &sink, std::stop_token stop)
{
    const Status measured = measure(sink, stop);
    m_stats.clockDriftPpm = (m_fifo.rateHz() / m_gyro.nominalRateHz() - 1.0) * 1e6;
    if (!measured)
        return measured.error();
    return m_stats;
}

Status GyroI2cSource::measure(SampleSink &sink, const std::stop_token &stop)
{
    if (const Status ok = m_temperature.first(); !ok)
        return ok;
    sink.event(m_thermometerName.empty()
                   ? "The temperature is that of the gyro's die and relative: " +
                         forReading(m_options.temperature.dieCPerCount, 1) + " \u00b0C per count, " +
                         forReading(m_options.temperature.dieOffsetC, 1) + " \u00b0C at count 0."
                   : "The temperature is that of the " + m_thermometerName + ".");
    if (const Status ok = m_fifo.start(); !ok)
        return ok;
    noteTemperature(sink);
    Status state;
    while (!stop.stop_requested()) {
        const Result<FifoBurst> burst = m_fifo.next();
        if (!burst) {
            state = burst.error();
            break;
        }
        if (const std::optional<Error> failure = m_fifo.takeFailure())
            sink.event(failure->message);
        if (deliver(*burst, sink) == Flow::Stop)
            return {};
        // Before the wait, which ends when the FIFO had best be looked at.
        if (state = m_temperature.readIfDue(); !state)
            break;
        noteTemperature(sink);
        m_fifo.wait();
    }
    deliver(m_fifo.last(), sink);
    return state;
}

void GyroI2cSource::noteTemperature(SampleSink &sink)
{
    if (m_readings.empty() || m_readings.back().atS != m_temperature.readAtS())
        m_readings.push_back({m_temperature.readAtS(), m_temperature.temperatureC()});
    if (const std::optional<std::string> event = m_temperature.takeEvent())
        sink.event(*event);
}

Flow GyroI2cSource::deliver(const FifoBurst &burst, SampleSink &sink)
{
    if (burst.samples == 0)
        return Flow::Continue;
    if (m_stats.samples == 0)
        m_firstS = burst.firstS;
    if (burst.lostBefore > 0) {
        ++m_stats.gaps;
        m_stats.lostSamples += burst.lostBefore;
        sink.gap({m_lastS, burst.firstS - m_firstS, burst.lostBefore,
                  burst.lostInTransfer ? GapCause::ReportsLost : GapCause::DeviceOverrun});
    }
    const double stepS = burst.samples > 1 ? (burst.lastS - burst.firstS) / (burst.samples - 1) : 0.0;
    m_block.firstSample = burst.firstSample;
    for (Eigen::Index i = 0; i < burst.samples; ++i) {
        const Counts &counts = burst.counts[static_cast<std::size_t>(i)];
        const double timeS = burst.firstS + static_cast<double>(i) * stepS;
        m_block.timeS[i] = timeS - m_firstS;
        m_block.temperatureC[i] = temperatureAt(timeS);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            m_block.rateDps(i, axis) = counts[static_cast<std::size_t>(axis)] * m_gyro.sensitivityDps();
        noteSaturation(counts, sink);
    }
    m_lastS = m_block.timeS[burst.samples - 1];
    m_stats.samples += burst.samples;
    return sink.samples(m_block, burst.samples);
}

double GyroI2cSource::temperatureAt(double timeS)
{
    while (m_readings.size() > 1 && m_readings[1].atS <= timeS)
        m_readings.pop_front();
    return m_readings.front().temperatureC;
}

void GyroI2cSource::noteSaturation(const Counts &counts, SampleSink &sink)
{
    if (!saturated(counts))
        return;
    ++m_stats.saturatedSamples;
    for (std::size_t axis = 0; axis < counts.size(); ++axis) {
        const bool atLimit = saturated({counts[axis], 0, 0});
        if (!atLimit || m_saturationTold[axis])
            continue;
        m_saturationTold[axis] = true;
        sink.event("The rate of axis " + std::string(1, kAxes[axis]) + " is beyond the range of " +
                   shortest(m_info.rangeDps) + " dps; choose a larger range.");
    }
}

} // namespace driftbench
