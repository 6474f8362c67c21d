#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "NAME_inverse.h"
static uint64_t hash = 14695981039346656037u;
static void add(uint64_t word) { hash = (hash ^ word) * 1099511628211u; }
static void add_number(REAL x)
{
    WORD bits;
    memcpy(&bits, &x, sizeof bits);
    add(bits);
}
static void add_all(int count, REAL q[][JOINTS], const int *is_singular, const char **branch)
{
    add((uint64_t)(count < 0 ? 0 : count));
    for (int k = 0; k < count; ++k) {
        uint64_t text = 0;
        for (int i = 0; i < JOINTS; ++i) add_number(q[k][i]);
        add((uint64_t)is_singular[k]);
        for (const char *letter = branch[k]; *letter; ++letter) text = 31 * text + (uint64_t)*letter;
        add(text);
    }
}
static void read(FILE *file, REAL *numbers, int count)
{
    for (int i = 0; i < count; ++i) {
        double x = 0;
        if (fscanf(file, "%lf", &x) != 1) x = 0;
        numbers[i] = (REAL)x;
    }
}
int main(void)
{
    static const REAL limits[JOINTS][2] = {LIMITS};
    FILE *file = fopen("CASES", "r");
    for (int k = 0; file && k < 2000; ++k) {
        REAL elbow, pose[4][4], seed[JOINTS], q[JOINTS], found[8][JOINTS], nearest[JOINTS], way;
        int is_singular[8], joint;
        const char *branch[8];
        read(file, &elbow, 1);
        read(file, pose[0], 16);
        read(file, seed, JOINTS);
        read(file, q, JOINTS);
        const int count = NAME_inverse_kinematics_with_branches((const REAL(*)[4])pose, ELBOWfound, is_singular, branch);
        add_all(count, found, is_singular, branch);
        add((uint64_t)(count < 0 ? -count : 0));
        const int row = NAME_follow(count, found, 0, seed, (REAL)2.5, &joint, &way);
        const REAL first = row < 0 ? (REAL)0 : found[row][0];
        const int within = NAME_within(count, found, is_singular, branch, limits);
        add_all(within, found, is_singular, branch);
        if (NAME_nearest(within, found, limits, seed, nearest) >= 0) {
            for (int i = 0; i < JOINTS; ++i) add_number(nearest[i]);
        }
        if (row >= 0) add_number(first);
        else add((uint64_t)(joint < 0 ? 9 : joint));
        if (row < 0 && joint >= 0) add_number(way);
        ANGLE
    }
    printf("%016llx\n", (unsigned long long)hash);
    return 0;
}
