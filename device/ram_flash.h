// Two flash banks in memory, as device/firmware/bridge_flash.h wants them, whose power can be cut at a chosen
// operation and which keeps count of what no flash allows: programming a unit twice, or outside the bank.
#pragma once

#include "device/firmware/bridge_flash.h"

#include "engine/base/random.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace driftbench {

// What the operation in which the power went has done.
enum class PowerCut
{
    Before, // nothing
    Torn,   // any bits between nothing and all, and some bytes of noise
    After,  // all
};

class RamFlash
{
public:
    explicit RamFlash(std::uint32_t bankBytes);
    RamFlash(const RamFlash &other);
    RamFlash &operator=(const RamFlash &) = delete;

    const bridge_flash *flash() const { return &m_interface; }

    // The n-th erasure or programming from now on (0: the next) is the last one.
    void cutPowerAt(int operation, PowerCut how, std::uint64_t seed);
    void powerUp();
    bool hasPower() const { return m_power; }

    // Power stays, but the n-th such operation from now on is refused, undone.
    void refuseAt(int operation);
    void refuseReads(bool refuse) { m_refusesReads = refuse; }

    int operations() const { return m_operations; } // erasures and programmings so far
    int violations() const { return m_violations; }

    std::vector<std::uint8_t> &bank(std::size_t index) { return m_banks[index]; }
    // bytes: a whole bank. Units that are not erased count as programmed.
    void restore(std::size_t bank, std::vector<std::uint8_t> bytes);

private:
    enum class Step
    {
        Do,
        Refuse,
        Tear,
    };
    Step next();
    bool erase(std::uint8_t bank);
    bool program(std::uint8_t bank, std::uint32_t offset, const std::uint8_t *unit);
    bool read(std::uint8_t bank, std::uint32_t offset, std::uint8_t *bytes, std::uint32_t count) const;
    void tear(std::uint8_t &byte, std::uint8_t target);

    struct Cut
    {
        int operation;
        PowerCut how;
    };

    std::array<std::vector<std::uint8_t>, 2> m_banks;
    std::array<std::vector<bool>, 2> m_programmed; // units, since the last erasure
    bridge_flash m_interface;
    std::optional<Cut> m_cut;
    std::optional<int> m_refusal;
    Random m_noise{1};
    bool m_power = true;
    bool m_refusesReads = false;
    int m_operations = 0;
    int m_violations = 0;
};

} // namespace driftbench
