#include "fingers.h"

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

ROBOT_DYNAMICS_DEVICE void fingers_forward_kinematics_right_tip(const fingers_fields *arm, const double q[2], double forward_kinematics[4][4])
{
    const double p_width = arm->width;
    const double p_length = arm->length;
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double t_1 = p_length * c_2 + p_width;
    const double t_2 = p_length * s_2;
    forward_kinematics[0][0] = c_2;
    forward_kinematics[0][1] = -s_2;
    forward_kinematics[0][2] = 0.0;
    forward_kinematics[0][3] = t_1;
    forward_kinematics[1][0] = s_2;
    forward_kinematics[1][1] = c_2;
    forward_kinematics[1][2] = 0.0;
    forward_kinematics[1][3] = t_2;
    forward_kinematics[2][0] = 0.0;
    forward_kinematics[2][1] = 0.0;
    forward_kinematics[2][2] = 1.0;
    forward_kinematics[2][3] = 0.0;
    forward_kinematics[3][0] = 0.0;
    forward_kinematics[3][1] = 0.0;
    forward_kinematics[3][2] = 0.0;
    forward_kinematics[3][3] = 1.0;
}

ROBOT_DYNAMICS_DEVICE void fingers_jacobian_left_tip(const fingers_fields *arm, const double q[2], double jacobian[6][2])
{
    const double p_length = arm->length;
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double t_1 = p_length * s_1;
    const double t_2 = p_length * c_1;
    jacobian[0][0] = -t_1;
    jacobian[0][1] = 0.0;
    jacobian[1][0] = t_2;
    jacobian[1][1] = 0.0;
    jacobian[2][0] = 0.0;
    jacobian[2][1] = 0.0;
    jacobian[3][0] = 0.0;
    jacobian[3][1] = 0.0;
    jacobian[4][0] = 0.0;
    jacobian[4][1] = 0.0;
    jacobian[5][0] = 1.0;
    jacobian[5][1] = 0.0;
}

ROBOT_DYNAMICS_DEVICE void fingers_wrench_torques_right_tip(const fingers_fields *arm, const double q[2], const double wrench[6], double wrench_torques[2])
{
    const double p_length = arm->length;
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double wrench_1 = wrench[0];
    const double wrench_2 = wrench[1];
    const double wrench_6 = wrench[5];
    const double t_1 = c_2 * wrench_2 - s_2 * wrench_1;
    const double t_2 = p_length * t_1 + wrench_6;
    wrench_torques[0] = 0.0;
    wrench_torques[1] = t_2;
}

ROBOT_DYNAMICS_DEVICE void fingers_pinch(const fingers_fields *arm, const double q[2], double mass_matrix[2][2], double jacobian_left_tip[6][2], double jacobian_right_tip[6][2])
{
    const double p_length = arm->length;
    const double s_1 = ROBOT_DYNAMICS_SIN(q[0]);
    const double c_1 = ROBOT_DYNAMICS_COS(q[0]);
    const double s_2 = ROBOT_DYNAMICS_SIN(q[1]);
    const double c_2 = ROBOT_DYNAMICS_COS(q[1]);
    const double t_1 = p_length * p_length;
    const double t_2 = p_length * s_1;
    const double t_3 = p_length * c_1;
    const double t_4 = p_length * s_2;
    const double t_5 = p_length * c_2;
    mass_matrix[0][0] = 0.0;
    mass_matrix[0][1] = 0.0;
    mass_matrix[1][0] = 0.0;
    mass_matrix[1][1] = t_1;
    jacobian_left_tip[0][0] = -t_2;
    jacobian_left_tip[0][1] = 0.0;
    jacobian_left_tip[1][0] = t_3;
    jacobian_left_tip[1][1] = 0.0;
    jacobian_left_tip[2][0] = 0.0;
    jacobian_left_tip[2][1] = 0.0;
    jacobian_left_tip[3][0] = 0.0;
    jacobian_left_tip[3][1] = 0.0;
    jacobian_left_tip[4][0] = 0.0;
    jacobian_left_tip[4][1] = 0.0;
    jacobian_left_tip[5][0] = 1.0;
    jacobian_left_tip[5][1] = 0.0;
    jacobian_right_tip[0][0] = 0.0;
    jacobian_right_tip[0][1] = -t_4;
    jacobian_right_tip[1][0] = 0.0;
    jacobian_right_tip[1][1] = t_5;
    jacobian_right_tip[2][0] = 0.0;
    jacobian_right_tip[2][1] = 0.0;
    jacobian_right_tip[3][0] = 0.0;
    jacobian_right_tip[3][1] = 0.0;
    jacobian_right_tip[4][0] = 0.0;
    jacobian_right_tip[4][1] = 0.0;
    jacobian_right_tip[5][0] = 0.0;
    jacobian_right_tip[5][1] = 1.0;
}
