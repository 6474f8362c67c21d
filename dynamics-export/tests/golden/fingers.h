/**
 * Equations of motion of `Fingers`, written by robot-dynamics.
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
#ifndef FINGERS_H
#define FINGERS_H

/* The specifier of every function: device code compiles it for both sides. */
#ifndef ROBOT_DYNAMICS_DEVICE
#if defined(__CUDACC__) || defined(__HIPCC__)
#define ROBOT_DYNAMICS_DEVICE __host__ __device__
#else
#define ROBOT_DYNAMICS_DEVICE
#endif
#endif

/* Joints that move, and their names from the base outwards. */
#define FINGERS_DOF 2
#define FINGERS_JOINT_NAMES {"left", "right"}

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The symbolic parameters of the table. */
typedef struct {
    double width;
    double length;
} fingers_fields;

/**
 * Forward kinematics: the homogeneous transform of the frame `Right tip` in the base frame, m.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 2 multiplications, 1 addition, sine and cosine of one angle.
 *
 * T13, T23, T31, T32, T34, T41, T42, T43 are zero; T33, T44 are constant; T11, T12, T14, T21, T22, T24 depend on q2.
 *
 * T11 = c2
 * T12 = -s2
 * T13 = 0
 * T14 = width + length c2
 * T21 = s2
 * T22 = c2
 * T23 = 0
 * T24 = length s2
 * T31 = 0
 * T32 = 0
 * T33 = 1
 * T34 = 0
 * T41 = 0
 * T42 = 0
 * T43 = 0
 * T44 = 1
 * with c2 = cos(q2), s2 = sin(q2)
 */
ROBOT_DYNAMICS_DEVICE void fingers_forward_kinematics_right_tip(const fingers_fields *arm, const double q[2], double forward_kinematics[4][4]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `forward_kinematics[i]`: entry i of `forward_kinematics` by rows of 4, one of 16.
 */
ROBOT_DYNAMICS_DEVICE void fingers_forward_kinematics_right_tip_batch(const fingers_fields *arm, const double *const *q, double *const *forward_kinematics, size_t n);

/**
 * Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 2 multiplications, 0 additions, sine and cosine of one angle.
 *
 * J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
 *
 * J11 = -length s1
 * J12 = 0
 * J21 = length c1
 * J22 = 0
 * J31 = 0
 * J32 = 0
 * J41 = 0
 * J42 = 0
 * J51 = 0
 * J52 = 0
 * J61 = 1
 * J62 = 0
 * with c1 = cos(q1), s1 = sin(q1)
 */
ROBOT_DYNAMICS_DEVICE void fingers_jacobian_left_tip(const fingers_fields *arm, const double q[2], double jacobian[6][2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `jacobian[i]`: entry i of `jacobian` by rows of 2, one of 12.
 */
ROBOT_DYNAMICS_DEVICE void fingers_jacobian_left_tip_batch(const fingers_fields *arm, const double *const *q, double *const *jacobian, size_t n);

/**
 * Joint torques J(q)^T w of a wrench at the frame `Right tip`, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.
 *
 * `q`: joint positions, rad; `wrench`: force (N) on the frame `Right tip` and moment (N m) about its origin, fx fy fz nx ny nz in the axes of `jacobian`, that the surroundings apply.
 *
 * Operations: 3 multiplications, 2 additions, sine and cosine of one angle.
 */
ROBOT_DYNAMICS_DEVICE void fingers_wrench_torques_right_tip(const fingers_fields *arm, const double q[2], const double wrench[6], double wrench_torques[2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `wrench[i]`: entry i of `wrench`, one of 6.
 * `wrench_torques[i]`: entry i of `wrench_torques`, one of 2.
 */
ROBOT_DYNAMICS_DEVICE void fingers_wrench_torques_right_tip_batch(const fingers_fields *arm, const double *const *q, const double *const *wrench, double *const *wrench_torques, size_t n);

/**
 * (`mass_matrix`, `jacobian_left_tip`, `jacobian_right_tip`) at one state, as one program.
 *
 * - `0`: Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
 * - `1`: Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 * - `2`: Geometric Jacobian of the frame `Right tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 5 multiplications, 0 additions, sines and cosines of 2 angles.
 *
 * M11, M12 are zero; M22 is constant.
 *
 * `jacobian_left_tip`: J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
 *
 * `jacobian_right_tip`: J11, J21, J31, J32, J41, J42, J51, J52, J61 are zero; J62 is constant; J12, J22 depend on q2.
 *
 * M11 = 0
 * M12 = 0
 * M21 = 0
 * M22 = length^2
 */
ROBOT_DYNAMICS_DEVICE void fingers_pinch(const fingers_fields *arm, const double q[2], double mass_matrix[2][2], double jacobian_left_tip[6][2], double jacobian_right_tip[6][2]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 2.
 * `mass_matrix[i]`: entry i of `mass_matrix` by rows of 2, one of 4.
 * `jacobian_left_tip[i]`: entry i of `jacobian_left_tip` by rows of 2, one of 12.
 * `jacobian_right_tip[i]`: entry i of `jacobian_right_tip` by rows of 2, one of 12.
 */
ROBOT_DYNAMICS_DEVICE void fingers_pinch_batch(const fingers_fields *arm, const double *const *q, double *const *mass_matrix, double *const *jacobian_left_tip, double *const *jacobian_right_tip, size_t n);

#ifdef __cplusplus
}
#endif

#endif
