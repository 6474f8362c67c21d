/**
 * Equations of motion of `two_link_craig`, written by robot-dynamics.
 *
 * Each function is proven equal to the textbook Lagrangian. SI units, radians; matrices by rows.
 * Nothing is allocated, no state is kept. A value that depends on an input that is not finite is not finite.
 *
 * Functions whose names end in `_batch` take columns of states, with the digits of the functions of one state, and are
 * turned into lanes by `-O3 -march=native`. A column that is written may be one that is read, and overlaps no other.
 *
 * Sines are in the source. Values have the digits of Rust's in a build for the same processor, whatever the compiler
 * and its level: products are fused with sums where Rust fuses them, if the processor has an instruction for it. That is
 * so of gcc and clang. -ffast-math, /fp:fast and the registers of an x87 are refused. It is not so of an exponential
 * (Stribeck's friction), which is the C library's, and of what depends on it.
 */
#ifndef TWO_LINK_CRAIG_H
#define TWO_LINK_CRAIG_H

/* The specifier of every function: device code compiles it for both sides. */
#ifndef ROBOT_DYNAMICS_DEVICE
#if defined(__CUDACC__) || defined(__HIPCC__)
#define ROBOT_DYNAMICS_DEVICE __host__ __device__
#else
#define ROBOT_DYNAMICS_DEVICE
#endif
#endif

/* Joints that move, and their names from the base outwards. */
#define TWO_LINK_CRAIG_DOF 2
#define TWO_LINK_CRAIG_JOINT_NAMES {"joint1", "joint2"}

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The symbolic parameters of the table. */
typedef struct {
    double m1;
    double m2;
    double l1;
    double l2;
    double g;
} two_link_craig_fields;

/**
 * Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
 *
 * `q`: joint positions, rad.
 *
 * Operations: 6 multiplications, 4 additions, sine and cosine of one angle.
 *
 * M22 is constant; M11, M12 depend on q2.
 *
 * M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2
 * M12 = m2 l2^2 + m2 l1 l2 c2
 * M21 = m2 l2^2 + m2 l1 l2 c2
 * M22 = m2 l2^2
 * with c2 = cos(q2)
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_mass_matrix(const two_link_craig_fields *arm, const double q[2], double mass_matrix[2][2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `mass_matrix[i]`: entry i of `mass_matrix` by rows of 2, one of 4.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_mass_matrix_batch(const two_link_craig_fields *arm, const double *const *q, double *const *mass_matrix, size_t n);

/**
 * Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s.
 *
 * Operations: 7 multiplications, 2 additions, sine and cosine of one angle.
 *
 * V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
 *
 * V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2
 * V2 = m2 l1 l2 s2 qd1^2
 * with s2 = sin(q2)
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_coriolis_vector(const two_link_craig_fields *arm, const double q[2], const double qd[2], double coriolis_vector[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `qd[i]`: entry i of `qd`, one of 2.
 * `coriolis_vector[i]`: entry i of `coriolis_vector`, one of 2.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_coriolis_vector_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, double *const *coriolis_vector, size_t n);

/**
 * Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
 *
 * G1, G2 depend on q1, q2.
 *
 * G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
 * G2 = m2 l2 g c12
 * with c1 = cos(q1), c12 = cos(q1 + q2)
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_gravity_vector(const two_link_craig_fields *arm, const double q[2], double gravity_vector[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `gravity_vector[i]`: entry i of `gravity_vector`, one of 2.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_gravity_vector_batch(const two_link_craig_fields *arm, const double *const *q, double *const *gravity_vector, size_t n);

/**
 * Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
 *
 * Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
 *
 * tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
 *
 * tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
 * tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
 * with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_inverse_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double qdd[2], double inverse_dynamics[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `qd[i]`: entry i of `qd`, one of 2.
 * `qdd[i]`: entry i of `qdd`, one of 2.
 * `inverse_dynamics[i]`: entry i of `inverse_dynamics`, one of 2.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_inverse_dynamics_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, const double *const *qdd, double *const *inverse_dynamics, size_t n);

/**
 * Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
 *
 * Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.
 *
 * Returns 0; or, where M(q) is not positive definite to working precision or not finite, the number of the joint whose pivot failed, counted from 1, and writes nothing.
 */
ROBOT_DYNAMICS_DEVICE int two_link_craig_forward_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double tau[2], double forward_dynamics[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `qd[i]`: entry i of `qd`, one of 2.
 * `tau[i]`: entry i of `tau`, one of 2.
 * `forward_dynamics[i]`: entry i of `forward_dynamics`, one of 2.
 * Returns 0; or the number of the first state, counted from 1, that the function of one state refuses. All values of such a state are NaN.
 */
ROBOT_DYNAMICS_DEVICE size_t two_link_craig_forward_dynamics_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, const double *const *tau, double *const *forward_dynamics, size_t n);

/**
 * Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s.
 *
 * Operations: 11 multiplications, 4 additions, sine and cosine of one angle.
 *
 * T = (1/2 l1^2 (m1 + m2) + 1/2 m2 l2^2 + m2 l1 l2 c2) qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qd1 qd2 + 1/2 m2 l2^2 qd2^2
 * with c2 = cos(q2)
 */
ROBOT_DYNAMICS_DEVICE double two_link_craig_kinetic_energy(const two_link_craig_fields *arm, const double q[2], const double qd[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `qd[i]`: entry i of `qd`, one of 2.
 * `kinetic_energy`: the value.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_kinetic_energy_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, double *kinetic_energy, size_t n);

/**
 * Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.
 *
 * U = l1 g (m1 + m2) s1 + m2 l2 g s12
 * with s1 = sin(q1), s12 = sin(q1 + q2)
 */
ROBOT_DYNAMICS_DEVICE double two_link_craig_potential_energy(const two_link_craig_fields *arm, const double q[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `potential_energy`: the value.
 */
ROBOT_DYNAMICS_DEVICE void two_link_craig_potential_energy_batch(const two_link_craig_fields *arm, const double *const *q, double *potential_energy, size_t n);

#ifdef __cplusplus
}
#endif

#endif
