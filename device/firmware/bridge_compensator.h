/* SPDX-License-Identifier: MIT
 *
 * The active table at work: tde in counts at a temperature. The two knots of the last cell are kept, so that
 * the flash is read only when the temperature enters another cell.
 */
#ifndef DRIFTBENCH_BRIDGE_COMPENSATOR_H
#define DRIFTBENCH_BRIDGE_COMPENSATOR_H

#include "device/firmware/bridge_counts.h"
#include "device/firmware/bridge_flash.h"
#include "device/firmware/bridge_table.h"

#ifdef __cplusplus
extern "C" {
#endif

struct bridge_compensator
{
    const struct bridge_flash *flash; /* 0: no table */
    uint8_t bank;
    bool cell_known;
    uint32_t cell;
    struct bridge_table table;
    struct bridge_scale scale;
    uint8_t knots[BRIDGE_TABLE_CELL_SIZE];
};

void bridge_compensator_stop(struct bridge_compensator *compensator);

/* table: of the image in that bank. sensitivity: of the range in use, 10 udps a count. */
void bridge_compensator_start(struct bridge_compensator *compensator, const struct bridge_flash *flash,
                              uint8_t bank, const struct bridge_table *table, uint16_t sensitivity);

/* False: no table, or the flash can't be read. */
bool bridge_compensator_counts(struct bridge_compensator *compensator, int32_t millic, int32_t counts[3]);

#ifdef __cplusplus
}
#endif

#endif
