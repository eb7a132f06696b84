/* SPDX-License-Identifier: MIT
 *
 * Table image: the bytes of a compensation table in a bank of the native gyro bridge, and how numbers lie in
 * them. The encoder (device_image.h) and the firmware (device/firmware, C99) share this header;
 * docs/bridge-protocol.md explains it.
 *
 * All numbers are little-endian; a field is read and written byte by byte (bridge_get_*, bridge_put_*), so
 * alignment and byte order of the machine don't matter.
 */
#ifndef DRIFTBENCH_DEVICE_IMAGE_LAYOUT_H
#define DRIFTBENCH_DEVICE_IMAGE_LAYOUT_H

#include <stdint.h>

/* An image is the 56 bytes of its header and 12 bytes a knot, nothing else. */
#define BRIDGE_TABLE_MAGIC 0u       /* u32, BRIDGE_TABLE_MAGIC_VALUE */
#define BRIDGE_TABLE_VERSION 4u     /* u8, BRIDGE_TABLE_VERSION_VALUE */
#define BRIDGE_TABLE_KIND 5u        /* u8, BRIDGE_TABLE_FIXED or BRIDGE_TABLE_FLOAT */
#define BRIDGE_TABLE_AXES 6u        /* u8, 1 .. 7, bit i: axis i is compensated, the others hold zeros */
#define BRIDGE_TABLE_THERMOMETER 7u /* u8, BRIDGE_THERMOMETER_*: made with it, looked up with it */
#define BRIDGE_TABLE_MODEL 8u       /* 12 bytes of ASCII, filled with 0, as in info */
#define BRIDGE_TABLE_SERIAL 20u     /* 16 bytes of ASCII, filled with 0, as in info */
#define BRIDGE_TABLE_FIRST 36u      /* i32, millidegrees Celsius of the first knot */
#define BRIDGE_TABLE_LAST 40u       /* i32, of the last knot */
#define BRIDGE_TABLE_KNOTS 44u      /* u32, n, 2 .. BRIDGE_TABLE_MOST_KNOTS */
#define BRIDGE_TABLE_RECIPROCAL 48u /* fixed: u32; float: float32, cells a degree */
#define BRIDGE_TABLE_SHIFT 52u      /* u8, fixed; 0 in float */
#define BRIDGE_TABLE_FRACTION 53u   /* u8, fixed, 0 .. 30: a unit is 2^-fraction dps; 0 in float */
#define BRIDGE_TABLE_VALUES 56u     /* n x 3 of i32 (fixed, units) or float32 (dps), x, y, z of each knot */
#define BRIDGE_TABLE_KNOT_SIZE 12u

#define BRIDGE_TABLE_MAGIC_VALUE 0x31425444u /* "DTB1" */
#define BRIDGE_TABLE_VERSION_VALUE 1u        /* a higher one can't be read */
#define BRIDGE_TABLE_FIXED 1u
#define BRIDGE_TABLE_FLOAT 2u
#define BRIDGE_TABLE_MOST_KNOTS 32768u
#define BRIDGE_TABLE_LARGEST_SPAN 1000000u /* millidegrees from first to last, at least n - 1 */
#define BRIDGE_TABLE_MOST_FRACTION 30u
#define BRIDGE_TABLE_VALUE_LIMIT 1073741824 /* 2^30: units (fixed) or dps (float), not reached */

#define BRIDGE_MODEL_SIZE 12u
#define BRIDGE_SERIAL_SIZE 16u

#define BRIDGE_THERMOMETER_DIE 0u
#define BRIDGE_THERMOMETER_EXTERNAL 1u

static inline uint16_t bridge_get_u16(const uint8_t *at)
{
    return (uint16_t)(at[0] | ((uint16_t)at[1] << 8));
}

static inline uint32_t bridge_get_u32(const uint8_t *at)
{
    return (uint32_t)at[0] | ((uint32_t)at[1] << 8) | ((uint32_t)at[2] << 16) | ((uint32_t)at[3] << 24);
}

static inline int16_t bridge_get_i16(const uint8_t *at)
{
    const uint16_t bits = bridge_get_u16(at);
    return (int16_t)(bits < 0x8000u ? (int32_t)bits : (int32_t)bits - 0x10000);
}

static inline int32_t bridge_get_i32(const uint8_t *at)
{
    const uint32_t bits = bridge_get_u32(at);
    return bits < 0x80000000u ? (int32_t)bits : (int32_t)(bits - 0x80000000u) + INT32_MIN;
}

/* A signed field is written by its bits: bridge_put_u32(at, (uint32_t)value). */
static inline void bridge_put_u16(uint8_t *at, uint16_t value)
{
    at[0] = (uint8_t)(value & 0xFFu);
    at[1] = (uint8_t)(value >> 8);
}

static inline void bridge_put_u32(uint8_t *at, uint32_t value)
{
    at[0] = (uint8_t)(value & 0xFFu);
    at[1] = (uint8_t)((value >> 8) & 0xFFu);
    at[2] = (uint8_t)((value >> 16) & 0xFFu);
    at[3] = (uint8_t)(value >> 24);
}

#endif
