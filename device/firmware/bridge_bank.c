/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_bank.h"

#include "device/firmware/bridge_bytes.h"
#include "device/firmware/bridge_crc32.h"

#define HEADER_GENERATION 4u
#define HEADER_BYTES 8u
#define HEADER_IMAGE_CRC 12u
#define HEADER_CRC 16u

#define KNOTS_AT_ONCE 8u

static uint8_t state_of_mark(uint8_t kind)
{
    if (kind == BRIDGE_MARK_COMMITTED)
        return BRIDGE_BANK_COMMITTED;
    if (kind == BRIDGE_MARK_ACTIVATED)
        return BRIDGE_BANK_ACTIVATED;
    return kind == BRIDGE_MARK_REVOKED ? BRIDGE_BANK_REVOKED : BRIDGE_BANK_EMPTY;
}

static void make_mark(uint8_t mark[BRIDGE_FLASH_UNIT], const struct bridge_bank *bank, uint8_t kind,
                      uint32_t slot)
{
    uint8_t bound_to[8];
    mark[0] = kind;
    mark[1] = (uint8_t)(0xFFu - kind);
    bridge_put_u16(mark + 2, (uint16_t)slot);
    bridge_put_u32(bound_to, bank->generation);
    bridge_put_u32(bound_to + 4, bank->crc);
    bridge_put_u32(mark + 4, bridge_crc32(bridge_crc32(0, mark, 4), bound_to, sizeof bound_to));
}

static bool is_whole_mark(const uint8_t mark[BRIDGE_FLASH_UNIT], const struct bridge_bank *bank,
                          uint32_t slot)
{
    uint8_t whole[BRIDGE_FLASH_UNIT];
    if (state_of_mark(mark[0]) == BRIDGE_BANK_EMPTY)
        return false;
    make_mark(whole, bank, mark[0], slot);
    return bridge_equal(mark, whole, BRIDGE_FLASH_UNIT);
}

/* State by the last whole mark; next_mark behind the last slot that is not erased. */
static uint8_t scan_marks(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index)
{
    uint8_t state = BRIDGE_BANK_EMPTY;
    uint8_t mark[BRIDGE_FLASH_UNIT];
    uint32_t slot;
    bank->next_mark = 0;
    for (slot = 0; slot < BRIDGE_BANK_MARKS; ++slot) {
        const uint32_t at = BRIDGE_BANK_MARKS_AT + slot * BRIDGE_FLASH_UNIT;
        const bool readable = flash->read(flash->context, index, at, mark, BRIDGE_FLASH_UNIT);
        if (readable && bridge_all(mark, BRIDGE_FLASH_ERASED, BRIDGE_FLASH_UNIT))
            continue;
        bank->next_mark = slot + 1u;
        if (readable && is_whole_mark(mark, bank, slot))
            state = state_of_mark(mark[0]);
    }
    return state;
}

static bool read_header(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index)
{
    uint8_t bytes[BRIDGE_BANK_HEADER_AT + BRIDGE_BANK_HEADER_SIZE];
    const uint8_t *header = bytes + BRIDGE_BANK_HEADER_AT;
    if (!flash->read(flash->context, index, 0, bytes, sizeof bytes) ||
        !bridge_all(bytes, BRIDGE_FLASH_ERASED, BRIDGE_BANK_HEADER_AT) ||
        bridge_get_u32(header) != BRIDGE_BANK_MAGIC ||
        bridge_get_u32(header + HEADER_CRC) != bridge_crc32(0, header, HEADER_CRC))
        return false;
    bank->generation = bridge_get_u32(header + HEADER_GENERATION);
    bank->bytes = bridge_get_u32(header + HEADER_BYTES);
    bank->crc = bridge_get_u32(header + HEADER_IMAGE_CRC);
    return true;
}

static void forget(struct bridge_bank *bank)
{
    bank->state = BRIDGE_BANK_EMPTY;
    bank->generation = 0;
    bank->bytes = 0;
    bank->crc = 0;
    bank->next_mark = 0;
}

void bridge_bank_scan(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                      struct bridge_sensor sensor)
{
    uint8_t image;
    forget(bank);
    if (!read_header(bank, flash, index)) {
        forget(bank);
        return;
    }
    bank->state = scan_marks(bank, flash, index);
    image = bridge_bank_check_image(flash, index, bank->bytes, bank->crc, sensor, &bank->table);
    if (bank->state == BRIDGE_BANK_EMPTY ||
        (image != BRIDGE_RESULT_OK && image != BRIDGE_RESULT_OTHER_SENSOR))
        forget(bank);
    else if (image == BRIDGE_RESULT_OTHER_SENSOR)
        bank->state = BRIDGE_BANK_FOREIGN;
}

uint8_t bridge_bank_check_image(const struct bridge_flash *flash, uint8_t index, uint32_t bytes, uint32_t crc,
                                struct bridge_sensor sensor, struct bridge_table *table)
{
    uint8_t header[BRIDGE_TABLE_VALUES];
    uint8_t knots[KNOTS_AT_ONCE * BRIDGE_TABLE_KNOT_SIZE];
    uint32_t found_crc;
    uint32_t at = BRIDGE_TABLE_VALUES;
    bool fits;
    if (bytes < BRIDGE_TABLE_VALUES || bytes > flash->bank_bytes - BRIDGE_BANK_IMAGE_AT)
        return BRIDGE_RESULT_BAD_TABLE;
    if (!flash->read(flash->context, index, BRIDGE_BANK_IMAGE_AT, header, sizeof header))
        return BRIDGE_RESULT_FLASH;
    found_crc = bridge_crc32(0, header, sizeof header);
    fits = bridge_table_read(table, header) && bridge_table_bytes(table) == bytes;
    while (at < bytes) {
        const uint32_t count = bytes - at < sizeof knots ? bytes - at : (uint32_t)sizeof knots;
        uint32_t knot;
        if (!flash->read(flash->context, index, BRIDGE_BANK_IMAGE_AT + at, knots, count))
            return BRIDGE_RESULT_FLASH;
        found_crc = bridge_crc32(found_crc, knots, count);
        for (knot = 0; fits && knot < count; knot += BRIDGE_TABLE_KNOT_SIZE)
            fits = bridge_table_knot_fits(table, knots + knot);
        at += count;
    }
    if (found_crc != crc)
        return BRIDGE_RESULT_BAD_CRC;
    if (!fits)
        return BRIDGE_RESULT_BAD_TABLE;
    return bridge_table_is_for(header, sensor.model, sensor.serial) ? BRIDGE_RESULT_OK
                                                                    : BRIDGE_RESULT_OTHER_SENSOR;
}

/* A unit that a cut left half programmed may be the first thing that the next erasure brings back: each
 * attempt takes a unit of its own while there are any. */
static bool retire(const struct bridge_flash *flash, uint8_t index)
{
    static const uint8_t zeros[BRIDGE_FLASH_UNIT] = {0};
    uint8_t unit[BRIDGE_FLASH_UNIT];
    bool retired = false;
    uint32_t i;
    for (i = 0; i < BRIDGE_BANK_RETIRE_UNITS; ++i) {
        const uint32_t at = i * BRIDGE_FLASH_UNIT;
        if (flash->read(flash->context, index, at, unit, sizeof unit) &&
            bridge_all(unit, BRIDGE_FLASH_ERASED, sizeof unit))
            (void)flash->program(flash->context, index, at, zeros);
        else
            retired = true;
        if (flash->read(flash->context, index, at, unit, sizeof unit) &&
            bridge_equal(unit, zeros, sizeof unit))
            return true;
    }
    return retired;
}

uint8_t bridge_bank_erase(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                          struct bridge_sensor sensor)
{
    if (retire(flash, index) && flash->erase(flash->context, index)) {
        forget(bank);
        return BRIDGE_RESULT_OK;
    }
    bridge_bank_scan(bank, flash, index, sensor);
    return BRIDGE_RESULT_FLASH;
}

static bool program_units(const struct bridge_flash *flash, uint8_t index, uint32_t at, const uint8_t *bytes,
                          uint32_t count)
{
    uint8_t unit[BRIDGE_FLASH_UNIT];
    uint32_t done;
    for (done = 0; done < count; done += BRIDGE_FLASH_UNIT) {
        const uint32_t left = count - done;
        bridge_fill(unit, BRIDGE_FLASH_ERASED, BRIDGE_FLASH_UNIT);
        bridge_copy(unit, bytes + done, left < BRIDGE_FLASH_UNIT ? left : BRIDGE_FLASH_UNIT);
        if (!flash->program(flash->context, index, at + done, unit))
            return false;
    }
    return true;
}

uint8_t bridge_bank_program(const struct bridge_flash *flash, uint8_t index, uint32_t offset,
                            const uint8_t *bytes, uint32_t count)
{
    return program_units(flash, index, BRIDGE_BANK_IMAGE_AT + offset, bytes, count) ? BRIDGE_RESULT_OK
                                                                                    : BRIDGE_RESULT_FLASH;
}

uint8_t bridge_bank_commit(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                           uint32_t generation, uint32_t bytes, uint32_t crc, struct bridge_sensor sensor)
{
    uint8_t header[BRIDGE_BANK_HEADER_SIZE];
    uint8_t mark[BRIDGE_FLASH_UNIT];
    bridge_fill(header, BRIDGE_FLASH_ERASED, sizeof header);
    bridge_put_u32(header, BRIDGE_BANK_MAGIC);
    bridge_put_u32(header + HEADER_GENERATION, generation);
    bridge_put_u32(header + HEADER_BYTES, bytes);
    bridge_put_u32(header + HEADER_IMAGE_CRC, crc);
    bridge_put_u32(header + HEADER_CRC, bridge_crc32(0, header, HEADER_CRC));
    bank->generation = generation;
    bank->crc = crc;
    make_mark(mark, bank, BRIDGE_MARK_COMMITTED, 0);
    if (program_units(flash, index, BRIDGE_BANK_HEADER_AT, header, sizeof header))
        (void)program_units(flash, index, BRIDGE_BANK_MARKS_AT, mark, sizeof mark);
    /* What the flash holds now is what it will hold at power-up, whatever it said while being programmed. */
    bridge_bank_scan(bank, flash, index, sensor);
    return bank->state == BRIDGE_BANK_COMMITTED ? BRIDGE_RESULT_OK : BRIDGE_RESULT_FLASH;
}

uint8_t bridge_bank_mark(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                         uint8_t kind)
{
    uint8_t mark[BRIDGE_FLASH_UNIT];
    uint32_t slot = bank->next_mark;
    if (slot >= BRIDGE_BANK_MARKS)
        return BRIDGE_RESULT_FULL;
    /* A slot that was cut off may read as erased and yet refuse: the next one is as good. */
    for (; slot < BRIDGE_BANK_MARKS; ++slot) {
        make_mark(mark, bank, kind, slot);
        (void)program_units(flash, index, BRIDGE_BANK_MARKS_AT + slot * BRIDGE_FLASH_UNIT, mark, sizeof mark);
        bank->state = scan_marks(bank, flash, index);
        if (bank->state == state_of_mark(kind))
            return BRIDGE_RESULT_OK;
    }
    return BRIDGE_RESULT_FLASH;
}
