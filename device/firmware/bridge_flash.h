/* SPDX-License-Identifier: MIT
 *
 * The flash as the table store sees it: two banks, each erased as a whole to 0xFF and programmed in aligned
 * units of 8 bytes, once between two erasures. Power may go in any operation and leave any bytes in what it
 * touched. A unit whose error correction fails reads as failed or as any bytes, never as a trap.
 *
 * Each function gives false where the flash refused.
 */
#ifndef DRIFTBENCH_BRIDGE_FLASH_H
#define DRIFTBENCH_BRIDGE_FLASH_H

#include <stdbool.h>
#include <stdint.h>

#define BRIDGE_FLASH_UNIT 8u
#define BRIDGE_FLASH_ERASED 0xFFu

struct bridge_flash
{
    void *context;
    uint32_t bank_bytes; /* of each bank, a multiple of 8: 256 and the longest image that it shall take */
    bool (*erase)(void *context, uint8_t bank);
    bool (*program)(void *context, uint8_t bank, uint32_t offset, const uint8_t unit[BRIDGE_FLASH_UNIT]);
    bool (*read)(void *context, uint8_t bank, uint32_t offset, uint8_t *bytes, uint32_t count);
};

#endif
