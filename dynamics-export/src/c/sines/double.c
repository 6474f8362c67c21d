
/** x = n pi/2 + rest - excess (Cody and Waite 1980). Products with the parts of pi/2 are exact; `n` ends in the bits of n. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_reduce_@(const REAL *x, REAL *n, REAL *rest, REAL *excess)
{
    const REAL shifted = *x * 0.6366197723675814 + 6755399441055744.0;
    const REAL turns = shifted - 6755399441055744.0;
    const REAL first = *x - turns * 1.5707963267923333;
    const REAL second = turns * 2.5633441515839558e-12;
    *n = shifted;
    *rest = first - second;
    *excess = turns * 1.0562999066987428e-23 + ((*rest - first) + second);
}

/** sin (x - d) by a minimax polynomial: |x| is at most a little above pi/4, and d below its last place. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sine_@(const REAL *x, const REAL *d, REAL *sine)
{
    const REAL z = *x * *x, cube = *x * z, zz = z * z, fifth = z * cube;
    const REAL w = 1.0 - 0.5 * z;
    const REAL upper = (-2.755731369191555e-06 + z * 2.505075811569819e-08) + zz * -1.5896795713489563e-10;
    const REAL lower = fifth * (-0.008333333333322413 + z * 0.00019841269829807778) + *d * w;
    *sine = *x - (cube * 0.16666666666666632 + (lower + (zz * fifth) * upper));
}

/** cos (x - d): the rounding of w = 1 - x^2/2 is made good. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_cosine_@(const REAL *x, const REAL *d, REAL *cosine)
{
    const REAL z = *x * *x, zz = z * z;
    const REAL half_z = 0.5 * z, w = 1.0 - half_z;
    const REAL lost = (1.0 - w) - half_z;
    const REAL upper = (2.480158728948234e-05 + z * -2.7557314352372173e-07)
        + zz * (2.0875723278132235e-09 + z * -1.1359648042271599e-11);
    const REAL lower = zz * (0.0416666666666666 + z * -0.0013888888888874125) + *x * *d;
    *cosine = w + ((lost + lower) + (zz * zz) * upper);
}
