/* SPDX-License-Identifier: MIT
 *
 * A compensation table in the bytes of its image (engine/exports/device_image_layout.h): is it one, and what
 * is the temperature drift error (tde) at a temperature? The functions see 56 bytes of header and the 24
 * bytes of one cell's two knots; where those come from is the caller's affair.
 *
 * Fixed point, in integers, for a temperature t in millidegrees:
 *   t = clamp(t, first, last),  p = ((t - first) * reciprocal) >> shift      64-bit product
 *   cell = min(p >> 16, n - 2),  f = p - (cell << 16)
 *   tde = low + floor(((high - low) * f + 32768) / 65536)                    units of 2^-fraction dps
 * float32, every operation rounded to float32, no product contracted with a sum:
 *   T = (float)t / 1000,  p = (T - first) * cells_per_degree,  p = min(max(p, 0), n - 1)
 *   cell = min(floor(p), n - 2),  f = p - cell,  tde = low + f * (high - low)
 */
#ifndef DRIFTBENCH_BRIDGE_TABLE_H
#define DRIFTBENCH_BRIDGE_TABLE_H

#include "engine/exports/device_image_layout.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BRIDGE_TABLE_CELL_SIZE (2u * BRIDGE_TABLE_KNOT_SIZE)

struct bridge_table
{
    uint8_t kind;
    uint8_t axes;
    uint8_t thermometer;
    uint8_t shift;    /* fixed */
    uint8_t fraction; /* fixed */
    int32_t first_millic;
    int32_t last_millic;
    uint32_t knots;
    uint32_t reciprocal;    /* fixed */
    float first_degrees;    /* float */
    float cells_per_degree; /* float */
};

struct bridge_place
{
    uint32_t cell;
    int32_t fixed_fraction; /* 0 .. 65536, fixed */
    float fraction;         /* 0 .. 1, float */
};

/* False: the header is none, is of a newer version, or contradicts itself. Then the table must not be used.
 */
bool bridge_table_read(struct bridge_table *table, const uint8_t header[BRIDGE_TABLE_VALUES]);

bool bridge_table_is_for(const uint8_t header[BRIDGE_TABLE_VALUES], const uint8_t model[BRIDGE_MODEL_SIZE],
                         const uint8_t serial[BRIDGE_SERIAL_SIZE]);

uint32_t bridge_table_bytes(const struct bridge_table *table);

/* Are the values of this knot below the limit, and zero on an axis that is not compensated? */
bool bridge_table_knot_fits(const struct bridge_table *table, const uint8_t knot[BRIDGE_TABLE_KNOT_SIZE]);

bool bridge_table_covers(const struct bridge_table *table, int32_t millic);

struct bridge_place bridge_table_locate(const struct bridge_table *table, int32_t millic);

/* cell: the knots place.cell and place.cell + 1 of the image. */
void bridge_table_units(struct bridge_place place, const uint8_t cell[BRIDGE_TABLE_CELL_SIZE],
                        int32_t units[3]);
void bridge_table_dps(struct bridge_place place, const uint8_t cell[BRIDGE_TABLE_CELL_SIZE], float dps[3]);

/* q = floor(numerator 2^bits / denominator) with the fewest bits that give q >= 2^30; numerator below
 * 2^30 denominator, denominator below 2^31. Long division in 32 bits: at start-up, not for each sample. */
uint32_t bridge_ratio(uint32_t numerator, uint32_t denominator, uint8_t *bits);

#ifdef __cplusplus
}
#endif

#endif
