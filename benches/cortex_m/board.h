/* A bare Cortex-M4 in QEMU, and the measurement of a call there. */
#include <stdint.h>

/* An operation of semihosting. */
int host(int operation, uint32_t argument);

/* Writes to the host's terminal. */
void say(const char *text);
void say_number(uint32_t number, char end);

/* Instructions of a call, the call itself included. */
uint32_t instructions(void (*call)(void));

/* The same of a thousand instructions, which shows whether the count is right. */
uint32_t instructions_of_a_thousand(void);

/* The greatest depth of the stack in a call, bytes. */
uint32_t depth(void (*call)(void));
