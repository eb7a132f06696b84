#include "support/thermometer_models.h"

#include <cmath>

namespace driftbench::test {

double WordRegisterModel::convertedS(double conversionS) const
{
    return m_poweredS + std::floor((m_clock.nowS() - m_poweredS) / conversionS) * conversionS;
}

void WordRegisterModel::point(std::uint8_t reg)
{
    m_register = reg;
    m_low = false;
}

bool WordRegisterModel::writeNext(std::uint8_t)
{
    return true;
}

std::uint8_t WordRegisterModel::readNext()
{
    if (!m_low)
        m_word = word(m_register);
    const auto byte = static_cast<std::uint8_t>(m_low ? m_word & 0xFF : m_word >> 8);
    m_low = !m_low;
    return byte;
}

std::uint16_t Tmp117Model::word(std::uint8_t reg) const
{
    constexpr double kConversionS = 1.0;
    switch (reg) {
    case 0x00: {
        if (!converted(kConversionS))
            return 0x8000;
        const double counts = std::round(temperatureC(convertedS(kConversionS)) / 0.0078125);
        return static_cast<std::uint16_t>(static_cast<std::int16_t>(counts));
    }
    case 0x01:
        return 0x0220;
    case 0x0F:
        return 0x1117; // revision 1
    default:
        return 0;
    }
}

std::uint16_t Mcp9808Model::word(std::uint8_t reg) const
{
    constexpr double kConversionS = 0.25;
    switch (reg) {
    case 0x05: {
        const double counts = std::round(temperatureC(convertedS(kConversionS)) / 0.0625);
        const auto bits = static_cast<std::uint16_t>(static_cast<int>(counts) & 0x1FFF);
        return static_cast<std::uint16_t>(bits | (counts > 0.0 ? 0x4000 : 0x0000)); // above the upper limit 0
    }
    case 0x06:
        return 0x0054;
    case 0x07:
        return 0x0400;
    default:
        return 0;
    }
}

} // namespace driftbench::test
