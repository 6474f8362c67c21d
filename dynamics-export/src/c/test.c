/**
 * Tests what the compiler has made of NAME.c: every function over columns of states is compared, to the last bit, with
 * the same function at one state after the other. Angles of any size are among the states.
 */
#include "NAME.h"

#include <stdio.h>
#include <string.h>

/** Numbers between -2 and 2, one in 16 of them a thousand million times as large. */
static REAL next(void)
{
    static unsigned long state = 7;
    REAL x;
    state = (state * 1103515245ul + 12345ul) & 0x7ffffffful;
    x = (REAL)(long)(state >> 8) / (REAL)2097152 - (REAL)2;
    return (state >> 8) % 16 ? x : x * (REAL)1000000000;
}

/** Columns of such numbers, and where they begin. */
static void fill(REAL *columns, const REAL **all, int entries)
{
    int i, k;
    for (i = 0; i < entries; ++i) {
        all[i] = columns + i * STATES;
        for (k = 0; k < STATES; ++k) columns[i * STATES + k] = next();
    }
}

/** Where the columns of a value begin. */
static void place(REAL *columns, REAL **all, int entries)
{
    int i;
    for (i = 0; i < entries; ++i) all[i] = columns + i * STATES;
}

/** The entries at a state. */
static void pick(const REAL *const *all, int entries, int k, REAL *x)
{
    int i;
    for (i = 0; i < entries; ++i) x[i] = all[i][k];
}

/** Whether a value at a state has other bits; what is no number may have any. */
static int differ(const REAL *value, REAL *const *all, int entries, int k)
{
    int i;
    for (i = 0; i < entries; ++i) {
        const REAL x = value[i], y = all[i][k];
        if (memcmp(&x, &y, sizeof x) != 0 && (x == x || y == y)) return 1;
    }
    return 0;
}

static int report(const char *name, int failures)
{
    if (failures) {
        printf("%s: the batch differs from single calls at %d of STATES states\n", name, failures);
    } else {
        printf("%s: the batch has the digits of single calls at STATES states\n", name);
    }
    return failures;
}
