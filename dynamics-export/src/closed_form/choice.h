
/**
 * The solutions within ranges of the joints, rows of lower and upper ends, infinite where a joint has none. Angles outside of their
 * range get whole turns that bring them into it. The count is that of inverse kinematics, whose rows, marks and names (or 0 for
 * these) are moved to the front. Returns how many are left; a count below 0 as it is.
 */
int NAME_within(int count, REAL q[][JOINTS], int is_singular[], const char *branch[], const REAL limits[JOINTS][2]);

/**
 * Writes the solution whose joints have the least sum of squares of their ways from a seed, whole turns left out, and returns its row;
 * -1 if there is none, or the seed is not finite. With limits (or 0) whole turns are added that bring it nearest to the seed
 * within them: solutions then are those of NAME_within. q is only read.
 */
int NAME_nearest(int count, REAL q[][JOINTS], const REAL (*limits)[2], const REAL seed[JOINTS], REAL nearest[JOINTS]);

/**
 * The row of the solution that continues a path: the nearest to the position before it, if no joint moves by more than `most`, rad or m.
 * Else -1: the branch ends. `joint` is the joint that moves farthest, from 0, and `way` its way; -1 and the largest number if there
 * is no solution. Ways leave whole turns out, and stay within limits (or 0). q is only read.
 */
int NAME_follow(int count, REAL q[][JOINTS], const REAL (*limits)[2], const REAL last[JOINTS], REAL most, int *joint, REAL *way);
