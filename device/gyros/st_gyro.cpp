#include "device/gyros/st_gyro.h"

#include "engine/base/text.h"

namespace driftbench {

using namespace st_gyro;

namespace {

Error wrongSensor(const std::string &bus, std::uint8_t address, std::uint8_t found, const std::string &wanted)
{
    const std::string_view model = modelOfWhoAmI(found);
    return {Errc::WrongSensor, "At I2C address " + hexByte(address) + " on " + bus + " answers " +
                                   (model.empty() ? "an unknown device" : "an " + std::string(model)) +
                                   " (WHO_AM_I " + hexByte(found) + ") instead of " + wanted +
                                   "; choose the sensor that is connected."};
}

std::string withWhoAmI(const Description &description)
{
    return "an " + std::string(description.model) + " (" + hexByte(description.whoAmI) + ")";
}

} // namespace

Result<StGyro> StGyro::open(I2cBus &bus, const Description &description, std::uint8_t address)
{
    const Result<std::uint8_t> found = bus.readRegister(address, WhoAmI);
    if (!found)
        return found.error();
    if (*found != description.whoAmI)
        return wrongSensor(bus.name(), address, *found, withWhoAmI(description));
    return StGyro(bus, description, address);
}

Result<StGyro> StGyro::find(I2cBus &bus)
{
    std::string tried;
    Result<StGyro> best = Error{Errc::BusNoAcknowledge, ""};
    for (const Description &description : descriptions()) {
        for (const std::uint8_t address : description.addresses) {
            const Result<StGyro> gyro = open(bus, description, address);
            if (gyro ||
                (gyro.error().code != Errc::BusNoAcknowledge && gyro.error().code != Errc::WrongSensor))
                return gyro;
            tried += (tried.empty() ? "" : ", ") + hexByte(address);
            if (gyro.error().code == Errc::WrongSensor)
                best = gyro;
        }
    }
    if (best.error().code == Errc::WrongSensor)
        return best;
    return Error{Errc::BusNoAcknowledge, "No gyro answers on " + bus.name() + " at the I2C addresses " +
                                             tried + "; check its power and its wiring."};
}

Status StGyro::setUp(const StGyroOptions &options)
{
    const std::optional<RangeSetting> range = rangeFor(*m_description, options.rangeDps);
    const std::optional<RateSetting> rate = rateFor(*m_description, options.rateHz);
    const std::string model(m_description->model);
    if (!range)
        return Error{Errc::InvalidOption, "An " + model + " has no range of " + shortest(options.rangeDps) +
                                              " dps; choose at most " +
                                              shortest(m_description->ranges.back().rangeDps) + "."};
    if (!rate)
        return Error{Errc::InvalidOption, "An " + model + " has no data rate of " + shortest(options.rateHz) +
                                              " Hz; choose at most " +
                                              shortest(m_description->rates.back().rateHz) + "."};
    m_range = *range;
    m_rate = *rate;

    const std::uint8_t blockDataUpdate = m_description->blockDataUpdate ? kBlockDataUpdate : std::uint8_t(0);
    if (const Status ok = writeAndCheck(Ctrl1, 0); !ok) // rates are changed while it rests
        return ok;
    if (const Status ok = writeAndCheck(Ctrl2, 0); !ok)
        return ok;
    if (const Status ok = writeAndCheck(Ctrl3, 0); !ok)
        return ok;
    if (const Status ok = writeAndCheck(Ctrl4, blockDataUpdate | m_range.bits); !ok)
        return ok;
    if (const Status ok = writeAndCheck(Ctrl5, kFifoEnable); !ok)
        return ok;
    if (m_description->lowOdr) {
        if (const Status ok = writeAndCheck(LowOdr, m_rate.lowOdr); !ok)
            return ok;
    }
    if (const Status ok = writeAndCheck(Ctrl1, m_rate.bits | kPowerUpAllAxes); !ok)
        return ok;
    return restartFifo();
}

Status StGyro::restartFifo()
{
    if (const Status ok = writeAndCheck(FifoCtrl, kFifoBypass); !ok)
        return ok;
    return writeAndCheck(FifoCtrl, kFifoStream);
}

Result<FifoState> StGyro::fifoState()
{
    const Result<std::uint8_t> src = m_bus->readRegister(m_address, FifoSrc);
    if (!src)
        return src.error();
    return decodeFifoState(*src);
}

Status StGyro::readFifo(std::span<std::uint8_t> bytes)
{
    const std::uint8_t reg = OutXLow | kAutoIncrement;
    return m_bus->writeThenRead(m_address, {&reg, 1}, bytes);
}

Result<int> StGyro::dieCount()
{
    const Result<std::uint8_t> count = m_bus->readRegister(m_address, OutTemp);
    if (!count)
        return count.error();
    return decodeDieCount(*count);
}

Status StGyro::writeAndCheck(std::uint8_t reg, std::uint8_t value)
{
    if (const Status ok = m_bus->writeRegister(m_address, reg, value); !ok)
        return ok;
    const Result<std::uint8_t> kept = m_bus->readRegister(m_address, reg);
    if (!kept)
        return kept.error();
    if (*kept != value)
        return Error{Errc::DeviceRefused, "Register " + hexByte(reg) + " of the gyro at I2C address " +
                                              hexByte(m_address) + " reads " + hexByte(*kept) + " after " +
                                              hexByte(value) + " was written; switch the sensor off and on."};
    return {};
}

} // namespace driftbench
