#include "two_link_craig.h"

#include <math.h>

#ifndef ROBOT_DYNAMICS_SIN
#define ROBOT_DYNAMICS_SIN sin
#endif
#ifndef ROBOT_DYNAMICS_COS
#define ROBOT_DYNAMICS_COS cos
#endif
#ifndef ROBOT_DYNAMICS_EXP
#define ROBOT_DYNAMICS_EXP exp
#endif

/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivot(double pivot, double diagonal)
{
    const double rounding = diagonal * 2.220446049250313e-16 * 8.0;
    return pivot - rounding > 0.0 && pivot + rounding > 0.0;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_mass_matrix(const two_link_craig_fields *arm, const double q[2], double mass_matrix[2][2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double t_1 = p_m2 + p_m1;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_m2 * p_l2;
    const double t_4 = c_2 * t_3;
    const double t_5 = p_l1 * t_4;
    const double t_6 = p_l2 * t_3;
    const double t_7 = t_6 + t_5;
    const double t_8 = p_l1 * t_2 + t_5;
    const double t_9 = t_7 + t_8;
    mass_matrix[0][0] = t_9;
    mass_matrix[0][1] = t_7;
    mass_matrix[1][0] = t_7;
    mass_matrix[1][1] = t_6;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_coriolis_vector(const two_link_craig_fields *arm, const double q[2], const double qd[2], double coriolis_vector[2])
{
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double t_1 = p_m2 * p_l2;
    const double t_2 = p_l1 * s_2;
    const double t_3 = t_1 * t_2;
    const double t_4 = qd_1 * t_3;
    const double t_5 = qd_2 * t_3 + t_4;
    const double t_6 = t_4 + t_5;
    const double t_7 = qd_2 * t_6;
    const double t_8 = qd_1 * t_4;
    coriolis_vector[0] = -t_7;
    coriolis_vector[1] = t_8;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_gravity_vector(const two_link_craig_fields *arm, const double q[2], double gravity_vector[2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double t_1 = p_m2 + p_m1;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_m2 * p_l2;
    const double t_4 = c_1 * c_2 - s_1 * s_2;
    const double t_5 = t_3 * t_4;
    const double t_6 = c_1 * t_2 + t_5;
    const double t_7 = p_g * t_6;
    const double t_8 = p_g * t_5;
    gravity_vector[0] = t_7;
    gravity_vector[1] = t_8;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_inverse_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double qdd[2], double inverse_dynamics[2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double qdd_1 = qdd[0];
    const double qdd_2 = qdd[1];
    const double t_1 = p_l1 * qdd_1 + p_g * c_1;
    const double t_2 = p_m2 + p_m1;
    const double t_3 = p_l1 * t_2;
    const double t_4 = p_m2 * p_l2;
    const double t_5 = p_l2 * t_4;
    const double t_6 = qdd_1 + qdd_2;
    const double t_7 = c_2 * t_4;
    const double t_8 = s_2 * t_4;
    const double t_9 = qd_1 * qd_1;
    const double t_10 = p_g * s_1 - p_l1 * t_9;
    const double t_11 = t_5 * t_6 - t_8 * t_10;
    const double t_12 = t_7 * t_1 + t_11;
    const double t_13 = qd_1 + qd_2;
    const double t_14 = t_13 * t_13;
    const double t_15 = t_7 * t_6 - t_8 * t_14;
    const double t_16 = t_1 * t_3 + p_l1 * t_15;
    const double t_17 = t_12 + t_16;
    inverse_dynamics[0] = t_17;
    inverse_dynamics[1] = t_12;
}

ROBOT_DYNAMICS_DEVICE int two_link_craig_forward_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double tau[2], double forward_dynamics[2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double tau_1 = tau[0];
    const double tau_2 = tau[1];
    const double t_1 = p_m2 + p_m1;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_g * c_1;
    const double t_4 = p_m2 * p_l2;
    const double t_5 = c_2 * t_4;
    const double t_6 = s_2 * t_4;
    const double t_7 = qd_1 * qd_1;
    const double t_8 = p_g * s_1 - p_l1 * t_7;
    const double t_9 = t_5 * t_3 - t_6 * t_8;
    const double t_10 = qd_1 + qd_2;
    const double t_11 = t_10 * t_10;
    const double t_12 = t_6 * t_11;
    const double t_13 = t_9 - tau_2;
    const double t_14 = p_l2 * t_4;
    const double t_15 = p_l1 * t_5;
    const double t_16 = t_14 + t_15;
    const double t_17 = 1.0 / t_14;
    const double t_18 = t_16 * t_17;
    const double t_19 = tau_1 - t_2 * t_3;
    const double t_20 = p_l1 * t_12 + t_19;
    const double t_21 = t_20 - t_9;
    const double t_22 = t_13 * t_18 + t_21;
    const double t_23 = p_l1 * t_2 + t_15;
    const double t_24 = t_16 + t_23;
    const double t_25 = t_24 - t_16 * t_18;
    const double t_26 = 1.0 / t_25;
    const double t_27 = t_22 * t_26;
    const double t_28 = t_13 * t_17 + t_18 * t_27;
    if (!robot_dynamics_is_pivot(t_14, t_14)) return 2;
    if (!robot_dynamics_is_pivot(t_25, t_24)) return 1;
    forward_dynamics[0] = t_27;
    forward_dynamics[1] = -t_28;
    return 0;
}

ROBOT_DYNAMICS_DEVICE double two_link_craig_kinetic_energy(const two_link_craig_fields *arm, const double q[2], const double qd[2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double t_1 = p_m2 * p_l2;
    const double t_2 = p_l1 * qd_1;
    const double t_3 = c_2 * t_2;
    const double t_4 = qd_1 + qd_2;
    const double t_5 = t_3 * t_4;
    const double t_6 = p_m2 + p_m1;
    const double t_7 = t_2 * t_2;
    const double t_8 = p_l2 * t_1;
    const double t_9 = t_8 * t_4;
    const double t_10 = t_6 * t_7 + t_4 * t_9;
    const double t_11 = 0.5 * t_10 + t_1 * t_5;
    return t_11;
}

ROBOT_DYNAMICS_DEVICE double two_link_craig_potential_energy(const two_link_craig_fields *arm, const double q[2])
{
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double t_1 = p_m2 + p_m1;
    const double t_2 = p_m2 * p_l2;
    const double t_3 = p_l1 * t_1 + c_2 * t_2;
    const double t_4 = s_2 * t_2;
    const double t_5 = c_1 * t_4 + s_1 * t_3;
    const double t_6 = p_g * t_5;
    return t_6;
}
