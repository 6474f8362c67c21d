
/** A number and its bits. C99 lets one be read as the other (6.5.2.3), and so do compilers of C++: no function is called. */
typedef union { REAL real; WORD bits; } robot_dynamics_number_@;

/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_@(const REAL *n, const REAL *s, const REAL *c, REAL *sine, REAL *cosine)
{
    robot_dynamics_number_@ turns, a, b;
    WORD other;
    turns.real = *n;
    a.real = *s;
    b.real = *c;
    other = (a.bits ^ b.bits) & -(turns.bits & 1u);
    a.bits ^= other ^ turns.bits >> 1 << SIGN;
    b.bits ^= other ^ (turns.bits ^ turns.bits >> 1) << SIGN;
    *sine = a.real;
    *cosine = b.real;
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
