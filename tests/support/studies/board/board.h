/* board.h: what start.c gives to a program under an emulated Cortex-M. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Prints by semihosting. */
void board_print(const char *text);
void board_print_number(const char *name, int32_t number);

/* Executed instructions of `times` calls, in ticks of the timer. */
uint32_t board_ticks(int (*call)(void), int times);

/* Ticks of BOARD_KNOWN instructions: what a tick is worth. */
#define BOARD_KNOWN 200000
uint32_t board_ticks_of_known(void);

/* Bytes of stack below the caller that a call writes to. */
uint32_t board_stack(int (*call)(void));

#endif
