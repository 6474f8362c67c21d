/**
 * Equations of motion of `ur5_robot`, written by robot-dynamics.
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
#ifndef UR5_ROBOT_H
#define UR5_ROBOT_H

/* The specifier of every function: device code compiles it for both sides. */
#ifndef ROBOT_DYNAMICS_DEVICE
#if defined(__CUDACC__) || defined(__HIPCC__)
#define ROBOT_DYNAMICS_DEVICE __host__ __device__
#else
#define ROBOT_DYNAMICS_DEVICE
#endif
#endif

/* Joints that move, and their names from the base outwards. */
#define UR5_ROBOT_DOF 6
#define UR5_ROBOT_JOINT_NAMES {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"}

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 9 multiplications, 5 additions, sines and cosines of 3 angles.
 *
 * G1, G5, G6 are zero; G2, G3, G4 depend on q2 to q4.
 */
ROBOT_DYNAMICS_DEVICE void ur5_robot_gravity_vector(const double q[6], double gravity_vector[6]);

/**
 * The same at `n` states, in columns with one number for each state.
 * `q[i]`: entry i of `q`, one of 6.
 * `gravity_vector[i]`: entry i of `gravity_vector`, one of 6.
 */
ROBOT_DYNAMICS_DEVICE void ur5_robot_gravity_vector_batch(const double *const *q, double *const *gravity_vector, size_t n);

#ifdef __cplusplus
}
#endif

#endif
