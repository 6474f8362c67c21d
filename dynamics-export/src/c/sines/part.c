
/** The PART alone, with the digits that it has beside the other: a branch between the polynomials is predicted. */
ROBOT_DYNAMICS_INLINE REAL robot_dynamics_NAME(REAL x)
{
    REAL n, rest, excess, value, sine, cosine;
    WORD turns, bits;
    if (!ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos(x, &sine, &cosine);
        return PART;
    }
    robot_dynamics_reduce_1(&x, &n, &rest, &excess);
    memcpy(&turns, &n, sizeof turns);
    if ((turns & 1u) == PARITY) {
        robot_dynamics_sine_1(&rest, &excess, &value);
    } else {
        robot_dynamics_cosine_1(&rest, &excess, &value);
    }
    memcpy(&bits, &value, sizeof bits);
    bits ^= TURN << SIGN;
    memcpy(&value, &bits, sizeof value);
    return value;
}
