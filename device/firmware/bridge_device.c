/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_device.h"

#include "device/firmware/bridge_bytes.h"

/* What was asked for before goes out as it was; what follows is compensated as the configuration says. */
static void apply_compensation(struct bridge_device *device)
{
    const struct bridge_store *store = &device->store;
    struct bridge_stream *stream = &device->stream;
    if (store->active == BRIDGE_NO_BANK)
        device->config.compensate = 0;
    bridge_stream_flush(stream);
    stream->pair = device->config.pair != 0u;
    if (device->config.compensate != 0u) {
        bridge_compensator_start(&stream->compensator, store->flash, store->active,
                                 &store->banks[store->active].table,
                                 device->identity->range[device->config.range].sensitivity);
    } else {
        bridge_compensator_stop(&stream->compensator);
    }
}

void bridge_device_start(struct bridge_device *device, const struct bridge_identity *identity,
                         const struct bridge_flash *flash, bridge_report *ring, uint32_t ring_size)
{
    const struct bridge_sensor sensor = {identity->model, identity->serial};
    device->identity = identity;
    device->config.rate_mhz = identity->max_rate_mhz;
    device->config.range = 0;
    device->config.stream = 0;
    device->config.compensate = 1;
    device->config.pair = 0;
    device->command = 0;
    device->result = BRIDGE_RESULT_OK;
    device->read.bank = 0;
    device->read.offset = 0;
    device->read.length = 0;
    bridge_store_start(&device->store, flash, sensor, identity->capabilities);
    bridge_stream_start(&device->stream, ring, ring_size);
    apply_compensation(device);
}

static uint8_t set_config(struct bridge_device *device, const uint8_t *report)
{
    const struct bridge_identity *identity = device->identity;
    const bool can_pair = (identity->capabilities & BRIDGE_CAN_PAIR) != 0u;
    const struct bridge_config asked = {bridge_get_u32(report + BRIDGE_CONFIG_RATE),
                                        report[BRIDGE_CONFIG_RANGE], report[BRIDGE_CONFIG_STREAM],
                                        report[BRIDGE_CONFIG_COMPENSATE],
                                        can_pair ? report[BRIDGE_CONFIG_PAIR] : (uint8_t)0};
    const struct bridge_config before = device->config;
    if (asked.rate_mhz < identity->min_rate_mhz || asked.rate_mhz > identity->max_rate_mhz ||
        asked.range >= identity->ranges || asked.stream > 1u || asked.compensate > 1u || asked.pair > 1u)
        return BRIDGE_RESULT_BAD_VALUE;
    if (asked.compensate == 1u && device->store.active == BRIDGE_NO_BANK)
        return BRIDGE_RESULT_NOTHING_THERE;
    if (before.stream == 1u && asked.stream == 1u &&
        (asked.rate_mhz != before.rate_mhz || asked.range != before.range))
        return BRIDGE_RESULT_BUSY;
    if (before.stream == 0u && asked.stream == 1u)
        bridge_stream_clear(&device->stream);
    device->config = asked;
    apply_compensation(device);
    return BRIDGE_RESULT_OK;
}

static uint8_t set_read(struct bridge_device *device, const uint8_t *report)
{
    if (report[BRIDGE_READ_BANK] >= BRIDGE_BANKS)
        return BRIDGE_RESULT_BAD_VALUE;
    if (report[BRIDGE_READ_LENGTH] == 0u || report[BRIDGE_READ_LENGTH] > BRIDGE_READ_BYTES)
        return BRIDGE_RESULT_BAD_LENGTH;
    device->read.bank = report[BRIDGE_READ_BANK];
    device->read.offset = bridge_get_u32(report + BRIDGE_READ_OFFSET);
    device->read.length = report[BRIDGE_READ_LENGTH];
    return BRIDGE_RESULT_OK;
}

static uint8_t set_activate(struct bridge_device *device, const uint8_t *report)
{
    const uint8_t result =
        bridge_store_activate(&device->store, bridge_get_u32(report + BRIDGE_ACTIVATE_GENERATION));
    if (result == BRIDGE_RESULT_OK)
        device->config.compensate = 1;
    apply_compensation(device);
    return result;
}

static uint8_t set_rollback(struct bridge_device *device, const uint8_t *report)
{
    const uint8_t result =
        bridge_store_rollback(&device->store, bridge_get_u32(report + BRIDGE_ROLLBACK_GENERATION));
    apply_compensation(device);
    return result;
}

static uint8_t dispatch(struct bridge_device *device, const uint8_t *report)
{
    struct bridge_store *store = &device->store;
    switch (report[0]) {
    case BRIDGE_REPORT_CONFIG:
        return set_config(device, report);
    case BRIDGE_REPORT_BEGIN:
        return bridge_store_begin(store, bridge_get_u16(report + BRIDGE_BEGIN_TRANSACTION),
                                  bridge_get_u32(report + BRIDGE_BEGIN_BYTES),
                                  bridge_get_u32(report + BRIDGE_BEGIN_CRC));
    case BRIDGE_REPORT_CHUNK:
        return bridge_store_chunk(store, bridge_get_u16(report + BRIDGE_CHUNK_TRANSACTION),
                                  bridge_get_u32(report + BRIDGE_CHUNK_OFFSET), report + BRIDGE_CHUNK_DATA,
                                  report[BRIDGE_CHUNK_LENGTH]);
    case BRIDGE_REPORT_READ:
        return set_read(device, report);
    case BRIDGE_REPORT_VERIFY:
        return bridge_store_verify(store, bridge_get_u16(report + BRIDGE_VERIFY_TRANSACTION));
    case BRIDGE_REPORT_COMMIT:
        return bridge_store_commit(store, bridge_get_u16(report + BRIDGE_COMMIT_TRANSACTION));
    case BRIDGE_REPORT_ACTIVATE:
        return set_activate(device, report);
    case BRIDGE_REPORT_ROLLBACK:
        return set_rollback(device, report);
    default:
        return BRIDGE_RESULT_UNKNOWN_COMMAND;
    }
}

uint8_t bridge_device_set(struct bridge_device *device, const uint8_t *report, uint32_t length)
{
    device->command = length > 0u ? report[0] : 0u;
    device->result = length < BRIDGE_REPORT_SIZE ? BRIDGE_RESULT_BAD_LENGTH : dispatch(device, report);
    return device->result;
}

static void get_info(const struct bridge_device *device, uint8_t *report)
{
    const struct bridge_identity *identity = device->identity;
    uint32_t i;
    report[BRIDGE_INFO_MAJOR] = BRIDGE_PROTOCOL_MAJOR;
    report[BRIDGE_INFO_MINOR] = BRIDGE_PROTOCOL_MINOR;
    report[BRIDGE_INFO_CAPABILITIES] = identity->capabilities;
    bridge_copy(report + BRIDGE_INFO_FIRMWARE, identity->firmware, 3);
    report[BRIDGE_INFO_RANGES] = identity->ranges;
    bridge_copy(report + BRIDGE_INFO_MODEL, identity->model, BRIDGE_MODEL_SIZE);
    bridge_copy(report + BRIDGE_INFO_SERIAL, identity->serial, BRIDGE_SERIAL_SIZE);
    bridge_put_u32(report + BRIDGE_INFO_MIN_RATE, identity->min_rate_mhz);
    bridge_put_u32(report + BRIDGE_INFO_MAX_RATE, identity->max_rate_mhz);
    bridge_put_u32(report + BRIDGE_INFO_BANK_BYTES, device->store.flash->bank_bytes - BRIDGE_BANK_IMAGE_AT);
    for (i = 0; i < identity->ranges && i < BRIDGE_RANGES; ++i) {
        uint8_t *at = report + BRIDGE_INFO_RANGE_TABLE + i * BRIDGE_RANGE_SIZE;
        bridge_put_u16(at, identity->range[i].full_scale_dps);
        bridge_put_u16(at + 2, identity->range[i].sensitivity);
    }
}

static void get_config(const struct bridge_device *device, uint8_t *report)
{
    bridge_put_u32(report + BRIDGE_CONFIG_RATE, device->config.rate_mhz);
    report[BRIDGE_CONFIG_RANGE] = device->config.range;
    report[BRIDGE_CONFIG_STREAM] = device->config.stream;
    report[BRIDGE_CONFIG_COMPENSATE] = device->config.compensate;
    report[BRIDGE_CONFIG_PAIR] = device->config.pair;
}

static void get_status(const struct bridge_device *device, uint8_t *report)
{
    uint32_t i;
    report[BRIDGE_STATUS_COMMAND] = device->command;
    report[BRIDGE_STATUS_RESULT] = device->result;
    report[BRIDGE_STATUS_ACTIVE] = device->store.active;
    bridge_put_u32(report + BRIDGE_STATUS_PRODUCED, device->stream.produced);
    bridge_put_u32(report + BRIDGE_STATUS_DROPPED, device->stream.dropped);
    bridge_put_u32(report + BRIDGE_STATUS_RECEIVED, bridge_store_received(&device->store));
    for (i = 0; i < BRIDGE_BANKS; ++i) {
        const struct bridge_bank *bank = &device->store.banks[i];
        uint8_t *at = report + BRIDGE_STATUS_BANKS + i * BRIDGE_STATUS_BANK_SIZE;
        report[BRIDGE_STATUS_BANK_STATES + i] = bank->state;
        bridge_put_u32(at, bank->generation);
        bridge_put_u32(at + 4, bank->bytes);
        bridge_put_u32(at + 8, bank->crc);
    }
}

static void get_read(struct bridge_device *device, uint8_t *report)
{
    uint8_t copied;
    const uint8_t result = bridge_store_read(&device->store, device->read.bank, device->read.offset,
                                             report + BRIDGE_READ_DATA, device->read.length, &copied);
    report[BRIDGE_READ_BANK] = device->read.bank;
    bridge_put_u32(report + BRIDGE_READ_OFFSET, device->read.offset);
    report[BRIDGE_READ_LENGTH] = copied;
    if (result != BRIDGE_RESULT_OK) {
        device->command = BRIDGE_REPORT_READ;
        device->result = result;
        bridge_fill(report + BRIDGE_READ_DATA, 0, BRIDGE_READ_BYTES);
    }
}

bool bridge_device_get(struct bridge_device *device, uint8_t id, uint8_t report[BRIDGE_REPORT_SIZE])
{
    bridge_fill(report, 0, BRIDGE_REPORT_SIZE);
    report[0] = id;
    switch (id) {
    case BRIDGE_REPORT_INFO:
        get_info(device, report);
        return true;
    case BRIDGE_REPORT_CONFIG:
        get_config(device, report);
        return true;
    case BRIDGE_REPORT_STATUS:
        get_status(device, report);
        return true;
    case BRIDGE_REPORT_READ:
        get_read(device, report);
        return true;
    default:
        return false;
    }
}

void bridge_device_sample(struct bridge_device *device, const struct bridge_sample *sample)
{
    if (device->config.stream != 0u)
        bridge_stream_sample(&device->stream, sample);
}

void bridge_device_lost(struct bridge_device *device, uint32_t samples)
{
    if (device->config.stream != 0u)
        bridge_stream_lost(&device->stream, samples);
}

bool bridge_device_take(struct bridge_device *device, uint8_t report[BRIDGE_REPORT_SIZE])
{
    return bridge_stream_take(&device->stream, report);
}
