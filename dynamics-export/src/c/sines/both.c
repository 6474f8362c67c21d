
/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_@(const REAL *n, const REAL *s, const REAL *c, REAL *sine, REAL *cosine)
{
    WORD turns, a, b, other;
    memcpy(&turns, n, sizeof turns);
    memcpy(&a, s, sizeof a);
    memcpy(&b, c, sizeof b);
    other = (a ^ b) & -(turns & 1u);
    a ^= other ^ turns >> 1 << SIGN;
    b ^= other ^ (turns ^ turns >> 1) << SIGN;
    memcpy(sine, &a, sizeof a);
    memcpy(cosine, &b, sizeof b);
}

/** Sines and cosines of angles of magnitude up to LARGEST, without a branch. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_of_@(const REAL *x, REAL *sine, REAL *cosine)
{
    REAL n, rest, excess, s, c;
    robot_dynamics_reduce_@(x, &n, &rest, &excess);
    robot_dynamics_sine_@(&rest, &excess, &s);
    robot_dynamics_cosine_@(&rest, &excess, &c);
    robot_dynamics_turn_@(&n, &s, &c, sine, cosine);
}
