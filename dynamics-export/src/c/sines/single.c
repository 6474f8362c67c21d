
/** x = n pi/2 + rest - excess (Cody and Waite 1980). Products with the parts of pi/2 are exact; `n` ends in the bits of n. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_reduce_@(const REAL *x, REAL *n, REAL *rest, REAL *excess)
{
    const REAL shifted = *x * 0.63661975f + 12582912.0f;
    const REAL turns = shifted - 12582912.0f;
    const REAL second = (*x - turns * 1.5703125f) - turns * 0.0004837513f;
    const REAL third = turns * 7.5495336e-8f;
    *n = shifted;
    *rest = second - third;
    *excess = turns * 2.563344e-12f + ((*rest - second) + third);
}

/** sin (x - d) by a minimax polynomial: |x| is at most a little above pi/4, and d below its last place. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sine_@(const REAL *x, const REAL *d, REAL *sine)
{
    const REAL z = *x * *x, cube = *x * z;
    const REAL w = 1.0f - 0.5f * z;
    *sine = *x - ((cube * 0.16666655f + *d * w) + (z * cube) * (-0.008332187f + z * 0.00019517897f));
}

/** cos (x - d): the rounding of w = 1 - x^2/2 is made good. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_cosine_@(const REAL *x, const REAL *d, REAL *cosine)
{
    const REAL z = *x * *x, zz = z * z;
    const REAL half_z = 0.5f * z, w = 1.0f - half_z;
    const REAL lower = zz * (0.041666646f + z * -0.0013887301f) + (((1.0f - w) - half_z) + *x * *d);
    *cosine = w + (lower + (zz * zz) * 2.443067e-5f);
}
