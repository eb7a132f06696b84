// An I2C bus behind a USB bridge: transfers to 7-bit addresses, in one piece, one at a time.
//
// A transfer that fails is never repeated here: reading a FIFO twice loses samples. The bus is brought back
// to rest before the error is returned, so that the next transfer starts clean.
//
// Errors, one sentence each with the address in hex: BusNoAcknowledge (nothing answers there), BusStuck (a
// line is held low, or the transfer did not end), DeviceUnplugged and DeviceSilent (the bridge),
// DeviceRefused (the bridge did not take a report), DamagedReport (an answer that can't be), InvalidOption
// (address or length outside the limits).
#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace driftbench {

struct I2cLimits
{
    std::size_t longestWrite = 0;         // bytes of one write
    std::size_t longestRead = 0;          // bytes of one read
    std::size_t longestWriteThenRead = 0; // bytes that may be written before a read
    int slowestKHz = 0;
    int fastestKHz = 0;
};

class I2cBus
{
public:
    virtual ~I2cBus() = default;

    virtual const std::string &name() const = 0; // "MCP2221A 0002137645"
    virtual I2cLimits limits() const = 0;

    Status write(std::uint8_t address, std::span<const std::uint8_t> bytes);
    Status read(std::uint8_t address, std::span<std::uint8_t> bytes);
    // With a repeated start between the two: nobody else gets the bus in between.
    Status writeThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                         std::span<std::uint8_t> bytes);

    Status writeRegister(std::uint8_t address, std::uint8_t reg, std::uint8_t value);
    Result<std::uint8_t> readRegister(std::uint8_t address, std::uint8_t reg);

protected:
    I2cBus() = default;
    I2cBus(const I2cBus &) = default;
    I2cBus &operator=(const I2cBus &) = default;

    Error noAcknowledge(std::uint8_t address) const;
    Error stuck(std::uint8_t address) const;
    Error damagedReply(std::uint8_t address) const;

private:
    virtual Status transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes) = 0;
    virtual Status transferRead(std::uint8_t address, std::span<std::uint8_t> bytes) = 0;
    virtual Status transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                         std::span<std::uint8_t> bytes) = 0;
    Status check(std::uint8_t address, std::size_t length, std::size_t limit) const;
};

std::string hexByte(std::uint8_t byte); // "0x6b"

} // namespace driftbench
