/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_compensator.h"

#include "device/firmware/bridge_bank.h"

void bridge_compensator_stop(struct bridge_compensator *compensator)
{
    compensator->flash = 0;
}

void bridge_compensator_start(struct bridge_compensator *compensator, const struct bridge_flash *flash,
                              uint8_t bank, const struct bridge_table *table, uint16_t sensitivity)
{
    compensator->flash = flash;
    compensator->bank = bank;
    compensator->cell_known = false;
    compensator->table = *table;
    compensator->scale = bridge_scale_of(table, sensitivity);
}

static bool fetch_cell(struct bridge_compensator *compensator, uint32_t cell)
{
    const struct bridge_flash *flash = compensator->flash;
    const uint32_t at = BRIDGE_BANK_IMAGE_AT + BRIDGE_TABLE_VALUES + cell * BRIDGE_TABLE_KNOT_SIZE;
    if (compensator->cell_known && compensator->cell == cell)
        return true;
    compensator->cell = cell;
    compensator->cell_known =
        flash->read(flash->context, compensator->bank, at, compensator->knots, BRIDGE_TABLE_CELL_SIZE);
    return compensator->cell_known;
}

bool bridge_compensator_counts(struct bridge_compensator *compensator, int32_t millic, int32_t counts[3])
{
    struct bridge_place place;
    uint32_t axis;
    if (compensator->flash == 0)
        return false;
    place = bridge_table_locate(&compensator->table, millic);
    if (!fetch_cell(compensator, place.cell))
        return false;
    if (compensator->table.kind == BRIDGE_TABLE_FIXED) {
        int32_t units[3];
        bridge_table_units(place, compensator->knots, units);
        for (axis = 0; axis < 3u; ++axis)
            counts[axis] = bridge_counts_of_units(compensator->scale, units[axis]);
    } else {
        float dps[3];
        bridge_table_dps(place, compensator->knots, dps);
        for (axis = 0; axis < 3u; ++axis)
            counts[axis] = bridge_counts_of_dps(compensator->scale, dps[axis]);
    }
    return true;
}
