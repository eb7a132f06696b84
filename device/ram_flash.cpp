#include "device/ram_flash.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace driftbench {

RamFlash::RamFlash(std::uint32_t bankBytes)
{
    for (std::size_t bank = 0; bank < m_banks.size(); ++bank) {
        m_banks[bank].assign(bankBytes, BRIDGE_FLASH_ERASED);
        m_programmed[bank].assign(bankBytes / BRIDGE_FLASH_UNIT, false);
    }
    m_interface.context = this;
    m_interface.bank_bytes = bankBytes;
    m_interface.erase = [](void *self, std::uint8_t bank) {
        return static_cast<RamFlash *>(self)->erase(bank);
    };
    m_interface.program = [](void *self, std::uint8_t bank, std::uint32_t offset, const std::uint8_t *unit) {
        return static_cast<RamFlash *>(self)->program(bank, offset, unit);
    };
    m_interface.read = [](void *self, std::uint8_t bank, std::uint32_t offset, std::uint8_t *bytes,
                          std::uint32_t count) {
        return static_cast<RamFlash *>(self)->read(bank, offset, bytes, count);
    };
}

RamFlash::RamFlash(const RamFlash &other)
    : m_banks(other.m_banks)
    , m_programmed(other.m_programmed)
    , m_interface(other.m_interface)
    , m_operations(other.m_operations)
    , m_violations(other.m_violations)
{
    m_interface.context = this;
}

void RamFlash::restore(std::size_t bank, std::vector<std::uint8_t> bytes)
{
    assert(bytes.size() == m_banks[bank].size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] != BRIDGE_FLASH_ERASED)
            m_programmed[bank][i / BRIDGE_FLASH_UNIT] = true;
    }
    m_banks[bank] = std::move(bytes);
}

void RamFlash::cutPowerAt(int operation, PowerCut how, std::uint64_t seed)
{
    m_cut = Cut{m_operations + operation, how};
    m_noise = Random(seed);
}

void RamFlash::refuseAt(int operation)
{
    m_refusal = m_operations + operation;
}

void RamFlash::powerUp()
{
    m_power = true;
    m_cut.reset();
    m_refusal.reset();
}

RamFlash::Step RamFlash::next()
{
    const int operation = m_operations++;
    if (!m_power || m_refusal == operation)
        return Step::Refuse;
    if (m_cut && m_cut->operation == operation) {
        m_power = false;
        return m_cut->how == PowerCut::Before ? Step::Refuse
               : m_cut->how == PowerCut::Torn ? Step::Tear
                                              : Step::Do;
    }
    return Step::Do;
}

void RamFlash::tear(std::uint8_t &byte, std::uint8_t target)
{
    const auto bits = static_cast<std::uint8_t>(m_noise.bits());
    switch (m_noise.below(4)) {
    case 0:
        break;
    case 1:
        byte = target;
        break;
    case 2:
        byte = static_cast<std::uint8_t>((byte & bits) | (target & ~bits));
        break;
    default:
        byte = bits;
    }
}

bool RamFlash::erase(std::uint8_t bank)
{
    const Step step = next();
    if (step == Step::Refuse)
        return false;
    std::vector<std::uint8_t> &bytes = m_banks.at(bank);
    if (step == Step::Do) {
        std::fill(bytes.begin(), bytes.end(), BRIDGE_FLASH_ERASED);
        m_programmed[bank].assign(m_programmed[bank].size(), false);
        return m_power;
    }
    // Some erasures get far and some hardly begin: most bytes as they end, as they were, or anything.
    const std::uint64_t reach = m_noise.below(17);
    for (std::uint8_t &byte : bytes) {
        if (m_noise.below(16) < reach)
            tear(byte, BRIDGE_FLASH_ERASED);
    }
    m_programmed[bank].assign(m_programmed[bank].size(), true);
    return false;
}

bool RamFlash::program(std::uint8_t bank, std::uint32_t offset, const std::uint8_t *unit)
{
    const Step step = next();
    std::vector<std::uint8_t> &bytes = m_banks.at(bank);
    if (offset % BRIDGE_FLASH_UNIT != 0 || offset + BRIDGE_FLASH_UNIT > bytes.size()) {
        ++m_violations;
        return false;
    }
    const std::size_t index = offset / BRIDGE_FLASH_UNIT;
    if (step == Step::Refuse)
        return false;
    if (m_programmed[bank][index]) {
        // The flash refuses, which is allowed to happen only where a cut left no trace in the unit.
        if (std::any_of(bytes.begin() + offset, bytes.begin() + offset + BRIDGE_FLASH_UNIT,
                        [](std::uint8_t byte) { return byte != BRIDGE_FLASH_ERASED; }))
            ++m_violations;
        return false;
    }
    m_programmed[bank][index] = true;
    for (std::uint32_t i = 0; i < BRIDGE_FLASH_UNIT; ++i) {
        if (step == Step::Tear)
            tear(bytes[offset + i], unit[i]);
        else
            bytes[offset + i] = unit[i];
    }
    return m_power;
}

bool RamFlash::read(std::uint8_t bank, std::uint32_t offset, std::uint8_t *bytes, std::uint32_t count) const
{
    const std::vector<std::uint8_t> &from = m_banks.at(bank);
    if (!m_power || m_refusesReads || offset > from.size() || count > from.size() - offset)
        return false;
    std::memcpy(bytes, from.data() + offset, count);
    return true;
}

} // namespace driftbench
