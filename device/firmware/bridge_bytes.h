/* SPDX-License-Identifier: MIT
 *
 * Bytes in memory. Freestanding C99 has no string.h to include; a compiler turns these into memcpy, memset
 * and memcmp where that pays, which every tool chain links.
 */
#ifndef DRIFTBENCH_BRIDGE_BYTES_H
#define DRIFTBENCH_BRIDGE_BYTES_H

#include <stdbool.h>
#include <stdint.h>

static inline void bridge_copy(uint8_t *to, const uint8_t *from, uint32_t count)
{
    uint32_t i;
    for (i = 0; i < count; ++i)
        to[i] = from[i];
}

static inline void bridge_fill(uint8_t *to, uint8_t value, uint32_t count)
{
    uint32_t i;
    for (i = 0; i < count; ++i)
        to[i] = value;
}

static inline bool bridge_equal(const uint8_t *a, const uint8_t *b, uint32_t count)
{
    uint32_t i;
    for (i = 0; i < count; ++i) {
        if (a[i] != b[i])
            return false;
    }
    return true;
}

static inline bool bridge_all(const uint8_t *bytes, uint8_t value, uint32_t count)
{
    uint32_t i;
    for (i = 0; i < count; ++i) {
        if (bytes[i] != value)
            return false;
    }
    return true;
}

#endif
