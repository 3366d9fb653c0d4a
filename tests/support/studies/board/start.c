/* start.c: start of a Cortex-M program under QEMU, its end by semihosting, its timer and its stack.
 *
 * The emulator counts instructions as time, so that the timer counts instructions.
 */
#include "board.h"

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010u)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xE000E014u)
#define SYSTICK_VALUE (*(volatile uint32_t *)0xE000E018u)
#define COPROCESSORS (*(volatile uint32_t *)0xE000ED88u)
#define SYSTICK_LARGEST 0xFFFFFFu

#define WRITE_TEXT 0x04
#define EXIT_EXTENDED 0x20
#define APPLICATION_EXIT 0x20026u

#define PAINTED 4096 /* words */
#define PAINT 0x5AFEC0DEu

extern uint32_t board_data, board_data_end, board_data_load, board_bss, board_bss_end, board_stack_top;

int main(void);
void board_reset(void);

static int semihosting(int operation, const void *argument)
{
    register int result __asm__("r0") = operation;
    register const void *given __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(result) : "r"(given) : "memory");
    return result;
}

static void leave(int code)
{
    const uint32_t reason[2] = {APPLICATION_EXIT, (uint32_t)code};
    (void)semihosting(EXIT_EXTENDED, reason);
    for (;;) {
    }
}

static void fault(void)
{
    board_print("fault\n");
    leave(99);
}

void board_reset(void)
{
    const uint32_t *from = &board_data_load;
    uint32_t *to;
    for (to = &board_data; to != &board_data_end; ++to) {
        *to = *from;
        ++from;
    }
    for (to = &board_bss; to != &board_bss_end; ++to) {
        *to = 0;
    }
    COPROCESSORS |= 0xFu << 20;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    leave(main());
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &board_stack_top, (void *)board_reset, (void *)fault, (void *)fault, (void *)fault, (void *)fault,
    (void *)fault, 0, 0, 0, 0, (void *)fault, (void *)fault, 0, (void *)fault, (void *)fault,
};

void board_print(const char *text)
{
    (void)semihosting(WRITE_TEXT, text);
}

void board_print_number(const char *name, int32_t number)
{
    char text[12];
    int at = 11;
    uint32_t rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    text[at] = '\0';
    do {
        text[--at] = (char)('0' + rest % 10u);
        rest /= 10u;
    } while (rest > 0u);
    if (number < 0) {
        text[--at] = '-';
    }
    board_print(name);
    board_print(" ");
    board_print(&text[at]);
    board_print("\n");
}

static void timer_start(void)
{
    SYSTICK_RELOAD = SYSTICK_LARGEST;
    SYSTICK_CONTROL = 5u;
    SYSTICK_VALUE = 0u;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    while (SYSTICK_VALUE == 0u) {
    }
}

uint32_t board_ticks(int (*call)(void), int times)
{
    uint32_t begin;
    int i;
    timer_start();
    begin = SYSTICK_VALUE;
    for (i = 0; i < times; ++i) {
        (void)call();
    }
    return (begin - SYSTICK_VALUE) & SYSTICK_LARGEST;
}

uint32_t board_ticks_of_known(void)
{
    uint32_t begin;
    int rounds = BOARD_KNOWN / 1000;
    timer_start();
    begin = SYSTICK_VALUE;
    /* 998 and the two of the loop. */
    __asm__ volatile("1:\n\t.rept 998\n\tnop\n\t.endr\n\tsubs %0, %0, #1\n\tbne.w 1b" : "+l"(rounds) : : "cc");
    return (begin - SYSTICK_VALUE) & SYSTICK_LARGEST;
}

__attribute__((noinline)) uint32_t board_stack(int (*call)(void))
{
    volatile uint32_t *top;
    volatile uint32_t *at;
    __asm__ volatile("mov %0, sp" : "=r"(top));
    for (at = top - PAINTED; at < top; ++at) {
        *at = PAINT;
    }
    (void)call();
    at = top - PAINTED;
    while (at < top && *at == PAINT) {
        ++at;
    }
    return (uint32_t)((const volatile char *)top - (const volatile char *)at);
}
