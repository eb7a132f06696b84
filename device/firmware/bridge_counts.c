/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_counts.h"

#define MOST_COUNTS 65536 /* takes any raw value beyond the end of int16 */

struct bridge_scale bridge_scale_of(const struct bridge_table *table, uint16_t sensitivity)
{
    struct bridge_scale scale;
    uint8_t bits;
    scale.multiplier = bridge_ratio(100000u, sensitivity, &bits);
    scale.shift = (uint8_t)(bits + table->fraction);
    scale.counts_per_dps = 100000.0f / (float)sensitivity;
    return scale;
}

int32_t bridge_counts_of_units(struct bridge_scale scale, int32_t units)
{
    /* |units| < 2^30 and m < 2^31; 2^62, a multiple of 2^shift, keeps the shifted number positive. */
    const uint64_t bias = UINT64_C(1) << 62;
    const int64_t product = (int64_t)units * (int64_t)scale.multiplier;
    const uint64_t raised = (uint64_t)product + (UINT64_C(1) << (scale.shift - 1u)) + bias;
    const int64_t counts = (int64_t)(raised >> scale.shift) - (int64_t)(bias >> scale.shift);
    if (counts > MOST_COUNTS)
        return MOST_COUNTS;
    return counts < -MOST_COUNTS ? -MOST_COUNTS : (int32_t)counts;
}

int32_t bridge_counts_of_dps(struct bridge_scale scale, float dps)
{
    const float counts = dps * scale.counts_per_dps;
    const float below = counts < (float)MOST_COUNTS ? counts : (float)MOST_COUNTS;
    const float held = below > -(float)MOST_COUNTS ? below : -(float)MOST_COUNTS;
    const int32_t rounded = (int32_t)(held < 0.0f ? held - 0.5f : held + 0.5f);
    if (rounded > MOST_COUNTS)
        return MOST_COUNTS;
    return rounded < -MOST_COUNTS ? -MOST_COUNTS : rounded;
}

int16_t bridge_counts_taken_off(int16_t raw, int32_t counts, bool *at_limit)
{
    const int32_t difference = raw - counts;
    if (raw == INT16_MAX || raw == INT16_MIN || difference >= INT16_MAX || difference <= INT16_MIN)
        *at_limit = true;
    if (difference > INT16_MAX)
        return INT16_MAX;
    return difference < INT16_MIN ? INT16_MIN : (int16_t)difference;
}
