/* SPDX-License-Identifier: MIT
 *
 * Runs the firmware core on the emulated board: reports and temperatures from the file `cases`, what came of
 * them into the file `results`, where a test compares it with the same core and the engine on the host.
 *
 *   cases    u32 number of set reports, the reports, u32 number of samples, i32 millidegrees of each
 *   results  u8 result of each report
 *            per sample 3 x u32 tde (units or bits of float32), 3 x i32 counts to take off
 *            u32 number of input reports, the reports
 *            u32 samples measured, then SysTick ticks for: looking the table up, the counts as well, the
 *            whole way of a sample into a report; u32 bytes of struct bridge_device
 */
#include "device/firmware/bridge_device.h"
#include "semihosting.h"

#include "device/firmware/bridge_bytes.h"

#define BANK_BYTES 65536u
#define MOST_SAMPLES 65536u
#define RING_SIZE 16u
#define MEASURED 1000u
#define CELL_OFFSET (BRIDGE_BANK_IMAGE_AT + BRIDGE_TABLE_VALUES)

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010u)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xE000E014u)
#define SYSTICK_CURRENT (*(volatile uint32_t *)0xE000E018u)
#define SYSTICK_MASK 0xFFFFFFu

static const struct bridge_identity identity = {
    {1, 0, 0}, BRIDGE_CAN_EXTERNAL | BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT,
    "L3GD20H", "SIM-0001",
    1000,      1000000,
    3,         {{245, 875}, {500, 1750}, {2000, 7000}, {0, 0}}};

/* A board's flash is a peripheral; this one is memory, which is all that the core can tell. */
static uint8_t banks[BRIDGE_BANKS][BANK_BYTES];

static struct bridge_device device;
static bridge_report ring[RING_SIZE];
static int32_t temperatures[MOST_SAMPLES];
static uint32_t count;
static uint32_t samples_made;

static bool erase_bank(void *context, uint8_t bank)
{
    (void)context;
    bridge_fill(banks[bank], BRIDGE_FLASH_ERASED, BANK_BYTES);
    return true;
}

static bool program_unit(void *context, uint8_t bank, uint32_t offset, const uint8_t *unit)
{
    (void)context;
    bridge_copy(banks[bank] + offset, unit, BRIDGE_FLASH_UNIT);
    return true;
}

static bool read_bank(void *context, uint8_t bank, uint32_t offset, uint8_t *bytes, uint32_t bytes_count)
{
    (void)context;
    bridge_copy(bytes, banks[bank] + offset, bytes_count);
    return true;
}

static const struct bridge_flash flash = {0, BANK_BYTES, erase_bank, program_unit, read_bank};

/* Counts that any host can make up as well. */
static struct bridge_sample next_sample(int32_t millic)
{
    struct bridge_sample sample;
    uint32_t axis;
    sample.time_us = samples_made * 1000u;
    for (axis = 0; axis < 3u; ++axis)
        sample.counts[axis] = (int16_t)(uint16_t)(samples_made * (7919u + 1000u * axis));
    sample.die_valid = true;
    sample.external_valid = false;
    sample.die_millic = millic;
    sample.external_millic = 0;
    ++samples_made;
    return sample;
}

static bool set_reports(int32_t cases, int32_t results)
{
    uint8_t report[BRIDGE_REPORT_SIZE];
    uint32_t reports;
    if (!semihosting_read(cases, &reports, sizeof reports))
        return false;
    for (; reports > 0u; --reports) {
        uint8_t result;
        if (!semihosting_read(cases, report, sizeof report))
            return false;
        result = bridge_device_set(&device, report, sizeof report);
        if (!semihosting_write(results, &result, 1))
            return false;
    }
    return true;
}

static void look_up(const struct bridge_table *table, int32_t millic, uint32_t tde[3], int32_t counts[3])
{
    const struct bridge_place place = bridge_table_locate(table, millic);
    const uint8_t *cell = banks[device.store.active] + CELL_OFFSET + place.cell * BRIDGE_TABLE_KNOT_SIZE;
    const struct bridge_scale scale = device.stream.compensator.scale;
    uint32_t axis;
    if (table->kind == BRIDGE_TABLE_FIXED) {
        bridge_table_units(place, cell, (int32_t *)tde);
        for (axis = 0; counts != 0 && axis < 3u; ++axis)
            counts[axis] = bridge_counts_of_units(scale, (int32_t)tde[axis]);
    } else {
        union {
            float dps[3];
            uint32_t bits[3];
        } both;
        bridge_table_dps(place, cell, both.dps);
        for (axis = 0; axis < 3u; ++axis) {
            tde[axis] = both.bits[axis];
            if (counts != 0)
                counts[axis] = bridge_counts_of_dps(scale, both.dps[axis]);
        }
    }
}

static bool look_all_up(int32_t results)
{
    const struct bridge_table *table = &device.store.banks[device.store.active].table;
    uint32_t i;
    for (i = 0; i < count; ++i) {
        struct
        {
            uint32_t tde[3];
            int32_t counts[3];
        } record;
        look_up(table, temperatures[i], record.tde, record.counts);
        if (!semihosting_write(results, &record, sizeof record))
            return false;
    }
    return true;
}

static bool stream_all(int32_t results)
{
    static bridge_report reports[MOST_SAMPLES / BRIDGE_SAMPLES_PER_REPORT + 1u];
    uint32_t made = 0;
    uint32_t i;
    for (i = 0; i < count; ++i) {
        const struct bridge_sample sample = next_sample(temperatures[i]);
        bridge_device_sample(&device, &sample);
        while (bridge_device_take(&device, reports[made]))
            ++made;
    }
    return semihosting_write(results, &made, sizeof made) &&
           semihosting_write(results, reports, made * BRIDGE_REPORT_SIZE);
}

static uint32_t ticks_since(uint32_t start)
{
    return (start - SYSTICK_CURRENT) & SYSTICK_MASK; /* it counts down */
}

static uint32_t measured_temperature(uint32_t i)
{
    return i % count;
}

static bool measure(int32_t results)
{
    const struct bridge_table *table = &device.store.banks[device.store.active].table;
    uint32_t record[5] = {MEASURED, 0, 0, 0, sizeof device};
    uint32_t start;
    uint32_t i;
    uint32_t tde[3];
    int32_t counts[3];
    uint8_t report[BRIDGE_REPORT_SIZE];
    SYSTICK_RELOAD = SYSTICK_MASK;
    SYSTICK_CURRENT = 0;
    SYSTICK_CONTROL = 5u; /* processor clock, no interrupt */
    start = SYSTICK_CURRENT;
    for (i = 0; i < MEASURED; ++i)
        look_up(table, temperatures[measured_temperature(i)], tde, 0);
    record[1] = ticks_since(start);
    start = SYSTICK_CURRENT;
    for (i = 0; i < MEASURED; ++i)
        look_up(table, temperatures[measured_temperature(i)], tde, counts);
    record[2] = ticks_since(start);
    start = SYSTICK_CURRENT;
    for (i = 0; i < MEASURED; ++i) {
        const struct bridge_sample sample = next_sample(temperatures[measured_temperature(i)]);
        bridge_device_sample(&device, &sample);
        (void)bridge_device_take(&device, report);
    }
    record[3] = ticks_since(start);
    return semihosting_write(results, record, sizeof record);
}

int main(void)
{
    const int32_t cases = semihosting_open_to_read("cases", 5);
    const int32_t results = semihosting_open_to_write("results", 7);
    uint32_t bank;
    bool ok;
    if (cases < 0 || results < 0)
        return 1;
    for (bank = 0; bank < BRIDGE_BANKS; ++bank)
        (void)erase_bank(0, (uint8_t)bank);
    bridge_device_start(&device, &identity, &flash, ring, RING_SIZE);
    ok = set_reports(cases, results) && semihosting_read(cases, &count, sizeof count) && count > 0u &&
         count <= MOST_SAMPLES && semihosting_read(cases, temperatures, count * sizeof temperatures[0]) &&
         device.store.active != BRIDGE_NO_BANK && look_all_up(results) && stream_all(results) &&
         measure(results);
    semihosting_close(results);
    return ok ? 0 : 1;
}
