/* SPDX-License-Identifier: MIT
 *
 * One bank of the flash: a table image with its generation, and the marks that say what has become of it.
 *
 *   offset  bytes  what
 *        0     32  4 retirement units: erased while the bank is in use; zeros in one: about to be erased
 *       32     24  header: u32 magic, u32 generation, u32 image bytes, u32 CRC-32 of the image,
 *                  u32 CRC-32 of these 16 bytes, u32 0xFFFFFFFF
 *       56    200  25 marks: u8 kind, u8 inverted kind, u16 number of the slot,
 *                  u32 CRC-32 of those 4 bytes, generation and CRC-32 of the image
 *      256         image
 *
 * Why it is whole at whatever point the power goes: nothing is programmed twice, and each change of state is
 * one mark. A torn mark does not fit its CRC and is passed over; the last whole mark decides. A torn header
 * or image does not fit its CRC: the bank is empty. An erasure that was cut short could leave everything
 * but a mark that revoked the table; therefore a bank is retired first, and a bank whose retirement units
 * are not wholly erased is empty whatever else it holds.
 */
#ifndef DRIFTBENCH_BRIDGE_BANK_H
#define DRIFTBENCH_BRIDGE_BANK_H

#include "device/bridge/bridge_protocol.h"
#include "device/firmware/bridge_flash.h"
#include "device/firmware/bridge_table.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BRIDGE_BANK_RETIRE_UNITS 4u
#define BRIDGE_BANK_HEADER_AT 32u
#define BRIDGE_BANK_HEADER_SIZE 24u
#define BRIDGE_BANK_MARKS_AT 56u
#define BRIDGE_BANK_MARKS 25u
#define BRIDGE_BANK_IMAGE_AT 256u
#define BRIDGE_BANK_MAGIC 0x314B4244u /* "DBK1" */

#define BRIDGE_MARK_COMMITTED 0x43u /* C */
#define BRIDGE_MARK_ACTIVATED 0x41u /* A */
#define BRIDGE_MARK_REVOKED 0x52u   /* R */

/* The gyro that tables must be for: 12 and 16 bytes, as in info. */
struct bridge_sensor
{
    const uint8_t *model;
    const uint8_t *serial;
};

struct bridge_bank
{
    uint8_t state; /* BRIDGE_BANK_EMPTY .. _FOREIGN */
    uint32_t generation;
    uint32_t bytes; /* of the image */
    uint32_t crc;   /* of the image */
    uint32_t next_mark;
    struct bridge_table table; /* where the state is not EMPTY */
};

/* Reads everything and believes only what fits. A flash that can't be read: EMPTY. */
void bridge_bank_scan(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                      struct bridge_sensor sensor);

/* The following give BRIDGE_RESULT_*. */

/* OK, OTHER_SENSOR (table is filled in both), FLASH, BAD_CRC or BAD_TABLE. */
uint8_t bridge_bank_check_image(const struct bridge_flash *flash, uint8_t index, uint32_t bytes, uint32_t crc,
                                struct bridge_sensor sensor, struct bridge_table *table);

/* Retires and erases; OK or FLASH. */
uint8_t bridge_bank_erase(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                          struct bridge_sensor sensor);

/* Of an image, at a multiple of 8; the rest of the last unit stays erased. OK or FLASH. */
uint8_t bridge_bank_program(const struct bridge_flash *flash, uint8_t index, uint32_t offset,
                            const uint8_t *bytes, uint32_t count);

/* Writes the header and the mark of commitment, and scans. OK or FLASH. */
uint8_t bridge_bank_commit(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                           uint32_t generation, uint32_t bytes, uint32_t crc, struct bridge_sensor sensor);

/* OK, FULL or FLASH; the state is then the one in the flash, whatever the result. */
uint8_t bridge_bank_mark(struct bridge_bank *bank, const struct bridge_flash *flash, uint8_t index,
                         uint8_t kind);

#ifdef __cplusplus
}
#endif

#endif
