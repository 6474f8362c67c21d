
/** Sines and cosines of a column of angles. */
ROBOT_DYNAMICS_APART void robot_dynamics_sin_cos_column(const REAL *x, REAL *sines, REAL *cosines, size_t n)
{
    WORD unusual = 0u;
    size_t k;
    ROBOT_DYNAMICS_LANES
    for (k = 0; k < n; ++k) {
        unusual |= !((x[k] >= -LARGEST) & (x[k] <= LARGEST));
        robot_dynamics_sin_cos_of_1(x + k, sines + k, cosines + k);
    }
    for (k = 0; unusual && k < n; ++k) robot_dynamics_sin_cos(x[k], sines + k, cosines + k);
}
