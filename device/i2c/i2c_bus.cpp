#include "device/i2c/i2c_bus.h"

#include <array>

namespace driftbench {

namespace {

// Above and below lie addresses that the I2C specification reserves.
constexpr std::uint8_t kLowestAddress = 0x08;
constexpr std::uint8_t kHighestAddress = 0x77;

} // namespace

Status I2cBus::write(std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    if (const Status ok = check(address, bytes.size(), limits().longestWrite); !ok)
        return ok;
    return transferWrite(address, bytes);
}

Status I2cBus::read(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    if (const Status ok = check(address, bytes.size(), limits().longestRead); !ok)
        return ok;
    return transferRead(address, bytes);
}

Status I2cBus::writeThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                             std::span<std::uint8_t> bytes)
{
    if (const Status ok = check(address, written.size(), limits().longestWriteThenRead); !ok)
        return ok;
    if (const Status ok = check(address, bytes.size(), limits().longestRead); !ok)
        return ok;
    return transferWriteThenRead(address, written, bytes);
}

Status I2cBus::writeRegister(std::uint8_t address, std::uint8_t reg, std::uint8_t value)
{
    return write(address, std::array{reg, value});
}

Result<std::uint8_t> I2cBus::readRegister(std::uint8_t address, std::uint8_t reg)
{
    std::array<std::uint8_t, 1> value{};
    if (const Status ok = writeThenRead(address, std::array{reg}, value); !ok)
        return ok.error();
    return value[0];
}

Error I2cBus::noAcknowledge(std::uint8_t address) const
{
    return {Errc::BusNoAcknowledge, "Nothing answers at I2C address " + hexByte(address) + " on " + name() +
                                        "; check the power, the wiring and the address pin of the sensor."};
}

Error I2cBus::stuck(std::uint8_t address) const
{
    return {Errc::BusStuck, "The I2C bus of " + name() + " is stuck in a transfer with address " +
                                hexByte(address) +
                                "; check the pull-up resistors, then switch the sensor off and on."};
}

Error I2cBus::damagedReply(std::uint8_t address) const
{
    return {Errc::DamagedReport, "An answer of " + name() + " in a transfer with I2C address " +
                                     hexByte(address) + " can't be; no other program may use the bridge."};
}

Status I2cBus::check(std::uint8_t address, std::size_t length, std::size_t limit) const
{
    if (address < kLowestAddress || address > kHighestAddress)
        return Error{Errc::InvalidOption, "I2C address " + hexByte(address) + " lies outside " +
                                              hexByte(kLowestAddress) + " to " + hexByte(kHighestAddress) +
                                              "."};
    if (length < 1 || length > limit)
        return Error{Errc::InvalidOption,
                     "A transfer of " + std::to_string(length) + " bytes to I2C address " + hexByte(address) +
                         " is not possible; " + name() + " takes 1 to " + std::to_string(limit) + "."};
    return {};
}

std::string hexByte(std::uint8_t byte)
{
    constexpr char kDigits[] = "0123456789abcdef";
    return {'0', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
}

} // namespace driftbench
