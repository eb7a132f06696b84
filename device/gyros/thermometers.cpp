#include "device/gyros/thermometers.h"

namespace driftbench {

namespace {

Result<std::uint16_t> readWord(I2cBus &bus, std::uint8_t address, std::uint8_t reg)
{
    std::array<std::uint8_t, 2> bytes{};
    if (const Status ok = bus.writeThenRead(address, std::array{reg}, bytes); !ok)
        return ok.error();
    return static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
}

Result<bool> answersAs(I2cBus &bus, ThermometerModel model, std::uint8_t address)
{
    if (model == ThermometerModel::Tmp117) {
        const Result<std::uint16_t> id = readWord(bus, address, tmp117::kDeviceId);
        if (!id)
            return id.error();
        return (*id & 0x0FFF) == tmp117::kDeviceIdValue;
    }
    const Result<std::uint16_t> manufacturer = readWord(bus, address, mcp9808::kManufacturerId);
    if (!manufacturer)
        return manufacturer.error();
    const Result<std::uint16_t> id = readWord(bus, address, mcp9808::kDeviceId);
    if (!id)
        return id.error();
    return *manufacturer == mcp9808::kManufacturerIdValue && *id >> 8 == mcp9808::kDeviceIdValue;
}

std::span<const std::uint8_t> addressesOf(ThermometerModel model)
{
    if (model == ThermometerModel::Tmp117)
        return tmp117::kAddresses;
    return mcp9808::kAddresses;
}

} // namespace

std::optional<double> tmp117::decodeTemperatureC(std::uint16_t value)
{
    constexpr std::uint16_t kNotYet = 0x8000;
    if (value == kNotYet)
        return {};
    return static_cast<std::int16_t>(value) / 128.0;
}

double mcp9808::decodeTemperatureC(std::uint16_t value)
{
    const int sixteenths = (value & 0x1FFF) - ((value & 0x1000) != 0 ? 0x2000 : 0);
    return sixteenths / 16.0;
}

std::string_view thermometerName(ThermometerModel model)
{
    return model == ThermometerModel::Tmp117 ? "TMP117" : "MCP9808";
}

Result<I2cThermometer> I2cThermometer::open(I2cBus &bus, ThermometerModel model, std::uint8_t address)
{
    const Result<bool> right = answersAs(bus, model, address);
    if (!right)
        return right.error();
    if (!*right)
        return Error{Errc::WrongSensor, "What answers at I2C address " + hexByte(address) + " on " +
                                            bus.name() + " is no " + std::string(thermometerName(model)) +
                                            "; choose the thermometer that is connected."};
    return I2cThermometer(bus, model, address);
}

Result<std::optional<I2cThermometer>> I2cThermometer::find(I2cBus &bus,
                                                           std::optional<ThermometerModel> wanted)
{
    for (const ThermometerModel model : {ThermometerModel::Tmp117, ThermometerModel::Mcp9808}) {
        if (wanted && *wanted != model)
            continue;
        for (const std::uint8_t address : addressesOf(model)) {
            const Result<I2cThermometer> found = open(bus, model, address);
            if (found)
                return std::optional<I2cThermometer>(*found);
            if (found.error().code != Errc::BusNoAcknowledge && found.error().code != Errc::WrongSensor)
                return found.error();
        }
    }
    return std::optional<I2cThermometer>();
}

Result<std::optional<double>> I2cThermometer::temperatureC()
{
    const bool isTmp117 = m_model == ThermometerModel::Tmp117;
    const Result<std::uint16_t> value =
        readWord(*m_bus, m_address, isTmp117 ? tmp117::kTemperature : mcp9808::kTemperature);
    if (!value)
        return value.error();
    if (isTmp117)
        return tmp117::decodeTemperatureC(*value);
    return std::optional<double>(mcp9808::decodeTemperatureC(*value));
}

} // namespace driftbench
