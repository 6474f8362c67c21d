% mass_matrix.m
function value = mass_matrix(arm, q)
%MASS_MATRIX
%   Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
%
%   `q`: joint positions, rad.
%
%   Operations: 6 multiplications, 4 additions, sine and cosine of one angle.
%
%   M22 is constant; M11, M12 depend on q2.
%
%   M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2
%   M12 = m2 l2^2 + m2 l1 l2 c2
%   M21 = m2 l2^2 + m2 l1 l2 c2
%   M22 = m2 l2^2
%   with c2 = cos(q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    zero = -0 - zeros(1, size(q, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    c_2 = cos(q(2, :));
    t_1 = p_m2 .* p_l2;
    t_2 = c_2 .* t_1;
    t_3 = p_l1 .* t_2;
    t_4 = p_m1 + p_m2;
    t_5 = p_l1 .* t_4;
    t_6 = p_l2 .* t_1;
    t_7 = t_6 + t_3;
    t_8 = p_l1 .* t_5 + t_3;
    t_9 = t_7 + t_8;
    value = reshape([t_9 + zero; t_7 + zero; t_7 + zero; t_6 + zero], 2, 2, []);
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

% coriolis_vector.m
function value = coriolis_vector(arm, q, qd)
%CORIOLIS_VECTOR
%   Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
%
%   `q`: joint positions, rad; `qd`: joint velocities, rad per s.
%
%   Operations: 7 multiplications, 2 additions, sine and cosine of one angle.
%
%   V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
%
%   V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2
%   V2 = m2 l1 l2 s2 qd1^2
%   with s2 = sin(q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    check_rows('qd', qd, 2);
    zero = -0 - zeros(1, size(q, 2)) - zeros(1, size(qd, 2));
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    s_2 = sin(q(2, :));
    qd_1 = qd(1, :);
    qd_2 = qd(2, :);
    t_1 = p_m2 .* p_l2;
    t_2 = p_l1 .* s_2;
    t_3 = t_1 .* t_2;
    t_4 = qd_1 .* t_3;
    t_5 = qd_2 .* t_3 + t_4;
    t_6 = t_4 + t_5;
    t_7 = qd_2 .* t_6;
    t_8 = qd_1 .* t_4;
    value = [-t_7 + zero; t_8 + zero];
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

% gravity_vector.m
function value = gravity_vector(arm, q)
%GRAVITY_VECTOR
%   Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
%
%   `q`: joint positions, rad.
%
%   Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
%
%   G1, G2 depend on q1, q2.
%
%   G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
%   G2 = m2 l2 g c12
%   with c1 = cos(q1), c12 = cos(q1 + q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    zero = -0 - zeros(1, size(q, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    p_g = arm.g;
    c_1 = cos(q(1, :));
    s_1 = sin(q(1, :));
    c_2 = cos(q(2, :));
    s_2 = sin(q(2, :));
    t_1 = p_m1 + p_m2;
    t_2 = p_l1 .* t_1;
    t_3 = p_m2 .* p_l2;
    t_4 = c_1 .* c_2 - s_1 .* s_2;
    t_5 = t_3 .* t_4;
    t_6 = c_1 .* t_2 + t_5;
    t_7 = p_g .* t_6;
    t_8 = p_g .* t_5;
    value = [t_7 + zero; t_8 + zero];
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

% inverse_dynamics.m
function value = inverse_dynamics(arm, q, qd, qdd)
%INVERSE_DYNAMICS
%   Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
%
%   `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
%
%   Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
%
%   tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
%
%   tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
%   tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
%   with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    check_rows('qd', qd, 2);
    check_rows('qdd', qdd, 2);
    zero = -0 - zeros(1, size(q, 2)) - zeros(1, size(qd, 2)) - zeros(1, size(qdd, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    p_g = arm.g;
    c_1 = cos(q(1, :));
    s_1 = sin(q(1, :));
    c_2 = cos(q(2, :));
    s_2 = sin(q(2, :));
    qd_1 = qd(1, :);
    qd_2 = qd(2, :);
    qdd_1 = qdd(1, :);
    qdd_2 = qdd(2, :);
    t_1 = p_m2 .* p_l2;
    t_2 = c_2 .* t_1;
    t_3 = qdd_1 + qdd_2;
    t_4 = s_2 .* t_1;
    t_5 = qd_1 + qd_2;
    t_6 = t_5 .* t_5;
    t_7 = t_2 .* t_3 - t_4 .* t_6;
    t_8 = p_m1 + p_m2;
    t_9 = p_l1 .* t_8;
    t_10 = p_l1 .* qdd_1 + p_g .* c_1;
    t_11 = qd_1 .* qd_1;
    t_12 = p_g .* s_1 - p_l1 .* t_11;
    t_13 = p_l2 .* t_1;
    t_14 = t_13 .* t_3 + t_2 .* t_10;
    t_15 = t_14 - t_4 .* t_12;
    t_16 = t_9 .* t_10 + p_l1 .* t_7;
    t_17 = t_15 + t_16;
    value = [t_17 + zero; t_15 + zero];
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

% forward_dynamics.m
function value = forward_dynamics(arm, q, qd, tau)
%FORWARD_DYNAMICS
%   Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
%
%   `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
%
%   Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.
%
%   Fails with `robot_dynamics:SingularMassMatrix` if M(q) is not positive definite to working precision or not finite, at one state of several.
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    check_rows('qd', qd, 2);
    check_rows('tau', tau, 2);
    zero = -0 - zeros(1, size(q, 2)) - zeros(1, size(qd, 2)) - zeros(1, size(tau, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    p_g = arm.g;
    c_1 = cos(q(1, :));
    s_1 = sin(q(1, :));
    s_2 = sin(q(2, :));
    c_2 = cos(q(2, :));
    qd_1 = qd(1, :);
    qd_2 = qd(2, :);
    tau_1 = tau(1, :);
    tau_2 = tau(2, :);
    t_1 = p_m2 .* p_l2;
    t_2 = s_2 .* t_1;
    t_3 = qd_1 + qd_2;
    t_4 = t_3 .* t_3;
    t_5 = t_2 .* t_4;
    t_6 = c_2 .* t_1;
    t_7 = p_g .* c_1;
    t_8 = qd_1 .* qd_1;
    t_9 = p_g .* s_1 - p_l1 .* t_8;
    t_10 = t_6 .* t_7 - t_2 .* t_9;
    t_11 = p_m1 + p_m2;
    t_12 = p_l1 .* t_11;
    t_13 = t_10 - tau_2;
    t_14 = p_l2 .* t_1;
    t_15 = p_l1 .* t_6;
    t_16 = t_14 + t_15;
    t_17 = 1.0 ./ t_14;
    t_18 = t_16 .* t_17;
    t_19 = tau_1 - t_12 .* t_7;
    t_20 = p_l1 .* t_5 + t_19;
    t_21 = t_20 - t_10;
    t_22 = t_13 .* t_18 + t_21;
    t_23 = p_l1 .* t_12 + t_15;
    t_24 = t_16 + t_23;
    t_25 = t_24 - t_16 .* t_18;
    t_26 = 1.0 ./ t_25;
    t_27 = t_22 .* t_26;
    t_28 = t_13 .* t_17 + t_18 .* t_27;
    test_pivot(2, t_14, t_14);
    test_pivot(1, t_25, t_24);
    value = [t_27 + zero; -t_28 + zero];
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

function test_pivot(joint, pivot, diagonal)
    % Whether a pivot of M is greater than the rounding errors of its diagonal entry, at all states.
    rounding = diagonal * (8 * eps);
    if ~all(pivot - rounding > 0 & pivot + rounding > 0)
        error('robot_dynamics:SingularMassMatrix', 'the mass matrix is not positive definite at joint %d', joint);
    end
end

% kinetic_energy.m
function value = kinetic_energy(arm, q, qd)
%KINETIC_ENERGY
%   Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
%
%   `q`: joint positions, rad; `qd`: joint velocities, rad per s.
%
%   Operations: 11 multiplications, 4 additions, sine and cosine of one angle.
%
%   T = (1/2 l1^2 (m1 + m2) + 1/2 m2 l2^2 + m2 l1 l2 c2) qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qd1 qd2 + 1/2 m2 l2^2 qd2^2
%   with c2 = cos(q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    check_rows('qd', qd, 2);
    zero = -0 - zeros(1, size(q, 2)) - zeros(1, size(qd, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    c_2 = cos(q(2, :));
    qd_1 = qd(1, :);
    qd_2 = qd(2, :);
    t_1 = p_m2 .* p_l2;
    t_2 = p_l1 .* qd_1;
    t_3 = c_2 .* t_2;
    t_4 = qd_1 + qd_2;
    t_5 = t_3 .* t_4;
    t_6 = p_m1 + p_m2;
    t_7 = t_6 .* t_2;
    t_8 = p_l2 .* t_1;
    t_9 = t_8 .* t_4;
    t_10 = t_2 .* t_7 + t_4 .* t_9;
    t_11 = 0.5 .* t_10 + t_1 .* t_5;
    value = t_11 + zero;
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end

% potential_energy.m
function value = potential_energy(arm, q)
%POTENTIAL_ENERGY
%   Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.
%
%   `q`: joint positions, rad.
%
%   Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.
%
%   U = l1 g (m1 + m2) s1 + m2 l2 g s12
%   with s1 = sin(q1), s12 = sin(q1 + q2)
%
%   `arm`: a struct of the symbolic parameters m1, m2, l1, l2, g.
%
%   A function of `two_link_craig`, written by robot-dynamics.
%   Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too.
    check_rows('q', q, 2);
    zero = -0 - zeros(1, size(q, 2));
    p_m1 = arm.m1;
    p_m2 = arm.m2;
    p_l1 = arm.l1;
    p_l2 = arm.l2;
    p_g = arm.g;
    s_1 = sin(q(1, :));
    c_1 = cos(q(1, :));
    c_2 = cos(q(2, :));
    s_2 = sin(q(2, :));
    t_1 = p_m1 + p_m2;
    t_2 = p_m2 .* p_l2;
    t_3 = p_l1 .* t_1 + c_2 .* t_2;
    t_4 = s_2 .* t_2;
    t_5 = c_1 .* t_4 + s_1 .* t_3;
    t_6 = p_g .* t_5;
    value = t_6 + zero;
end

function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end
