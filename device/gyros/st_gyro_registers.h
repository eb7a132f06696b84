// Registers of ST's L3GD20H and I3G4250D: what the two have in common, their differences as data, and the
// meaning of the bytes. No bus here.
//
// Rates are int16, little-endian, x y z; rate = count * sensitivity. The FIFO holds 32 samples; a read that
// goes past OUT_Z_H continues at OUT_X_L with the next sample. The die thermometer counts one per degree
// Celsius, downwards, from a point that no document states.
//
// Sources: ST DocID023469 (L3GD20H) and DocID027628 (I3G4250D), register descriptions; AN4506 for the FIFO.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace driftbench::st_gyro {

enum Register : std::uint8_t
{
    WhoAmI = 0x0F,
    Ctrl1 = 0x20,
    Ctrl2 = 0x21,
    Ctrl3 = 0x22,
    Ctrl4 = 0x23,
    Ctrl5 = 0x24,
    OutTemp = 0x26,
    OutXLow = 0x28,
    FifoCtrl = 0x2E,
    FifoSrc = 0x2F,
    LowOdr = 0x39, // L3GD20H only
};

inline constexpr std::uint8_t kAutoIncrement = 0x80; // into the register address of a longer read
inline constexpr std::uint8_t kPowerUpAllAxes = 0x0F;
inline constexpr std::uint8_t kFifoEnable = 0x40; // CTRL5; the high-pass filter's bit beside it stays 0
inline constexpr std::uint8_t kHighPassEnable = 0x10;
inline constexpr std::uint8_t kBlockDataUpdate = 0x80; // CTRL4
inline constexpr std::uint8_t kFifoBypass = 0x00;
inline constexpr std::uint8_t kFifoStream = 0x40;
inline constexpr std::size_t kBytesPerSample = 6;
inline constexpr int kFifoSamples = 32;

struct RangeSetting
{
    double rangeDps;
    double sensitivityDps; // of one count
    std::uint8_t bits;     // into CTRL4
};

struct RateSetting
{
    double rateHz;       // nominal: parts differ by several percent
    std::uint8_t bits;   // into CTRL1
    std::uint8_t lowOdr; // into LOW_ODR
};

struct Description
{
    std::string_view model;
    std::uint8_t whoAmI;
    std::array<std::uint8_t, 2> addresses; // by the level of the address pin
    bool blockDataUpdate;                  // has the bit; without it two halves of a count may differ in age
    bool lowOdr;                           // has the register
    std::span<const RangeSetting> ranges;  // ascending
    std::span<const RateSetting> rates;    // ascending
};

std::span<const Description> descriptions();
const Description *descriptionOf(std::string_view model); // null: unknown
// "L3GD20" for 0xd4; empty for what no known gyro answers.
std::string_view modelOfWhoAmI(std::uint8_t whoAmI);

// The smallest range that holds rangeDps, and the lowest data rate that is not below rateHz.
std::optional<RangeSetting> rangeFor(const Description &description, double rangeDps);
std::optional<RateSetting> rateFor(const Description &description, double rateHz);

struct FifoState
{
    int samples = 0; // 0..32 that wait
    bool full = false;
};

FifoState decodeFifoState(std::uint8_t fifoSrc);

using Counts = std::array<std::int16_t, 3>;

// Sample i of a burst that began at OUT_X_L; bytes must hold it.
Counts decodeCounts(std::span<const std::uint8_t> bytes, std::size_t sample);
bool saturated(const Counts &counts);
int decodeDieCount(std::uint8_t outTemp);

} // namespace driftbench::st_gyro
