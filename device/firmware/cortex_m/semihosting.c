/* SPDX-License-Identifier: MIT */
#include "semihosting.h"

#define SYS_OPEN 0x01u
#define SYS_CLOSE 0x02u
#define SYS_WRITE 0x05u
#define SYS_READ 0x06u
#define SYS_EXIT 0x18u
#define MODE_READ_BINARY 1u
#define MODE_WRITE_BINARY 5u

static int32_t call(uint32_t operation, uint32_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uint32_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}

static int32_t call_with_block(uint32_t operation, const uint32_t *block)
{
    return call(operation, (uint32_t)(uintptr_t)block);
}

static int32_t open_file(const char *path, uint32_t length, uint32_t mode)
{
    const uint32_t block[3] = {(uint32_t)(uintptr_t)path, mode, length};
    return call_with_block(SYS_OPEN, block);
}

int32_t semihosting_open_to_read(const char *path, uint32_t length)
{
    return open_file(path, length, MODE_READ_BINARY);
}

int32_t semihosting_open_to_write(const char *path, uint32_t length)
{
    return open_file(path, length, MODE_WRITE_BINARY);
}

/* Both calls give the number of bytes that were not transferred. */
bool semihosting_read(int32_t file, void *bytes, uint32_t count)
{
    const uint32_t block[3] = {(uint32_t)file, (uint32_t)(uintptr_t)bytes, count};
    return call_with_block(SYS_READ, block) == 0;
}

bool semihosting_write(int32_t file, const void *bytes, uint32_t count)
{
    const uint32_t block[3] = {(uint32_t)file, (uint32_t)(uintptr_t)bytes, count};
    return call_with_block(SYS_WRITE, block) == 0;
}

void semihosting_close(int32_t file)
{
    const uint32_t block[1] = {(uint32_t)file};
    (void)call_with_block(SYS_CLOSE, block);
}

void stop(uint32_t reason)
{
    (void)call(SYS_EXIT, reason);
    for (;;) {
    }
}
