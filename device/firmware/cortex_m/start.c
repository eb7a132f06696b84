/* SPDX-License-Identifier: MIT
 *
 * Vectors, reset, and the three functions that a compiler may call even in freestanding C.
 */
#include <stddef.h>
#include <stdint.h>

#define CPACR (*(volatile uint32_t *)0xE000ED88u)
#define FPU_FULL_ACCESS (0xFu << 20)

extern uint32_t stack_top;
extern uint32_t bss_start;
extern uint32_t bss_end;

int main(void);
void stop(uint32_t reason);
void reset(void);
void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);
int memcmp(const void *a, const void *b, size_t count);

static void fault(void)
{
    stop(0x20024u); /* ADP_Stopped_InternalError */
}

struct vectors
{
    uint32_t *stack;
    void (*handlers[15])(void);
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    &stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault}};

__attribute__((noinline)) static void run(void)
{
    stop(main() == 0 ? 0x20026u : 0x20024u); /* ADP_Stopped_ApplicationExit */
}

void reset(void)
{
    uint32_t *word;
    CPACR |= FPU_FULL_ACCESS;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    for (word = &bss_start; word < &bss_end; ++word)
        *word = 0;
    run();
}

void *memcpy(void *to, const void *from, size_t count)
{
    uint8_t *out = to;
    const uint8_t *in = from;
    while (count-- > 0)
        *out++ = *in++;
    return to;
}

void *memset(void *to, int value, size_t count)
{
    uint8_t *out = to;
    while (count-- > 0)
        *out++ = (uint8_t)value;
    return to;
}

int memcmp(const void *a, const void *b, size_t count)
{
    const uint8_t *left = a;
    const uint8_t *right = b;
    for (; count > 0; --count, ++left, ++right) {
        if (*left != *right)
            return *left < *right ? -1 : 1;
    }
    return 0;
}
