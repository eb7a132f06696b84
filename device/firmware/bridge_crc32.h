/* SPDX-License-Identifier: MIT
 *
 * CRC-32 as in zlib, PNG and Ethernet: polynomial 0xEDB88320 (reflected 0x04C11DB7), start and end inverted.
 * The CRC of the nine letters "123456789" is 0xCBF43926.
 */
#ifndef DRIFTBENCH_BRIDGE_CRC32_H
#define DRIFTBENCH_BRIDGE_CRC32_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* previous: 0, or the CRC of the bytes before these. */
uint32_t bridge_crc32(uint32_t previous, const uint8_t *bytes, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
