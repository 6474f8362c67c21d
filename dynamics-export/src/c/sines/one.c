
/** Sine and cosine of one angle. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_1(REAL x, REAL *sine, REAL *cosine)
{
#ifdef ROBOT_DYNAMICS_VECTORS
    if (ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos_of_1(&x, sine, cosine);
        return;
    }
#endif
    robot_dynamics_sin_cos(x, sine, cosine);
}
