/* SPDX-License-Identifier: MIT
 *
 * Wire protocol v1 of the native gyro bridge: a USB-HID device with one gyro, thermometers and two banks for
 * compensation tables. docs/bridge-protocol.md explains it; this header and the layout of the table image are
 * its only source of numbers, for the firmware (C99) and for the host (C++).
 *
 * Every report has 64 bytes, the first of which is the report id. Bytes that no field names are 0 when sent
 * and ignored when received.
 */
#ifndef DRIFTBENCH_BRIDGE_PROTOCOL_H
#define DRIFTBENCH_BRIDGE_PROTOCOL_H

#include "engine/exports/device_image_layout.h"

#include <stdint.h>

#define BRIDGE_VENDOR_ID 0x1209u  /* pid.codes */
#define BRIDGE_PRODUCT_ID 0x0001u /* kept there for tests; a product takes its own */
#define BRIDGE_USAGE_PAGE 0xFF00u
#define BRIDGE_USAGE 0x0001u

#define BRIDGE_PROTOCOL_MAJOR 1u /* another major: the two can't talk */
#define BRIDGE_PROTOCOL_MINOR 1u /* a higher minor only adds */

#define BRIDGE_REPORT_SIZE 64u

/* Report ids --------------------------------------------------------------------------------------------- */

#define BRIDGE_REPORT_SAMPLES 0x01u  /* input */
#define BRIDGE_REPORT_INFO 0x10u     /* feature, get */
#define BRIDGE_REPORT_CONFIG 0x11u   /* feature, get and set */
#define BRIDGE_REPORT_STATUS 0x12u   /* feature, get */
#define BRIDGE_REPORT_BEGIN 0x20u    /* feature, set: announces a table image */
#define BRIDGE_REPORT_CHUNK 0x21u    /* feature, set: its next bytes; the first chunk erases the spare bank */
#define BRIDGE_REPORT_READ 0x22u     /* feature, set: choose bytes of a bank; get: those bytes */
#define BRIDGE_REPORT_VERIFY 0x23u   /* feature, set: compare the spare bank with what begin announced */
#define BRIDGE_REPORT_COMMIT 0x24u   /* feature, set: the verified image may be activated from now on */
#define BRIDGE_REPORT_ACTIVATE 0x25u /* feature, set: compensate with a committed bank from now on */
#define BRIDGE_REPORT_ROLLBACK 0x26u /* feature, set: revoke the active bank; the other one takes over */

/* Input report 0x01: samples ----------------------------------------------------------------------------- */

#define BRIDGE_SAMPLES_FLAGS 1u            /* u8, BRIDGE_FLAG_* */
#define BRIDGE_SAMPLES_COUNT 2u            /* u8, 1 .. BRIDGE_SAMPLES_PER_REPORT */
#define BRIDGE_SAMPLES_SATURATED 3u        /* u8, bit i: an axis of sample i stands at its limit */
#define BRIDGE_SAMPLES_SEQUENCE 4u         /* u16, of the report; wraps. A step over 1: reports were lost */
#define BRIDGE_SAMPLES_TIME 6u             /* u32, us, device clock at the first sample; wraps (71.6 min) */
#define BRIDGE_SAMPLES_INTERVAL 10u        /* u32, ns between two samples of the report; 0 with one sample */
#define BRIDGE_SAMPLES_DIE_MILLIC 14u      /* i32, millidegrees Celsius at the first sample */
#define BRIDGE_SAMPLES_EXTERNAL_MILLIC 18u /* i32, the same of the external thermometer */
#define BRIDGE_SAMPLES_RATES 22u           /* i16 counts of x, y, z, then the next sample */
#define BRIDGE_SAMPLE_SIZE 6u
#define BRIDGE_SAMPLES_PER_REPORT 7u

#define BRIDGE_FLAG_COMPENSATED 0x01u    /* the table was taken off before the rates were sent */
#define BRIDGE_FLAG_OVERRUN 0x02u        /* samples were lost inside the device just before this report */
#define BRIDGE_FLAG_EXTERNAL_VALID 0x04u /* an external thermometer was read */
#define BRIDGE_FLAG_DIE_VALID 0x08u      /* the thermometer on the die was read */
#define BRIDGE_FLAG_OUTSIDE_TABLE 0x10u  /* compensated, and the temperature lies outside the table */
#define BRIDGE_FLAG_TWIN 0x20u           /* the samples of the report before, as they were measured */

/* Feature report 0x10: info ------------------------------------------------------------------------------ */

#define BRIDGE_INFO_MAJOR 1u        /* u8 */
#define BRIDGE_INFO_MINOR 2u        /* u8 */
#define BRIDGE_INFO_CAPABILITIES 3u /* u8, BRIDGE_CAN_* */
#define BRIDGE_INFO_FIRMWARE 4u     /* u8 major, u8 minor, u8 patch */
#define BRIDGE_INFO_RANGES 7u       /* u8, number of full scales, 1 .. BRIDGE_RANGES */
#define BRIDGE_INFO_MODEL 8u        /* 12 bytes of ASCII, filled with 0: model of the gyro */
#define BRIDGE_INFO_SERIAL 20u      /* 16 bytes of ASCII, filled with 0: serial number of the gyro */
#define BRIDGE_INFO_MIN_RATE 36u    /* u32, mHz: the lowest sampling rate */
#define BRIDGE_INFO_MAX_RATE 40u    /* u32, mHz */
#define BRIDGE_INFO_BANK_BYTES 44u  /* u32: the longest table image that a bank takes */
#define BRIDGE_INFO_RANGE_TABLE 48u /* per range: u16 dps full scale, u16 sensitivity in 10 udps a count */
#define BRIDGE_RANGE_SIZE 4u
#define BRIDGE_RANGES 4u

#define BRIDGE_CAN_EXTERNAL 0x01u /* has an external thermometer */
#define BRIDGE_CAN_FIXED 0x02u    /* takes fixed-point tables */
#define BRIDGE_CAN_FLOAT 0x04u    /* takes float32 tables */
#define BRIDGE_CAN_PAIR 0x08u     /* sends what it compensated as measured as well */

/* Feature report 0x11: configuration --------------------------------------------------------------------- */

#define BRIDGE_CONFIG_RATE 1u       /* u32, mHz */
#define BRIDGE_CONFIG_RANGE 5u      /* u8, index into the ranges of info */
#define BRIDGE_CONFIG_STREAM 6u     /* u8, 1: send input reports */
#define BRIDGE_CONFIG_COMPENSATE 7u /* u8, 1: take the active table off; refused without one */
#define BRIDGE_CONFIG_PAIR 8u       /* u8, 1: a raw twin follows every compensated report */

/* Feature report 0x12: status ---------------------------------------------------------------------------- */

#define BRIDGE_STATUS_COMMAND 1u      /* u8, report id of the last set command */
#define BRIDGE_STATUS_RESULT 2u       /* u8, BRIDGE_RESULT_* of that command */
#define BRIDGE_STATUS_ACTIVE 3u       /* u8, bank in use, or BRIDGE_NO_BANK */
#define BRIDGE_STATUS_PRODUCED 4u     /* u32, samples taken while streaming since power-up; wraps */
#define BRIDGE_STATUS_DROPPED 8u      /* u32, of those, lost inside the device; wraps */
#define BRIDGE_STATUS_RECEIVED 12u    /* u32, bytes of the running upload that are in the flash */
#define BRIDGE_STATUS_BANK_STATES 16u /* u8 of bank 0, u8 of bank 1: BRIDGE_BANK_* */
#define BRIDGE_STATUS_BANKS 18u       /* per bank: u32 generation, u32 image bytes, u32 CRC-32 of the image */
#define BRIDGE_STATUS_BANK_SIZE 12u
#define BRIDGE_BANKS 2u
#define BRIDGE_NO_BANK 0xFFu

#define BRIDGE_BANK_EMPTY 0u     /* erased, torn or damaged: nothing to be used */
#define BRIDGE_BANK_COMMITTED 1u /* whole and valid, not activated */
#define BRIDGE_BANK_ACTIVATED 2u /* whole, valid and activated */
#define BRIDGE_BANK_REVOKED 3u   /* whole and valid, but rolled back */
#define BRIDGE_BANK_FOREIGN 4u   /* whole, but of another sensor */

#define BRIDGE_RESULT_OK 0u
#define BRIDGE_RESULT_UNKNOWN_COMMAND 1u
#define BRIDGE_RESULT_BAD_LENGTH 2u     /* a report, an image or a chunk of a length that can't be */
#define BRIDGE_RESULT_BAD_VALUE 3u      /* a field outside its range */
#define BRIDGE_RESULT_NO_UPLOAD 4u      /* chunk, verify or commit without a begin */
#define BRIDGE_RESULT_WRONG_UPLOAD 5u   /* the transaction number is not that of begin */
#define BRIDGE_RESULT_WRONG_OFFSET 6u   /* a chunk that neither follows the last one nor repeats one */
#define BRIDGE_RESULT_INCOMPLETE 7u     /* verify before all bytes are there */
#define BRIDGE_RESULT_BAD_CRC 8u        /* what arrived is not what was announced */
#define BRIDGE_RESULT_BAD_TABLE 9u      /* the image contradicts itself or is of a kind unknown here */
#define BRIDGE_RESULT_OTHER_SENSOR 10u  /* the image is for another model or serial number */
#define BRIDGE_RESULT_NOT_VERIFIED 11u  /* commit before verify */
#define BRIDGE_RESULT_NOTHING_THERE 12u /* nothing to activate, to roll back or to compensate with */
#define BRIDGE_RESULT_FLASH 13u         /* the flash refused to erase, to take or to give the bytes */
#define BRIDGE_RESULT_BUSY 14u          /* not while this goes on */
#define BRIDGE_RESULT_FULL 15u          /* no room left for the mark or the generation: upload anew */

/* Feature reports 0x20 .. 0x26: tables ------------------------------------------------------------------- */

#define BRIDGE_BEGIN_TRANSACTION 1u /* u16, chosen by the host; chunk, verify and commit repeat it */
#define BRIDGE_BEGIN_BYTES 3u       /* u32, length of the image */
#define BRIDGE_BEGIN_CRC 7u         /* u32, CRC-32 of the image */

#define BRIDGE_CHUNK_TRANSACTION 1u /* u16 */
#define BRIDGE_CHUNK_OFFSET 3u      /* u32, where the bytes belong: the next ones, or some again (a repeat) */
#define BRIDGE_CHUNK_LENGTH 7u      /* u8, BRIDGE_CHUNK_BYTES, or what is left in the last chunk */
#define BRIDGE_CHUNK_DATA 8u        /* bytes of the image; the first chunk is its whole header */
#define BRIDGE_CHUNK_BYTES 56u

#define BRIDGE_READ_BANK 1u   /* u8 */
#define BRIDGE_READ_OFFSET 2u /* u32 */
#define BRIDGE_READ_LENGTH 6u /* u8, asked for in set; what there is in get, 0 past the end */
#define BRIDGE_READ_DATA 8u   /* bytes of the image, in get */
#define BRIDGE_READ_BYTES 56u

#define BRIDGE_VERIFY_TRANSACTION 1u /* u16 */
#define BRIDGE_COMMIT_TRANSACTION 1u /* u16 */

#define BRIDGE_ACTIVATE_GENERATION 1u /* u32, of the bank that is meant */
#define BRIDGE_ROLLBACK_GENERATION 1u /* u32, of the active bank, which is revoked: a repeat does no harm */

/* Report descriptor -------------------------------------------------------------------------------------- */

/* One collection of the vendor page with each report of 63 bytes after its id. */
#define BRIDGE_DESCRIPTOR_REPORT(id, item) 0x85, (id), 0x09, (id), (item), 0x02
#define BRIDGE_DESCRIPTOR_INPUT 0x81
#define BRIDGE_DESCRIPTOR_FEATURE 0xB1
// clang-format off
#define BRIDGE_REPORT_DESCRIPTOR                                                                             \
    {                                                                                                        \
        0x06, 0x00, 0xFF, /* usage page: vendor 0xFF00 */                                                    \
        0x09, 0x01,       /* usage 1 */                                                                      \
        0xA1, 0x01,       /* collection: application */                                                      \
        0x15, 0x00,       /* logical minimum 0 */                                                            \
        0x26, 0xFF, 0x00, /* logical maximum 255 */                                                          \
        0x75, 0x08,       /* fields of 8 bits */                                                             \
        0x95, 0x3F,       /* 63 of them a report */                                                          \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_SAMPLES, BRIDGE_DESCRIPTOR_INPUT),                            \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_INFO, BRIDGE_DESCRIPTOR_FEATURE),                             \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_CONFIG, BRIDGE_DESCRIPTOR_FEATURE),                           \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_STATUS, BRIDGE_DESCRIPTOR_FEATURE),                           \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_BEGIN, BRIDGE_DESCRIPTOR_FEATURE),                            \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_CHUNK, BRIDGE_DESCRIPTOR_FEATURE),                            \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_READ, BRIDGE_DESCRIPTOR_FEATURE),                             \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_VERIFY, BRIDGE_DESCRIPTOR_FEATURE),                           \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_COMMIT, BRIDGE_DESCRIPTOR_FEATURE),                           \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_ACTIVATE, BRIDGE_DESCRIPTOR_FEATURE),                         \
        BRIDGE_DESCRIPTOR_REPORT(BRIDGE_REPORT_ROLLBACK, BRIDGE_DESCRIPTOR_FEATURE),                         \
        0xC0 /* end of collection */                                                                         \
    }
// clang-format on

#endif
