/* SPDX-License-Identifier: MIT
 *
 * Samples in, input reports out, with a ring of whole reports between them. Where the ring is full the new
 * report is lost, its samples are counted, and the next report says so; sequence numbers are given to what
 * enters the ring, so a step in them means that a report was lost on the way to the host.
 *
 * The table is looked up once a report, at the temperature that the report carries: what was taken off can
 * be computed from the report. A report is closed with 7 samples, or with the first that lies
 * BRIDGE_STREAM_LONGEST_US or more after its first one.
 *
 * With `pair` a compensated report is followed by its twin, which has the same samples as they were measured:
 * the host can compare. The two enter the ring together or not at all, so it must have room for both.
 *
 * All functions must run in one context, or with the others masked.
 */
#ifndef DRIFTBENCH_BRIDGE_STREAM_H
#define DRIFTBENCH_BRIDGE_STREAM_H

#include "device/bridge/bridge_protocol.h"
#include "device/firmware/bridge_compensator.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BRIDGE_STREAM_LONGEST_US 40000u

struct bridge_sample
{
    uint32_t time_us; /* device clock, wraps */
    int16_t counts[3];
    bool die_valid;
    bool external_valid;
    int32_t die_millic;
    int32_t external_millic;
};

typedef uint8_t bridge_report[BRIDGE_REPORT_SIZE];

struct bridge_stream
{
    bridge_report *ring;
    uint32_t capacity;
    uint32_t oldest;
    uint32_t waiting;
    bridge_report filling;
    uint8_t filled;
    bool overrun;
    uint16_t sequence;
    uint32_t first_us;
    uint32_t last_us;
    uint32_t produced;
    uint32_t dropped;
    int32_t tde_counts[3]; /* of the report that is being filled */
    bool pair;             /* set by the owner, between two reports */
    uint8_t raw[BRIDGE_SAMPLES_PER_REPORT * BRIDGE_SAMPLE_SIZE];
    uint8_t raw_saturated;
    struct bridge_compensator compensator;
};

/* Memory for `capacity` (1 or more) reports; it must outlive the stream. */
void bridge_stream_start(struct bridge_stream *stream, bridge_report *ring, uint32_t capacity);

void bridge_stream_sample(struct bridge_stream *stream, const struct bridge_sample *sample);

/* The gyro or its driver lost so many samples since the last one. */
void bridge_stream_lost(struct bridge_stream *stream, uint32_t samples);

/* Closes the report that is being filled. */
void bridge_stream_flush(struct bridge_stream *stream);

/* Throws away what waits; numbers and counters go on. */
void bridge_stream_clear(struct bridge_stream *stream);

/* The oldest report that waits; false: none. */
bool bridge_stream_take(struct bridge_stream *stream, uint8_t report[BRIDGE_REPORT_SIZE]);

#ifdef __cplusplus
}
#endif

#endif
