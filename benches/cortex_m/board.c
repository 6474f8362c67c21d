/*
 * The bare board `mps2-an386` of QEMU, a Cortex-M4 with a floating-point unit: its start, its output by semihosting, its
 * timer, and the measurement of a call.
 *
 * Under `-icount shift=0` an instruction takes 1 ns of the board's time. Its timer counts each 40 ns, so that a loop of
 * many calls tells instructions from its ticks.
 */
#include "board.h"

extern uint32_t stack_end[];
int main(void);

#define REGISTER(address) (*(volatile uint32_t *)(address))

static void start(void)
{
    REGISTER(0xe000ed88) |= 0xfu << 20; /* The floating-point unit is on. */
    __asm volatile("dsb\nisb");
    REGISTER(0xe000e014) = 0xffffff; /* SysTick counts down from here, by the clock of the processor. */
    REGISTER(0xe000e018) = 0;
    REGISTER(0xe000e010) = 5;
    main();
    host(0x18, 0x20026); /* The program has ended. */
    for (;;) {
    }
}

static void fault(void)
{
    say("fault\n");
    host(0x18, 0x20026);
    for (;;) {
    }
}

__attribute__((section(".vectors"), used)) static void *const VECTORS[16] = {
    stack_end, start, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault
};

int host(int operation, uint32_t argument)
{
    register int r0 __asm("r0") = operation;
    register uint32_t r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void say(const char *text)
{
    host(0x04, (uint32_t)text);
}

void say_number(uint32_t number, char end)
{
    char text[12] = {0};
    int at = 10;
    text[at] = end;
    do {
        text[--at] = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    say(text + at);
}

static uint32_t ticks(void)
{
    return REGISTER(0xe000e018);
}

enum { TURNS = 400, TICK = 40 };

/* Instructions of a call, in tenths. */
static uint32_t tenths(void (*call)(void))
{
    const uint32_t begin = ticks();
    for (uint32_t turn = 0; turn < TURNS; ++turn) {
        call();
    }
    return ((begin - ticks()) & 0xffffff) * TICK * 10 / TURNS;
}

static void nothing(void)
{
    __asm volatile("");
}

static void thousand(void)
{
    __asm volatile(".rept 1000\nnop\n.endr");
}

uint32_t instructions(void (*call)(void))
{
    return (tenths(call) - tenths(nothing) + 5) / 10;
}

uint32_t instructions_of_a_thousand(void)
{
    return instructions(thousand);
}

/* The greatest depth of the stack in a call, bytes: the words that it has changed. */
uint32_t depth(void (*call)(void))
{
    enum { WORDS = 4096, UNTOUCHED = 0x5afe5afe };
    uint32_t *const top = (uint32_t *)__builtin_frame_address(0) - 64;
    uint32_t *lowest = top - WORDS;
    for (uint32_t *word = lowest; word < top; ++word) {
        *(volatile uint32_t *)word = UNTOUCHED;
    }
    /* The call begins at `top`, whatever the frame of this function is. */
    __asm volatile("mov r4, sp\nmov sp, %0\nblx %1\nmov sp, r4\n"
                   :
                   : "r"(top), "r"(call)
                   : "r0", "r1", "r2", "r3", "r4", "r12", "lr", "cc", "memory", "s0", "s1", "s2", "s3", "s4", "s5", "s6",
                     "s7", "s8", "s9", "s10", "s11", "s12", "s13", "s14", "s15");
    while (lowest < top && *(volatile uint32_t *)lowest == UNTOUCHED) {
        ++lowest;
    }
    return (uint32_t)((char *)top - (char *)lowest);
}
