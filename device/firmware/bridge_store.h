/* SPDX-License-Identifier: MIT
 *
 * The table store: two banks, one of which may be active, and the upload into the other.
 *
 * Active is the bank that was activated, is not revoked, is whole, is for this sensor, and of two such the
 * one with the higher generation. An upload never touches it. All commands give BRIDGE_RESULT_*.
 */
#ifndef DRIFTBENCH_BRIDGE_STORE_H
#define DRIFTBENCH_BRIDGE_STORE_H

#include "device/firmware/bridge_bank.h"

#ifdef __cplusplus
extern "C" {
#endif

enum bridge_upload_stage
{
    BRIDGE_UPLOAD_NONE,
    BRIDGE_UPLOAD_ANNOUNCED, /* nothing erased yet */
    BRIDGE_UPLOAD_RECEIVING,
    BRIDGE_UPLOAD_VERIFIED,
    BRIDGE_UPLOAD_COMMITTED /* over; remembered so that a repeated commit does no harm */
};

struct bridge_upload
{
    enum bridge_upload_stage stage;
    uint8_t bank;
    uint16_t transaction;
    uint32_t bytes;
    uint32_t crc;
    uint32_t received;
};

struct bridge_store
{
    const struct bridge_flash *flash;
    struct bridge_sensor sensor;
    uint8_t capabilities; /* BRIDGE_CAN_*: which tables can be used here */
    uint8_t active;       /* bank, or BRIDGE_NO_BANK */
    struct bridge_bank banks[BRIDGE_BANKS];
    struct bridge_upload upload;
};

/* Power-up. flash and the sensor's texts must outlive the store. */
void bridge_store_start(struct bridge_store *store, const struct bridge_flash *flash,
                        struct bridge_sensor sensor, uint8_t capabilities);

uint8_t bridge_store_begin(struct bridge_store *store, uint16_t transaction, uint32_t bytes, uint32_t crc);
uint8_t bridge_store_chunk(struct bridge_store *store, uint16_t transaction, uint32_t offset,
                           const uint8_t *bytes, uint8_t count);
uint8_t bridge_store_verify(struct bridge_store *store, uint16_t transaction);
uint8_t bridge_store_commit(struct bridge_store *store, uint16_t transaction);
uint8_t bridge_store_activate(struct bridge_store *store, uint32_t generation);
uint8_t bridge_store_rollback(struct bridge_store *store, uint32_t generation);

/* Bytes of the running upload that are in the flash; 0 where none runs. */
uint32_t bridge_store_received(const struct bridge_store *store);

/* Copies up to count bytes of a bank's image, also of one that is being uploaded. *copied may be less than
 * count, 0 past the end. OK or FLASH. bank: below BRIDGE_BANKS. */
uint8_t bridge_store_read(const struct bridge_store *store, uint8_t bank, uint32_t offset, uint8_t *bytes,
                          uint8_t count, uint8_t *copied);

#ifdef __cplusplus
}
#endif

#endif
