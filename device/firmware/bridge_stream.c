/* SPDX-License-Identifier: MIT */
#include "device/firmware/bridge_stream.h"

#include "device/firmware/bridge_bytes.h"

void bridge_stream_start(struct bridge_stream *stream, bridge_report *ring, uint32_t capacity)
{
    stream->ring = ring;
    stream->capacity = capacity;
    stream->sequence = 0;
    stream->produced = 0;
    stream->dropped = 0;
    stream->pair = false;
    bridge_compensator_stop(&stream->compensator);
    bridge_stream_clear(stream);
}

void bridge_stream_clear(struct bridge_stream *stream)
{
    stream->oldest = 0;
    stream->waiting = 0;
    stream->filled = 0;
    stream->overrun = false;
}

/* Looks the table up at the temperature that it was made with; without that one the report stays raw. */
static uint8_t compensation_flags(struct bridge_stream *stream, const struct bridge_sample *sample)
{
    const struct bridge_table *table = &stream->compensator.table;
    const bool external = table->thermometer == BRIDGE_THERMOMETER_EXTERNAL;
    const int32_t millic = external ? sample->external_millic : sample->die_millic;
    if (stream->compensator.flash != 0 && (external ? sample->external_valid : sample->die_valid) &&
        bridge_compensator_counts(&stream->compensator, millic, stream->tde_counts)) {
        return bridge_table_covers(table, millic) ? BRIDGE_FLAG_COMPENSATED
                                                  : BRIDGE_FLAG_COMPENSATED | BRIDGE_FLAG_OUTSIDE_TABLE;
    }
    stream->tde_counts[0] = stream->tde_counts[1] = stream->tde_counts[2] = 0;
    return 0;
}

static void open_report(struct bridge_stream *stream, const struct bridge_sample *sample)
{
    uint8_t *report = stream->filling;
    uint8_t flags = compensation_flags(stream, sample);
    if (sample->die_valid)
        flags |= BRIDGE_FLAG_DIE_VALID;
    if (sample->external_valid)
        flags |= BRIDGE_FLAG_EXTERNAL_VALID;
    bridge_fill(report, 0, BRIDGE_REPORT_SIZE);
    report[0] = BRIDGE_REPORT_SAMPLES;
    report[BRIDGE_SAMPLES_FLAGS] = flags;
    bridge_put_u32(report + BRIDGE_SAMPLES_TIME, sample->time_us);
    if (sample->die_valid)
        bridge_put_u32(report + BRIDGE_SAMPLES_DIE_MILLIC, (uint32_t)sample->die_millic);
    if (sample->external_valid)
        bridge_put_u32(report + BRIDGE_SAMPLES_EXTERNAL_MILLIC, (uint32_t)sample->external_millic);
    stream->raw_saturated = 0;
    stream->first_us = sample->time_us;
}

static void append(struct bridge_stream *stream, const struct bridge_sample *sample)
{
    const uint32_t place = stream->filled * BRIDGE_SAMPLE_SIZE;
    uint8_t *at = stream->filling + BRIDGE_SAMPLES_RATES + place;
    uint8_t *raw_at = stream->raw + place;
    bool at_limit = false;
    bool raw_at_limit = false;
    uint32_t axis;
    for (axis = 0; axis < 3u; ++axis) {
        const int16_t counts =
            bridge_counts_taken_off(sample->counts[axis], stream->tde_counts[axis], &at_limit);
        bridge_put_u16(at + 2u * axis, (uint16_t)counts);
        bridge_put_u16(raw_at + 2u * axis,
                       (uint16_t)bridge_counts_taken_off(sample->counts[axis], 0, &raw_at_limit));
    }
    if (at_limit)
        stream->filling[BRIDGE_SAMPLES_SATURATED] |= (uint8_t)(1u << stream->filled);
    if (raw_at_limit)
        stream->raw_saturated |= (uint8_t)(1u << stream->filled);
    stream->last_us = sample->time_us;
    ++stream->filled;
}

/* Mean distance of the samples in ns, rounded down, without a 64-bit product. */
static uint32_t interval_ns(const struct bridge_stream *stream)
{
    const uint32_t span_us = stream->last_us - stream->first_us;
    const uint32_t steps = stream->filled - 1u;
    uint32_t whole_us;
    if (steps == 0u)
        return 0;
    whole_us = span_us / steps;
    if (whole_us > UINT32_MAX / 1000u - 1u)
        return UINT32_MAX;
    return whole_us * 1000u + span_us % steps * 1000u / steps;
}

static void put_into_ring(struct bridge_stream *stream)
{
    bridge_put_u16(stream->filling + BRIDGE_SAMPLES_SEQUENCE, stream->sequence++);
    bridge_copy(stream->ring[(stream->oldest + stream->waiting) % stream->capacity], stream->filling,
                BRIDGE_REPORT_SIZE);
    ++stream->waiting;
}

/* What was filled, with the samples as they were measured. */
static void make_twin(struct bridge_stream *stream)
{
    uint8_t *report = stream->filling;
    report[BRIDGE_SAMPLES_FLAGS] &= BRIDGE_FLAG_DIE_VALID | BRIDGE_FLAG_EXTERNAL_VALID;
    report[BRIDGE_SAMPLES_FLAGS] |= BRIDGE_FLAG_TWIN;
    report[BRIDGE_SAMPLES_SATURATED] = stream->raw_saturated;
    bridge_copy(report + BRIDGE_SAMPLES_RATES, stream->raw, stream->filled * BRIDGE_SAMPLE_SIZE);
}

void bridge_stream_flush(struct bridge_stream *stream)
{
    uint8_t *report = stream->filling;
    bool twin;
    if (stream->filled == 0u)
        return;
    twin = stream->pair && (report[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_COMPENSATED) != 0u;
    if (stream->capacity - stream->waiting < (twin ? 2u : 1u)) {
        stream->dropped += stream->filled;
        stream->overrun = true;
    } else {
        report[BRIDGE_SAMPLES_COUNT] = stream->filled;
        bridge_put_u32(report + BRIDGE_SAMPLES_INTERVAL, interval_ns(stream));
        if (stream->overrun)
            report[BRIDGE_SAMPLES_FLAGS] |= BRIDGE_FLAG_OVERRUN;
        stream->overrun = false;
        put_into_ring(stream);
        if (twin) {
            make_twin(stream);
            put_into_ring(stream);
        }
    }
    stream->filled = 0;
}

void bridge_stream_sample(struct bridge_stream *stream, const struct bridge_sample *sample)
{
    ++stream->produced;
    if (stream->filled == 0u)
        open_report(stream, sample);
    append(stream, sample);
    if (stream->filled == BRIDGE_SAMPLES_PER_REPORT ||
        sample->time_us - stream->first_us >= BRIDGE_STREAM_LONGEST_US)
        bridge_stream_flush(stream);
}

void bridge_stream_lost(struct bridge_stream *stream, uint32_t samples)
{
    if (samples == 0u)
        return;
    bridge_stream_flush(stream);
    stream->produced += samples;
    stream->dropped += samples;
    stream->overrun = true;
}

bool bridge_stream_take(struct bridge_stream *stream, uint8_t report[BRIDGE_REPORT_SIZE])
{
    if (stream->waiting == 0u)
        return false;
    bridge_copy(report, stream->ring[stream->oldest], BRIDGE_REPORT_SIZE);
    stream->oldest = (stream->oldest + 1u) % stream->capacity;
    --stream->waiting;
    return true;
}
