/* SPDX-License-Identifier: MIT
 *
 * Files of the machine that runs the emulator (Arm semihosting). Handles are negative where that failed.
 */
#ifndef DRIFTBENCH_SEMIHOSTING_H
#define DRIFTBENCH_SEMIHOSTING_H

#include <stdbool.h>
#include <stdint.h>

int32_t semihosting_open_to_read(const char *path, uint32_t length);
int32_t semihosting_open_to_write(const char *path, uint32_t length);
bool semihosting_read(int32_t file, void *bytes, uint32_t count);
bool semihosting_write(int32_t file, const void *bytes, uint32_t count);
void semihosting_close(int32_t file);

/* Ends the emulator. */
void stop(uint32_t reason);

#endif
