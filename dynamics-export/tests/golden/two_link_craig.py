"""Equations of motion of `two_link_craig`, written by robot-dynamics.

Each function is proven equal to the textbook Lagrangian. SI units, radians; the last axis of an array has the
entries of a vector, the last two those of a matrix, and the axes before it are broadcast as numpy does.
"""

import numpy

# Degrees of freedom, and the names of the joints that move, from the base outwards.
DOF = 2
JOINT_NAMES = ["joint1", "joint2"]
# The symbolic parameters: attributes of the first argument, `arm`, of every function.
FIELD_NAMES = ["m1", "m2", "l1", "l2", "g"]


def _array(xp, x):
    """An array of what may be a list. One of torch stays as it is, and so do its gradients."""
    return x if hasattr(x, "requires_grad") else xp.asarray(x)


def _entries(xp, x, count):
    """The entries of a vector: those along the last axis of an array."""
    if not hasattr(xp, "stack"):
        return [x[i] for i in range(count)]
    x = _array(xp, x)
    if x.shape[-1:] != (count,):
        raise ValueError(f"expected {count} entries along the last axis, found the shape {tuple(x.shape)}")
    return [x[..., i] for i in range(count)]


def _vector(xp, entries, zero):
    """A vector of its entries: the last axis of an array."""
    if hasattr(xp, "stack"):
        arrays = [_array(xp, entry + zero) for entry in entries]
        return xp.stack(arrays, -1) if arrays else xp.zeros((0,))
    return xp.vertcat(*entries) if hasattr(xp, "vertcat") else xp.Matrix(entries)


def _matrix(xp, rows, zero):
    """A matrix of its rows: the last two axes of an array."""
    if hasattr(xp, "stack"):
        return xp.stack([_vector(xp, row, zero) for row in rows], -2)
    if hasattr(xp, "vertcat"):
        return xp.vertcat(*[xp.horzcat(*row) for row in rows])
    return xp.Matrix(rows)


class SingularMassMatrix(ArithmeticError):
    """M(q) is not positive definite to working precision, or not finite: the pivot of a joint failed."""

    def __init__(self, joint):
        super().__init__(f"the mass matrix is not positive definite at joint {joint + 1} {JOINT_NAMES[joint]!r}")
        self.joint = joint


def _of_pivot(xp, joint, pivot, diagonal):
    """-0 where a pivot of M is greater than the rounding errors of its diagonal entry, else not a number."""
    if not hasattr(xp, "stack"):
        return -0.0
    rounding = diagonal * 2.220446049250313e-16 * 8
    good = (pivot - rounding > 0) & (pivot + rounding > 0)
    if xp is numpy and not numpy.all(good):
        raise SingularMassMatrix(joint)
    return xp.where(xp.asarray(good), -0.0, float("nan"))


def mass_matrix(arm, q, xp=numpy):
    """Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).

    `q`: joint positions, rad.

    Operations: 6 multiplications, 4 additions, sine and cosine of one angle.

    M22 is constant; M11, M12 depend on q2.

    M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2
    M12 = m2 l2^2 + m2 l1 l2 c2
    M21 = m2 l2^2 + m2 l1 l2 c2
    M22 = m2 l2^2
    with c2 = cos(q2)
    """
    q = _entries(xp, q, 2)
    zero = -xp.zeros_like(q[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    c_2 = xp.cos(q[1])
    t_1 = p_m2 * p_l2
    t_2 = c_2 * t_1
    t_3 = p_l1 * t_2
    t_4 = p_m1 + p_m2
    t_5 = p_l1 * t_4
    t_6 = p_l2 * t_1
    t_7 = t_6 + t_3
    t_8 = p_l1 * t_5 + t_3
    t_9 = t_7 + t_8
    return _matrix(xp, [[t_9, t_7], [t_7, t_6]], zero)


def coriolis_vector(arm, q, qd, xp=numpy):
    """Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.

    `q`: joint positions, rad; `qd`: joint velocities, rad per s.

    Operations: 7 multiplications, 2 additions, sine and cosine of one angle.

    V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.

    V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2
    V2 = m2 l1 l2 s2 qd1^2
    with s2 = sin(q2)
    """
    q = _entries(xp, q, 2)
    qd = _entries(xp, qd, 2)
    zero = -xp.zeros_like(q[0]) - xp.zeros_like(qd[0]) if hasattr(xp, "stack") else -0.0
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    s_2 = xp.sin(q[1])
    qd_1 = qd[0]
    qd_2 = qd[1]
    t_1 = p_m2 * p_l2
    t_2 = p_l1 * s_2
    t_3 = t_1 * t_2
    t_4 = qd_1 * t_3
    t_5 = qd_2 * t_3 + t_4
    t_6 = t_4 + t_5
    t_7 = qd_2 * t_6
    t_8 = qd_1 * t_4
    return _vector(xp, [-t_7, t_8], zero)


def gravity_vector(arm, q, xp=numpy):
    """Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.

    `q`: joint positions, rad.

    Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.

    G1, G2 depend on q1, q2.

    G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
    G2 = m2 l2 g c12
    with c1 = cos(q1), c12 = cos(q1 + q2)
    """
    q = _entries(xp, q, 2)
    zero = -xp.zeros_like(q[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    p_g = arm.g
    c_1 = xp.cos(q[0])
    s_1 = xp.sin(q[0])
    c_2 = xp.cos(q[1])
    s_2 = xp.sin(q[1])
    t_1 = p_m1 + p_m2
    t_2 = p_l1 * t_1
    t_3 = p_m2 * p_l2
    t_4 = c_1 * c_2 - s_1 * s_2
    t_5 = t_3 * t_4
    t_6 = c_1 * t_2 + t_5
    t_7 = p_g * t_6
    t_8 = p_g * t_5
    return _vector(xp, [t_7, t_8], zero)


def inverse_dynamics(arm, q, qd, qdd, xp=numpy):
    """Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.

    `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.

    Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.

    tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.

    tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
    tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
    with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
    """
    q = _entries(xp, q, 2)
    qd = _entries(xp, qd, 2)
    qdd = _entries(xp, qdd, 2)
    zero = -xp.zeros_like(q[0]) - xp.zeros_like(qd[0]) - xp.zeros_like(qdd[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    p_g = arm.g
    c_1 = xp.cos(q[0])
    s_1 = xp.sin(q[0])
    c_2 = xp.cos(q[1])
    s_2 = xp.sin(q[1])
    qd_1 = qd[0]
    qd_2 = qd[1]
    qdd_1 = qdd[0]
    qdd_2 = qdd[1]
    t_1 = p_m2 * p_l2
    t_2 = c_2 * t_1
    t_3 = qdd_1 + qdd_2
    t_4 = s_2 * t_1
    t_5 = qd_1 + qd_2
    t_6 = t_5 * t_5
    t_7 = t_2 * t_3 - t_4 * t_6
    t_8 = p_m1 + p_m2
    t_9 = p_l1 * t_8
    t_10 = p_l1 * qdd_1 + p_g * c_1
    t_11 = qd_1 * qd_1
    t_12 = p_g * s_1 - p_l1 * t_11
    t_13 = p_l2 * t_1
    t_14 = t_13 * t_3 + t_2 * t_10
    t_15 = t_14 - t_4 * t_12
    t_16 = t_9 * t_10 + p_l1 * t_7
    t_17 = t_15 + t_16
    return _vector(xp, [t_17, t_15], zero)


def forward_dynamics(arm, q, qd, tau, xp=numpy):
    """Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.

    `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.

    Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.

    Raises `SingularMassMatrix` if M(q) is not positive definite to working precision or not finite, at one state of several. Other arrays than numpy's have NaN there; symbols are not tested.
    """
    q = _entries(xp, q, 2)
    qd = _entries(xp, qd, 2)
    tau = _entries(xp, tau, 2)
    zero = -xp.zeros_like(q[0]) - xp.zeros_like(qd[0]) - xp.zeros_like(tau[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    p_g = arm.g
    c_1 = xp.cos(q[0])
    s_1 = xp.sin(q[0])
    s_2 = xp.sin(q[1])
    c_2 = xp.cos(q[1])
    qd_1 = qd[0]
    qd_2 = qd[1]
    tau_1 = tau[0]
    tau_2 = tau[1]
    t_1 = p_m2 * p_l2
    t_2 = s_2 * t_1
    t_3 = qd_1 + qd_2
    t_4 = t_3 * t_3
    t_5 = t_2 * t_4
    t_6 = c_2 * t_1
    t_7 = p_g * c_1
    t_8 = qd_1 * qd_1
    t_9 = p_g * s_1 - p_l1 * t_8
    t_10 = t_6 * t_7 - t_2 * t_9
    t_11 = p_m1 + p_m2
    t_12 = p_l1 * t_11
    t_13 = t_10 - tau_2
    t_14 = p_l2 * t_1
    t_15 = p_l1 * t_6
    t_16 = t_14 + t_15
    t_17 = 1.0 / t_14
    t_18 = t_16 * t_17
    t_19 = tau_1 - t_12 * t_7
    t_20 = p_l1 * t_5 + t_19
    t_21 = t_20 - t_10
    t_22 = t_13 * t_18 + t_21
    t_23 = p_l1 * t_12 + t_15
    t_24 = t_16 + t_23
    t_25 = t_24 - t_16 * t_18
    t_26 = 1.0 / t_25
    t_27 = t_22 * t_26
    t_28 = t_13 * t_17 + t_18 * t_27
    zero = zero + _of_pivot(xp, 1, t_14, t_14)
    zero = zero + _of_pivot(xp, 0, t_25, t_24)
    return _vector(xp, [t_27, -t_28], zero)


def kinetic_energy(arm, q, qd, xp=numpy):
    """Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.

    `q`: joint positions, rad; `qd`: joint velocities, rad per s.

    Operations: 11 multiplications, 4 additions, sine and cosine of one angle.

    T = (1/2 l1^2 (m1 + m2) + 1/2 m2 l2^2 + m2 l1 l2 c2) qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qd1 qd2 + 1/2 m2 l2^2 qd2^2
    with c2 = cos(q2)
    """
    q = _entries(xp, q, 2)
    qd = _entries(xp, qd, 2)
    zero = -xp.zeros_like(q[0]) - xp.zeros_like(qd[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    c_2 = xp.cos(q[1])
    qd_1 = qd[0]
    qd_2 = qd[1]
    t_1 = p_m2 * p_l2
    t_2 = p_l1 * qd_1
    t_3 = c_2 * t_2
    t_4 = qd_1 + qd_2
    t_5 = t_3 * t_4
    t_6 = p_m1 + p_m2
    t_7 = t_6 * t_2
    t_8 = p_l2 * t_1
    t_9 = t_8 * t_4
    t_10 = t_2 * t_7 + t_4 * t_9
    t_11 = 0.5 * t_10 + t_1 * t_5
    return t_11 + zero


def potential_energy(arm, q, xp=numpy):
    """Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.

    `q`: joint positions, rad.

    Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.

    U = l1 g (m1 + m2) s1 + m2 l2 g s12
    with s1 = sin(q1), s12 = sin(q1 + q2)
    """
    q = _entries(xp, q, 2)
    zero = -xp.zeros_like(q[0]) if hasattr(xp, "stack") else -0.0
    p_m1 = arm.m1
    p_m2 = arm.m2
    p_l1 = arm.l1
    p_l2 = arm.l2
    p_g = arm.g
    s_1 = xp.sin(q[0])
    c_1 = xp.cos(q[0])
    c_2 = xp.cos(q[1])
    s_2 = xp.sin(q[1])
    t_1 = p_m1 + p_m2
    t_2 = p_m2 * p_l2
    t_3 = p_l1 * t_1 + c_2 * t_2
    t_4 = s_2 * t_2
    t_5 = c_1 * t_4 + s_1 * t_3
    t_6 = p_g * t_5
    return t_6 + zero
