
/** The PART alone, with the digits that it has beside the other: a branch between the polynomials is predicted. */
ROBOT_DYNAMICS_INLINE REAL robot_dynamics_NAME(REAL x)
{
    REAL rest, excess, sine, cosine;
    robot_dynamics_number_1 turns, value;
    if (!ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos(x, &sine, &cosine);
        return PART;
    }
    robot_dynamics_reduce_1(&x, &turns.real, &rest, &excess);
    if ((turns.bits & 1u) == PARITY) {
        robot_dynamics_sine_1(&rest, &excess, &value.real);
    } else {
        robot_dynamics_cosine_1(&rest, &excess, &value.real);
    }
    value.bits ^= TURN << SIGN;
    return value.real;
}
