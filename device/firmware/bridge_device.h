/* SPDX-License-Identifier: MIT
 *
 * The device behind the USB stack: feature reports in and out, samples in, input reports out.
 *
 * The main loop gives every report that the host sets to bridge_device_set, answers a get from
 * bridge_device_get, hands samples of the gyro to bridge_device_sample while config.stream is 1, sends what
 * bridge_device_take gives, and sets the gyro to config.rate_mhz and config.range where those changed.
 * A set may take as long as the erasure of a bank; samples that arrive meanwhile and find no room are told to
 * bridge_device_lost.
 */
#ifndef DRIFTBENCH_BRIDGE_DEVICE_H
#define DRIFTBENCH_BRIDGE_DEVICE_H

#include "device/firmware/bridge_store.h"
#include "device/firmware/bridge_stream.h"

#ifdef __cplusplus
extern "C" {
#endif

struct bridge_range
{
    uint16_t full_scale_dps;
    uint16_t sensitivity; /* 10 udps a count, not 0 */
};

/* What the device is: constant, outlives it. */
struct bridge_identity
{
    uint8_t firmware[3];  /* major, minor, patch */
    uint8_t capabilities; /* BRIDGE_CAN_* */
    uint8_t model[BRIDGE_MODEL_SIZE];
    uint8_t serial[BRIDGE_SERIAL_SIZE];
    uint32_t min_rate_mhz;
    uint32_t max_rate_mhz;
    uint8_t ranges; /* 1 .. BRIDGE_RANGES */
    struct bridge_range range[BRIDGE_RANGES];
};

struct bridge_config
{
    uint32_t rate_mhz;
    uint8_t range;
    uint8_t stream;
    uint8_t compensate;
    uint8_t pair;
};

struct bridge_read_choice
{
    uint8_t bank;
    uint32_t offset;
    uint8_t length;
};

struct bridge_device
{
    const struct bridge_identity *identity;
    struct bridge_config config;
    uint8_t command;
    uint8_t result;
    struct bridge_read_choice read;
    struct bridge_store store;
    struct bridge_stream stream;
};

/* Power-up: not streaming, the highest rate, the first range; compensating if there is an active table. All
 * that the pointers name must outlive the device. ring: room for ring_size reports, 1 or more; 2 or more with
 * BRIDGE_CAN_PAIR. */
void bridge_device_start(struct bridge_device *device, const struct bridge_identity *identity,
                         const struct bridge_flash *flash, bridge_report *ring, uint32_t ring_size);

/* Gives BRIDGE_RESULT_*, which is in the status report as well: a stack that can't refuse may ignore it. */
uint8_t bridge_device_set(struct bridge_device *device, const uint8_t *report, uint32_t length);

/* Fills the report with this id; false: no such report can be read, refuse it. */
bool bridge_device_get(struct bridge_device *device, uint8_t id, uint8_t report[BRIDGE_REPORT_SIZE]);

void bridge_device_sample(struct bridge_device *device, const struct bridge_sample *sample);
void bridge_device_lost(struct bridge_device *device, uint32_t samples);
bool bridge_device_take(struct bridge_device *device, uint8_t report[BRIDGE_REPORT_SIZE]);

#ifdef __cplusplus
}
#endif

#endif
