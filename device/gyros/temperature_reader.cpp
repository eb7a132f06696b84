#include "device/gyros/temperature_reader.h"

#include <utility>

namespace driftbench {

namespace {

// Twice the time of a TMP117's conversion, and how often to look in that time.
constexpr double kFirstReadingS = 2.0;
constexpr int kLooks = 20;

} // namespace

TemperatureReader::TemperatureReader(StGyro &gyro, std::optional<I2cThermometer> external, HostClock &clock,
                                     const TemperatureOptions &options)
    : m_gyro(gyro)
    , m_external(std::move(external))
    , m_clock(clock)
    , m_options(options)
    , m_signCheck(options.dieCPerCount)
{
}

Status TemperatureReader::first()
{
    for (int look = 0; look < kLooks; ++look) {
        const Result<bool> done = read();
        if (!done)
            return done.error();
        if (*done)
            return {};
        m_clock.waitS(kFirstReadingS / kLooks);
    }
    return Error{Errc::DeviceSilent, "The thermometer " + std::string(thermometerName(m_external->model())) +
                                         " at I2C address " + hexByte(m_external->address()) +
                                         " measures nothing; switch it off and on."};
}

Status TemperatureReader::readIfDue()
{
    if (m_clock.nowS() < m_dueS)
        return {};
    const Result<bool> done = read();
    return done ? Status() : Status(done.error());
}

std::optional<std::string> TemperatureReader::takeEvent()
{
    return std::exchange(m_event, std::nullopt);
}

Result<bool> TemperatureReader::read()
{
    const Result<bool> done = readBoth();
    m_dueS = m_clock.nowS() + m_options.intervalS;
    if (done) {
        m_failures = 0;
        return done;
    }
    if (done.error().code == Errc::DeviceUnplugged || ++m_failures > kMostFailures)
        return done;
    m_event = done.error().message;
    return false;
}

Result<bool> TemperatureReader::readBoth()
{
    const double beganS = m_clock.nowS();
    const Result<int> count = m_gyro.dieCount();
    if (!count)
        return count.error();
    double temperatureC = m_options.dieOffsetC + m_options.dieCPerCount * *count;
    if (m_external) {
        const Result<std::optional<double>> externalC = m_external->temperatureC();
        if (!externalC)
            return externalC.error();
        if (!*externalC)
            return false;
        temperatureC = **externalC;
        if (std::optional<std::string> verdict = m_signCheck.add(temperatureC, *count))
            m_event = std::move(verdict);
    }
    m_temperatureC = temperatureC;
    m_readAtS = 0.5 * (beganS + m_clock.nowS());
    return true;
}

} // namespace driftbench
