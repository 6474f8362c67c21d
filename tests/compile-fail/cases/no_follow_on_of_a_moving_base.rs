//! A program that uses refused robots whose base moves has no other error.

use robot_dynamics::nalgebra::{SMatrix, SVector, Vector3, Vector6};
use robot_dynamics::{Pose, Simulation, check_against_rnea, robot_dynamics};

/// A refused function.
mod function {
    robot_dynamics::robot_dynamics! {
        pub struct Legs;
        convention: modified,
        gravity: [0, 0, -9.81],
        base: floating { mass: 20, com: [0, 0, 0.1], inertia: cuboid(0.3, 0.4, 0.5) },
        joints: [
            left: revolute { on: base, at: { xyz: [0, 0.15, 0] }, mass: 3, com: [0, 0.2, 0] },
            right: revolute { on: base, at: { xyz: [0, -0.15, 0] }, mass: 3, com: [0, 0.2, 0] },
        ],
        frames: { foot: { on: left, xyz: [0, 0.4, 0] } },
        functions: [
            default, taylor_series, jacobian(foot), center_of_mass_jacobian,
            feet = (mass_matrix, wrench_torques(foot)), inverse_dynamics_derivatives,
        ],
    }
}

/// A file that is not there.
mod file {
    robot_dynamics::robot_dynamics! {
        pub struct Legs;
        file: "tests/compile-fail/nowhere.urdf",
        gravity: [0, 0, -9.81],
        base: floating,
        functions: [
            default, jacobian(foot), center_of_mass_jacobian, feet = (mass_matrix, wrench_torques(foot)),
            inverse_dynamics_derivatives,
        ],
    }
}

/// A file with a field that nothing reads.
mod field {
    robot_dynamics::robot_dynamics! {
        #[derive(Default)]
        pub struct Drone { load: f64 }
        file: "../data/files/kinds/body.toml",
        functions: [default, jacobian(camera)],
    }
}

robot_dynamics! {
    /// A file whose legs cannot be locked so.
    struct Hyq;
    file: "../data/urdf/trees/hyq_no_sensors.urdf",
    base: floating,
    gravity: [0, 0, -9.81],
    lock: [lf_haa = ?],
}

robot_dynamics! {
    /// A wrong number in the body of a robot without joints.
    struct Brick;
    gravity: [0, 0, -9.81],
    base: floating { mass: -2, inertia: cuboid(0.1, 0.2, 0.3) },
    joints: [],
}

robot_dynamics! {
    /// A misspelled word.
    struct Stone;
    gravity: [0, 0, -9.81],
    base: floatin { mass: 2, inertia: cuboid(0.1, 0.2, 0.3) },
    joints: [],
}

macro_rules! used {
    ($name:ident, $legs:expr) => {
        fn $name() {
            let (legs, base) = ($legs, Pose::identity());
            let q = SVector::<f64, 2>::new(0.1, 0.2);
            let (v, a) = (SVector::<f64, 8>::zeros(), SVector::<f64, 8>::repeat(1.0));
            let m = legs.mass_matrix(&q);
            let g = legs.gravity_vector(&base, &q);
            let forces = m * a + legs.coriolis_vector(&q, &v) + g + legs.friction_vector(&v);
            let _: SVector<f64, 8> = forces - legs.inverse_dynamics(&base, &q, &v, &a);
            let qdd = legs.forward_dynamics(&base, &q, &v, &forces).unwrap();
            let _ = m.cholesky().unwrap().solve(&qdd).norm() + legs.kinetic_energy(&q, &v) + legs.potential_energy(&base, &q);
            let j: SMatrix<f64, 6, 8> = legs.jacobian_foot(&base, &q);
            let _: Vector6<f64> = j * v;
            let com: Vector3<f64> = legs.center_of_mass_jacobian(&base, &q) * v;
            let (_, torques) = legs.feet(&base, &q, &Vector6::zeros());
            let _ = (com.norm(), torques.fixed_rows::<2>(6).norm());
            let (by_place, by_velocity) = legs.inverse_dynamics_derivatives(&base, &q, &v, &a);
            let _ = (by_place + by_velocity).norm();
            let motion = Simulation::new(&legs).initial(base, q, v).torque(|_, _, _, v| -v).duration(1.0).run().unwrap();
            let _ = (motion.base.last().unwrap().position, motion.energy_drift(&legs));
            let mut many = [v; 2];
            legs.coriolis_vector_batch(&[q; 2], &[v; 2], &mut many).unwrap();
            legs.feet_batch(&[base; 2], &[q; 2], &[Vector6::zeros(); 2], &mut [(m, torques); 2]).unwrap();
            check_against_rnea(&legs).assert_ok();
        }
    };
}

used!(function, function::Legs);
used!(file, file::Legs);

fn main() {
    function();
    file();
    let _: SVector<f64, { function::Legs::DOF }> = SVector::<f64, 8>::zeros();
    let (q, v) = (SVector::<f64, 11>::zeros(), SVector::<f64, 17>::zeros());
    let _ = Hyq.forward_dynamics(&Pose::identity(), &q, &v, &Hyq.coriolis_vector(&q, &v)).unwrap() + v;
    let drone = field::Drone::default();
    let _ = drone.jacobian_camera(&Pose::<f64>::identity(), &SVector::zeros()) * Vector6::zeros();
    let v = SVector::from([0.0, 0.0, 3.0, 0.01, 8.0, 0.0]);
    let throw = Simulation::new(&Brick).initial(Pose::identity(), SVector::zeros(), v).run().expect("a motion");
    let _ = throw.energy_drift(&Brick) + Brick.mass_matrix(&SVector::<f64, 0>::zeros())[(5, 5)];
    let _: SVector<f64, 6> = Stone.gravity_vector(&Pose::identity(), &SVector::zeros());
    check_against_rnea(&Brick).assert_ok();
}
