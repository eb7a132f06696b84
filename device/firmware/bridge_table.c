/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_table.h"

#include "device/firmware/bridge_bytes.h"

static float float_of_bits(uint32_t bits)
{
    union {
        uint32_t bits;
        float value;
    } both;
    both.bits = bits;
    return both.value;
}

uint32_t bridge_ratio(uint32_t numerator, uint32_t denominator, uint8_t *bits)
{
    uint32_t quotient = numerator / denominator;
    uint32_t remainder = numerator % denominator;
    *bits = 0;
    while (quotient < 0x40000000u) {
        remainder *= 2u;
        quotient *= 2u;
        if (remainder >= denominator) {
            remainder -= denominator;
            ++quotient;
        }
        ++*bits;
    }
    return quotient;
}

/* The only reciprocal and shift that the grid allows: anything else is damage or another arithmetic. */
static bool fixed_fields_fit(struct bridge_table *table, const uint8_t *header, uint32_t cells, uint32_t span)
{
    uint8_t bits;
    const uint32_t reciprocal = bridge_ratio(cells, span, &bits);
    table->reciprocal = bridge_get_u32(header + BRIDGE_TABLE_RECIPROCAL);
    return table->reciprocal == reciprocal && bits == table->shift + 16u &&
           table->fraction <= BRIDGE_TABLE_MOST_FRACTION;
}

static bool float_fields_fit(struct bridge_table *table, const uint8_t *header, uint32_t cells, uint32_t span)
{
    const float expected = 1000.0f * (float)cells;
    float reached;
    table->first_degrees = (float)table->first_millic / 1000.0f;
    table->cells_per_degree = float_of_bits(bridge_get_u32(header + BRIDGE_TABLE_RECIPROCAL));
    reached = table->cells_per_degree * (float)span;
    /* A few roundings to 24 bits; also refuses what is no number. */
    return reached > expected * 0.999999f && reached < expected * 1.000001f && table->shift == 0u &&
           table->fraction == 0u;
}

bool bridge_table_read(struct bridge_table *table, const uint8_t header[BRIDGE_TABLE_VALUES])
{
    uint32_t span;
    uint32_t cells;
    table->kind = header[BRIDGE_TABLE_KIND];
    table->axes = header[BRIDGE_TABLE_AXES];
    table->thermometer = header[BRIDGE_TABLE_THERMOMETER];
    table->shift = header[BRIDGE_TABLE_SHIFT];
    table->fraction = header[BRIDGE_TABLE_FRACTION];
    table->first_millic = bridge_get_i32(header + BRIDGE_TABLE_FIRST);
    table->last_millic = bridge_get_i32(header + BRIDGE_TABLE_LAST);
    table->knots = bridge_get_u32(header + BRIDGE_TABLE_KNOTS);
    table->reciprocal = 0;
    table->first_degrees = 0.0f;
    table->cells_per_degree = 0.0f;
    if (bridge_get_u32(header + BRIDGE_TABLE_MAGIC) != BRIDGE_TABLE_MAGIC_VALUE ||
        header[BRIDGE_TABLE_VERSION] != BRIDGE_TABLE_VERSION_VALUE || table->axes == 0u || table->axes > 7u ||
        table->thermometer > BRIDGE_THERMOMETER_EXTERNAL || table->knots < 2u ||
        table->knots > BRIDGE_TABLE_MOST_KNOTS || table->last_millic <= table->first_millic)
        return false;
    span = (uint32_t)table->last_millic - (uint32_t)table->first_millic;
    cells = table->knots - 1u;
    if (span > BRIDGE_TABLE_LARGEST_SPAN || span < cells)
        return false;
    if (table->kind == BRIDGE_TABLE_FIXED)
        return fixed_fields_fit(table, header, cells, span);
    return table->kind == BRIDGE_TABLE_FLOAT && float_fields_fit(table, header, cells, span);
}

bool bridge_table_is_for(const uint8_t header[BRIDGE_TABLE_VALUES], const uint8_t model[BRIDGE_MODEL_SIZE],
                         const uint8_t serial[BRIDGE_SERIAL_SIZE])
{
    return bridge_equal(header + BRIDGE_TABLE_MODEL, model, BRIDGE_MODEL_SIZE) &&
           bridge_equal(header + BRIDGE_TABLE_SERIAL, serial, BRIDGE_SERIAL_SIZE);
}

uint32_t bridge_table_bytes(const struct bridge_table *table)
{
    return BRIDGE_TABLE_VALUES + BRIDGE_TABLE_KNOT_SIZE * table->knots;
}

static bool value_fits(const struct bridge_table *table, uint32_t bits, bool compensated)
{
    const int32_t value = table->kind == BRIDGE_TABLE_FIXED && bits >= 0x80000000u
                              ? (int32_t)(bits - 0x80000000u) + INT32_MIN
                              : (int32_t)(bits & 0x7FFFFFFFu);
    if (!compensated)
        return value == 0;
    /* Floats without their sign are in the order of their bits; those of 2^30 are 0x4E800000. */
    if (table->kind == BRIDGE_TABLE_FLOAT)
        return value < 0x4E800000;
    return value > -BRIDGE_TABLE_VALUE_LIMIT && value < BRIDGE_TABLE_VALUE_LIMIT;
}

bool bridge_table_knot_fits(const struct bridge_table *table, const uint8_t knot[BRIDGE_TABLE_KNOT_SIZE])
{
    uint32_t axis;
    for (axis = 0; axis < 3u; ++axis) {
        if (!value_fits(table, bridge_get_u32(knot + 4u * axis), ((table->axes >> axis) & 1u) != 0u))
            return false;
    }
    return true;
}

bool bridge_table_covers(const struct bridge_table *table, int32_t millic)
{
    return millic >= table->first_millic && millic <= table->last_millic;
}

static struct bridge_place locate_fixed(const struct bridge_table *table, int32_t millic)
{
    struct bridge_place place = {0, 0, 0.0f};
    const int32_t above = millic > table->first_millic ? millic : table->first_millic;
    const int32_t held = above < table->last_millic ? above : table->last_millic;
    const uint32_t offset = (uint32_t)held - (uint32_t)table->first_millic;
    /* Below 2^31: at most 32767 cells and 2^-16 of one more. */
    const uint32_t position = (uint32_t)(((uint64_t)offset * table->reciprocal) >> table->shift);
    const uint32_t floored = position >> 16;
    place.cell = floored < table->knots - 2u ? floored : table->knots - 2u;
    place.fixed_fraction = (int32_t)(position - (place.cell << 16));
    return place;
}

static struct bridge_place locate_float(const struct bridge_table *table, int32_t millic)
{
    struct bridge_place place = {0, 0, 0.0f};
    const float last_position = (float)(table->knots - 1u);
    const float last_cell = last_position - 1.0f;
    const float degrees = (float)millic / 1000.0f;
    const float position = (degrees - table->first_degrees) * table->cells_per_degree;
    const float above = position > 0.0f ? position : 0.0f;
    const float held = above < last_position ? above : last_position;
    place.cell = (uint32_t)(held < last_cell ? held : last_cell);
    place.fraction = held - (float)place.cell;
    return place;
}

struct bridge_place bridge_table_locate(const struct bridge_table *table, int32_t millic)
{
    return table->kind == BRIDGE_TABLE_FIXED ? locate_fixed(table, millic) : locate_float(table, millic);
}

void bridge_table_units(struct bridge_place place, const uint8_t cell[BRIDGE_TABLE_CELL_SIZE],
                        int32_t units[3])
{
    uint32_t axis;
    for (axis = 0; axis < 3u; ++axis) {
        const int32_t low = bridge_get_i32(cell + 4u * axis);
        const int32_t high = bridge_get_i32(cell + BRIDGE_TABLE_KNOT_SIZE + 4u * axis);
        const int64_t product = (int64_t)(high - low) * place.fixed_fraction;
        /* 2^49 is added so that no negative number is shifted, and 2^33 taken away after it. */
        const uint64_t raised = (uint64_t)(product + 32768 + INT64_C(0x2000000000000));
        units[axis] = (int32_t)(low + ((int64_t)(raised >> 16) - INT64_C(0x200000000)));
    }
}

void bridge_table_dps(struct bridge_place place, const uint8_t cell[BRIDGE_TABLE_CELL_SIZE], float dps[3])
{
    uint32_t axis;
    for (axis = 0; axis < 3u; ++axis) {
        const float low = float_of_bits(bridge_get_u32(cell + 4u * axis));
        const float slope = float_of_bits(bridge_get_u32(cell + BRIDGE_TABLE_KNOT_SIZE + 4u * axis)) - low;
        dps[axis] = low + place.fraction * slope;
    }
}
