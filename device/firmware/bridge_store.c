/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_store.h"

#include "device/firmware/bridge_bytes.h"

static void choose_active(struct bridge_store *store)
{
    uint8_t i;
    store->active = BRIDGE_NO_BANK;
    for (i = 0; i < BRIDGE_BANKS; ++i) {
        if (store->banks[i].state == BRIDGE_BANK_ACTIVATED &&
            (store->active == BRIDGE_NO_BANK ||
             store->banks[i].generation > store->banks[store->active].generation))
            store->active = i;
    }
}

static uint32_t highest_generation(const struct bridge_store *store)
{
    return store->banks[0].generation > store->banks[1].generation ? store->banks[0].generation
                                                                   : store->banks[1].generation;
}

/* Not the active one; else an empty one; else the older one. */
static uint8_t spare_bank(const struct bridge_store *store)
{
    if (store->active != BRIDGE_NO_BANK)
        return (uint8_t)(1u - store->active);
    /* An empty bank has generation 0, so it is the older one. */
    return store->banks[1].generation < store->banks[0].generation ? 1u : 0u;
}

static uint32_t bank_capacity(const struct bridge_store *store)
{
    return store->flash->bank_bytes - BRIDGE_BANK_IMAGE_AT;
}

static bool running(const struct bridge_store *store)
{
    return store->upload.stage != BRIDGE_UPLOAD_NONE && store->upload.stage != BRIDGE_UPLOAD_COMMITTED;
}

static uint8_t check_upload(const struct bridge_store *store, uint16_t transaction)
{
    if (!running(store))
        return BRIDGE_RESULT_NO_UPLOAD;
    return transaction == store->upload.transaction ? BRIDGE_RESULT_OK : BRIDGE_RESULT_WRONG_UPLOAD;
}

/* An upload that failed is over: its bank is partly written and must be erased before another attempt. */
static uint8_t give_up(struct bridge_store *store, uint8_t result)
{
    store->upload.stage = BRIDGE_UPLOAD_NONE;
    return result;
}

void bridge_store_start(struct bridge_store *store, const struct bridge_flash *flash,
                        struct bridge_sensor sensor, uint8_t capabilities)
{
    uint8_t i;
    store->flash = flash;
    store->sensor = sensor;
    store->capabilities = capabilities;
    store->upload.stage = BRIDGE_UPLOAD_NONE;
    store->upload.received = 0;
    for (i = 0; i < BRIDGE_BANKS; ++i)
        bridge_bank_scan(&store->banks[i], flash, i, sensor);
    choose_active(store);
}

uint8_t bridge_store_begin(struct bridge_store *store, uint16_t transaction, uint32_t bytes, uint32_t crc)
{
    if (bytes < BRIDGE_TABLE_VALUES + 2u * BRIDGE_TABLE_KNOT_SIZE || bytes > bank_capacity(store) ||
        (bytes - BRIDGE_TABLE_VALUES) % BRIDGE_TABLE_KNOT_SIZE != 0u)
        return BRIDGE_RESULT_BAD_LENGTH;
    if (highest_generation(store) == UINT32_MAX)
        return BRIDGE_RESULT_FULL;
    store->upload.stage = BRIDGE_UPLOAD_ANNOUNCED;
    store->upload.transaction = transaction;
    store->upload.bytes = bytes;
    store->upload.crc = crc;
    store->upload.received = 0;
    return BRIDGE_RESULT_OK;
}

static bool usable_here(const struct bridge_store *store, const struct bridge_table *table)
{
    const uint8_t kind = table->kind == BRIDGE_TABLE_FIXED ? BRIDGE_CAN_FIXED : BRIDGE_CAN_FLOAT;
    const uint8_t thermometer = table->thermometer == BRIDGE_THERMOMETER_EXTERNAL ? BRIDGE_CAN_EXTERNAL : 0u;
    return (store->capabilities & kind) != 0u && (store->capabilities & thermometer) == thermometer;
}

/* Nothing is erased for an image that its header already forbids. */
static uint8_t open_bank(struct bridge_store *store, const uint8_t *header)
{
    struct bridge_table table;
    uint8_t result;
    if (!bridge_table_read(&table, header) || bridge_table_bytes(&table) != store->upload.bytes ||
        !usable_here(store, &table))
        return BRIDGE_RESULT_BAD_TABLE;
    if (!bridge_table_is_for(header, store->sensor.model, store->sensor.serial))
        return BRIDGE_RESULT_OTHER_SENSOR;
    store->upload.bank = spare_bank(store);
    result =
        bridge_bank_erase(&store->banks[store->upload.bank], store->flash, store->upload.bank, store->sensor);
    if (result == BRIDGE_RESULT_OK)
        store->upload.stage = BRIDGE_UPLOAD_RECEIVING;
    return result;
}

static uint8_t compare_repeat(const struct bridge_store *store, uint32_t offset, const uint8_t *bytes,
                              uint8_t count)
{
    uint8_t found[BRIDGE_CHUNK_BYTES];
    if (!store->flash->read(store->flash->context, store->upload.bank, BRIDGE_BANK_IMAGE_AT + offset, found,
                            count))
        return BRIDGE_RESULT_FLASH;
    return bridge_equal(found, bytes, count) ? BRIDGE_RESULT_OK : BRIDGE_RESULT_WRONG_OFFSET;
}

uint8_t bridge_store_chunk(struct bridge_store *store, uint16_t transaction, uint32_t offset,
                           const uint8_t *bytes, uint8_t count)
{
    struct bridge_upload *upload = &store->upload;
    uint8_t result = check_upload(store, transaction);
    uint32_t left;
    if (result != BRIDGE_RESULT_OK)
        return result;
    if (offset > upload->received || offset % BRIDGE_CHUNK_BYTES != 0u)
        return BRIDGE_RESULT_WRONG_OFFSET;
    left = upload->bytes - offset;
    if (count == 0u || count != (left < BRIDGE_CHUNK_BYTES ? left : BRIDGE_CHUNK_BYTES))
        return BRIDGE_RESULT_BAD_LENGTH;
    if (offset < upload->received)
        return compare_repeat(store, offset, bytes, count);
    if (offset == 0u) {
        result = open_bank(store, bytes);
        if (result != BRIDGE_RESULT_OK)
            return give_up(store, result);
    }
    result = bridge_bank_program(store->flash, upload->bank, offset, bytes, count);
    if (result != BRIDGE_RESULT_OK)
        return give_up(store, result);
    upload->received += count;
    return BRIDGE_RESULT_OK;
}

uint8_t bridge_store_verify(struct bridge_store *store, uint16_t transaction)
{
    struct bridge_table table;
    uint8_t result = check_upload(store, transaction);
    if (result != BRIDGE_RESULT_OK)
        return result;
    if (store->upload.received < store->upload.bytes)
        return BRIDGE_RESULT_INCOMPLETE;
    result = bridge_bank_check_image(store->flash, store->upload.bank, store->upload.bytes, store->upload.crc,
                                     store->sensor, &table);
    if (result != BRIDGE_RESULT_OK)
        return give_up(store, result);
    store->upload.stage = BRIDGE_UPLOAD_VERIFIED;
    return BRIDGE_RESULT_OK;
}

uint8_t bridge_store_commit(struct bridge_store *store, uint16_t transaction)
{
    struct bridge_upload *upload = &store->upload;
    uint8_t result;
    if (upload->stage == BRIDGE_UPLOAD_COMMITTED && transaction == upload->transaction)
        return BRIDGE_RESULT_OK;
    result = check_upload(store, transaction);
    if (result != BRIDGE_RESULT_OK)
        return result;
    if (upload->stage != BRIDGE_UPLOAD_VERIFIED)
        return BRIDGE_RESULT_NOT_VERIFIED;
    result = bridge_bank_commit(&store->banks[upload->bank], store->flash, upload->bank,
                                highest_generation(store) + 1u, upload->bytes, upload->crc, store->sensor);
    if (result != BRIDGE_RESULT_OK)
        return give_up(store, result);
    upload->stage = BRIDGE_UPLOAD_COMMITTED;
    return BRIDGE_RESULT_OK;
}

/* The bank with this generation, or BRIDGE_NO_BANK. */
static uint8_t find_generation(const struct bridge_store *store, uint32_t generation)
{
    uint8_t i;
    for (i = 0; i < BRIDGE_BANKS; ++i) {
        if (store->banks[i].state != BRIDGE_BANK_EMPTY && store->banks[i].generation == generation)
            return i;
    }
    return BRIDGE_NO_BANK;
}

static uint8_t mark(struct bridge_store *store, uint8_t bank, uint8_t kind)
{
    const uint8_t result = bridge_bank_mark(&store->banks[bank], store->flash, bank, kind);
    choose_active(store);
    return result;
}

uint8_t bridge_store_activate(struct bridge_store *store, uint32_t generation)
{
    const uint8_t bank = find_generation(store, generation);
    if (bank == BRIDGE_NO_BANK)
        return BRIDGE_RESULT_NOTHING_THERE;
    if (store->banks[bank].state == BRIDGE_BANK_FOREIGN)
        return BRIDGE_RESULT_OTHER_SENSOR;
    if (bank == store->active)
        return BRIDGE_RESULT_OK;
    /* The higher generation would stay in use: the way back is to roll it back. */
    if (store->active != BRIDGE_NO_BANK && generation < store->banks[store->active].generation)
        return BRIDGE_RESULT_BAD_VALUE;
    return mark(store, bank, BRIDGE_MARK_ACTIVATED);
}

uint8_t bridge_store_rollback(struct bridge_store *store, uint32_t generation)
{
    const uint8_t bank = find_generation(store, generation);
    if (bank == BRIDGE_NO_BANK)
        return BRIDGE_RESULT_NOTHING_THERE;
    if (store->banks[bank].state == BRIDGE_BANK_REVOKED)
        return BRIDGE_RESULT_OK;
    return bank == store->active ? mark(store, bank, BRIDGE_MARK_REVOKED) : BRIDGE_RESULT_NOTHING_THERE;
}

uint32_t bridge_store_received(const struct bridge_store *store)
{
    return running(store) ? store->upload.received : 0u;
}

uint8_t bridge_store_read(const struct bridge_store *store, uint8_t bank, uint32_t offset, uint8_t *bytes,
                          uint8_t count, uint8_t *copied)
{
    const bool uploading = running(store) && store->upload.received > 0u && store->upload.bank == bank;
    const uint32_t there = uploading ? store->upload.received : store->banks[bank].bytes;
    *copied = 0;
    if (offset >= there)
        return BRIDGE_RESULT_OK;
    if (there - offset < count)
        count = (uint8_t)(there - offset);
    if (!store->flash->read(store->flash->context, bank, BRIDGE_BANK_IMAGE_AT + offset, bytes, count))
        return BRIDGE_RESULT_FLASH;
    *copied = count;
    return BRIDGE_RESULT_OK;
}
