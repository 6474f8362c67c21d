
/** Whether an angle needs no reduction in integers; not so for what is no number. */
#define ROBOT_DYNAMICS_IS_USUAL(x) ((x) >= -LARGEST && (x) <= LARGEST)

/** Sine and cosine of any angle: less than a unit in the last place off, NaN of what is not finite. */
ROBOT_DYNAMICS_APART void robot_dynamics_sin_cos(REAL x, REAL *sine, REAL *cosine)
{
    REAL n, rest, excess, s, c;
    const REAL size = x < ZERO ? -x : x;
    if (ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos_of_1(&x, sine, cosine);
        return;
    }
    if (!(size <= FINITE)) {
        *sine = *cosine = x - x;
        return;
    }
    robot_dynamics_reduce_large(size, &n, &rest, &excess);
    robot_dynamics_sine_1(&rest, &excess, &s);
    robot_dynamics_cosine_1(&rest, &excess, &c);
    robot_dynamics_turn_1(&n, &s, &c, sine, cosine);
    if (x < ZERO) *sine = -*sine;
}
