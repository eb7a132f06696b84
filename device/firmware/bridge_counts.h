/* SPDX-License-Identifier: MIT
 *
 * From tde to the counts that are taken off a sample. One count is s * 10 udps (s: sensitivity in info).
 * Exactly, so that a host computes the same bits:
 *   fixed   m = floor(100000 * 2^r / s) with the smallest r that gives m >= 2^30
 *           c = floor(units * m / 2^(r + fraction) + 1/2)      integers, 64-bit product
 *   float   c = tde * (100000 / s) in float32, clamped to +-65536, 0.5 added away from zero (in float32),
 *           cut off to an integer
 *   both    c clamped to +-65536; compensated = raw - c, clamped to int16
 */
#ifndef DRIFTBENCH_BRIDGE_COUNTS_H
#define DRIFTBENCH_BRIDGE_COUNTS_H

#include "device/firmware/bridge_table.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct bridge_scale
{
    uint32_t multiplier;  /* fixed: m */
    uint8_t shift;        /* fixed: r + fraction, 14 .. 60 */
    float counts_per_dps; /* float */
};

/* sensitivity: 1 .. 65535. */
struct bridge_scale bridge_scale_of(const struct bridge_table *table, uint16_t sensitivity);

int32_t bridge_counts_of_units(struct bridge_scale scale, int32_t units);
int32_t bridge_counts_of_dps(struct bridge_scale scale, float dps);

/* at_limit is set where the raw or the compensated value stands at an end of int16, else left. */
int16_t bridge_counts_taken_off(int16_t raw, int32_t counts, bool *at_limit);

#ifdef __cplusplus
}
#endif

#endif
