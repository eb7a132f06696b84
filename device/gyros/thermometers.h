// Thermometers beside the gyro on the same I2C bus: TMP117 and MCP9808, found by their ids.
//
//   TMP117   16 bits, two's complement, 1/128 C, new every second; reads -256 C until the first is done
//   MCP9808  13 bits, two's complement, 1/16 C, below three alert flags, new every 250 ms
//
// Errors: those of the bus; WrongSensor where something else answers.
// Sources: TI SNOSD82 section 7.6; Microchip DS25095 section 5.1.
#pragma once

#include "device/i2c/i2c_bus.h"

#include <array>
#include <optional>
#include <string_view>

namespace driftbench {

namespace tmp117 {

inline constexpr std::uint8_t kTemperature = 0x00;
inline constexpr std::uint8_t kDeviceId = 0x0F;
inline constexpr std::uint16_t kDeviceIdValue = 0x0117; // below the revision in the upper four bits
inline constexpr std::array<std::uint8_t, 4> kAddresses{0x48, 0x49, 0x4A, 0x4B};

std::optional<double> decodeTemperatureC(std::uint16_t value); // nothing: no conversion is done yet

} // namespace tmp117

namespace mcp9808 {

inline constexpr std::uint8_t kTemperature = 0x05;
inline constexpr std::uint8_t kManufacturerId = 0x06;
inline constexpr std::uint8_t kDeviceId = 0x07;
inline constexpr std::uint16_t kManufacturerIdValue = 0x0054;
inline constexpr std::uint8_t kDeviceIdValue = 0x04; // above the revision in the lower byte
inline constexpr std::array<std::uint8_t, 8> kAddresses{0x18, 0x19, 0x1A, 0x1B, 0x1C, 0x1D, 0x1E, 0x1F};

double decodeTemperatureC(std::uint16_t value);

} // namespace mcp9808

enum class ThermometerModel
{
    Tmp117,
    Mcp9808
};

std::string_view thermometerName(ThermometerModel model); // "TMP117"

class I2cThermometer
{
public:
    // At that address. The bus must outlive the thermometer.
    static Result<I2cThermometer> open(I2cBus &bus, ThermometerModel model, std::uint8_t address);
    // The first that answers, of that model or of any; nothing if none does.
    static Result<std::optional<I2cThermometer>> find(I2cBus &bus,
                                                      std::optional<ThermometerModel> model = {});

    ThermometerModel model() const { return m_model; }
    std::uint8_t address() const { return m_address; }
    // Nothing until the first conversion is done.
    Result<std::optional<double>> temperatureC();

private:
    I2cThermometer(I2cBus &bus, ThermometerModel model, std::uint8_t address)
        : m_bus(&bus), m_model(model), m_address(address)
    {
    }

    I2cBus *m_bus;
    ThermometerModel m_model;
    std::uint8_t m_address;
};

} // namespace driftbench
