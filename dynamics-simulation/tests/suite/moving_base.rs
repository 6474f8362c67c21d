//! Simulations of robots on a base that moves: exact solutions, what is conserved, events, and refusals.

use robot_dynamics::nalgebra::{Matrix3, Rotation3, SVector, Vector3};
use robot_dynamics::robot_dynamics;
use robot_dynamics::simulation::{
    Cause, Dop853, DormandPrince, FloatingTrajectory, InvalidSetting, OnBase, Radau5,
};
use robot_dynamics::{FloatingNewtonEuler, Friction, Method, Pose, Simulation};

robot_dynamics! {
    /// A body whose axes differ, in free space.
    struct Brick;

    convention: modified,
    gravity: [0, 0, 0],
    base: floating { mass: 2, inertia: { xx: 1, yy: 2, zz: 2.5 } },
    joints: [],
}

robot_dynamics! {
    /// A body with an axis of symmetry, whose centre of mass is beside the origin of its frame.
    struct Disc;

    convention: modified,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, com: [0, 0, 0.25], inertia: { xx: 2, yy: 2, zz: 3 } },
    joints: [],
}

robot_dynamics! {
    /// A satellite with an arm of two joints, of which the second one slides between stops.
    struct Satellite;

    convention: modified,
    gravity: [0, 0, 0],
    base: floating { mass: 10, com: [0.05, -0.1, 0.02], inertia: { xx: 0.4, yy: 0.5, zz: 0.6, xy: 0.01, xz: -0.02, yz: 0.03 } },
    joints: [
        shoulder: revolute { on: base, at: { xyz: [0.3, 0.1, 0], rpy: [0.4, 0, 0] }, mass: 2, com: [0.25, 0, 0.1],
            inertia: { xx: 0.02, yy: 0.03, zz: 0.04, yz: 0.001 } },
        slide: prismatic { a: 0.2, alpha: PI/2, mass: 1, com: [0.1, 0, 0.05], inertia: sphere(0.1),
            limits: [-0.1, 0.15] },
    ],
    functions: [default, generalized_momentum],
}

robot_dynamics! {
    /// A sledge of 3 kg with a weight of 1 kg that slides along its x axis, between stops, with friction.
    struct Sledge;

    convention: modified,
    gravity: [0, 0, 0],
    base: floating { mass: 3, inertia: sphere(0.2) },
    joints: [
        slide: prismatic { on: base, at: { xyz: [0, 0, 0], rpy: [0, PI/2, 0] }, mass: 1, inertia: sphere(0.1),
            limits: [-0.5, 0.5], friction: { coulomb: 0.3 }, torque_limit: 2 },
    ],
}

/// The same robot as an arm: six joints without bodies carry the base.
mod on_joints {
    use robot_dynamics::robot_dynamics;

    robot_dynamics! {
        /// A satellite on three slides and three hinges.
        pub struct Carried;

        convention: modified,
        gravity: [0.3, -0.2, -1],
        joints: [
            x: prismatic { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] } },
            y: prismatic { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] } },
            z: prismatic { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] } },
            roll: revolute { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] } },
            pitch: revolute { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] } },
            yaw: revolute { at: { xyz: [0, 0, 0], rpy: [PI/2, 0, PI/2] }, mass: 10, com: [0.05, -0.1, 0.02],
                inertia: { xx: 0.4, yy: 0.5, zz: 0.6, xy: 0.01, xz: -0.02, yz: 0.03 } },
            shoulder: revolute { at: { xyz: [0.3, 0.1, 0], rpy: [0.4, 0, 0] }, mass: 2, com: [0.25, 0, 0.1],
                inertia: { xx: 0.02, yy: 0.03, zz: 0.04, yz: 0.001 }, friction: { viscous: 0.2 } },
            elbow: revolute { a: 0.2, alpha: PI/2, mass: 1, com: [0.1, 0, 0.05], inertia: sphere(0.1) },
        ],
        functions: [forward_dynamics],
    }

    robot_dynamics! {
        /// The satellite by itself.
        pub struct Free;

        convention: modified,
        gravity: [0.3, -0.2, -1],
        base: floating { mass: 10, com: [0.05, -0.1, 0.02], inertia: { xx: 0.4, yy: 0.5, zz: 0.6, xy: 0.01, xz: -0.02, yz: 0.03 } },
        joints: [
            shoulder: revolute { on: base, at: { xyz: [0.3, 0.1, 0], rpy: [0.4, 0, 0] }, mass: 2, com: [0.25, 0, 0.1],
                inertia: { xx: 0.02, yy: 0.03, zz: 0.04, yz: 0.001 }, friction: { viscous: 0.2 } },
            elbow: revolute { a: 0.2, alpha: PI/2, mass: 1, com: [0.1, 0, 0.05], inertia: sphere(0.1) },
        ],
    }
}

fn turned(axis: &Vector3<f64>, angle: f64) -> Matrix3<f64> {
    Rotation3::new(axis * (angle / axis.norm())).into_inner()
}

/// How far a matrix is from a rotation.
fn skew(rotation: &Matrix3<f64>) -> f64 {
    (rotation.tr_mul(rotation) - Matrix3::identity()).amax()
}

/// sn, cn and dn by descending Landen transformations (Abramowitz and Stegun, 16.4, with the arithmetic-geometric mean).
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let mut means = vec![(1.0, m.sqrt())];
    let mut b = (1.0 - m).sqrt();
    while let Some((a, _)) = means.last().copied().filter(|(_, c)| *c > 1e-16) {
        means.push((0.5 * (a + b), 0.5 * (a - b)));
        b = (a * b).sqrt();
    }
    let (last, _) = means[means.len() - 1];
    let mut phi = f64::powi(2.0, means.len() as i32 - 1) * last * u;
    let mut before = phi;
    for (a, c) in means.iter().skip(1).rev() {
        before = phi;
        phi = 0.5 * (phi + (c / a * phi.sin()).asin());
    }
    let (sn, cn) = phi.sin_cos();
    [
        sn,
        cn,
        if means.len() > 1 {
            cn / (before - phi).cos()
        } else {
            1.0
        },
    ]
}

/// Euler's equations of a free body (Landau and Lifshitz, *Mechanics*, section 37): `w = (w1 cn, w2 sn, w3 dn)` of
/// `p t` with `p^2 = (I3 - I2) (L^2 - 2 T I1) / (I1 I2 I3)`. The angular momentum stands still in the world.
#[test]
fn a_free_body_turns_as_euler_and_jacobi_have_it() {
    let inertia: [f64; 3] = [1.0, 2.0, 2.5];
    let [i1, i2, i3] = inertia;
    let start = Vector3::new(0.9, 0.0, 1.7);
    let momentum = start.component_mul(&Vector3::from(inertia));
    let twice_energy = momentum.dot(&start);
    let square = momentum.norm_squared();
    let p = ((i3 - i2) * (square - twice_energy * i1) / (i1 * i2 * i3)).sqrt();
    let m = (i2 - i1) * (twice_energy * i3 - square) / ((i3 - i2) * (square - twice_energy * i1));
    let w2 = ((twice_energy * i3 - square) / (i2 * (i3 - i2))).sqrt();

    let v = SVector::from([0.0, 0.0, 0.0, start.x, start.y, start.z]);
    let rotation = turned(&Vector3::new(1.0, -2.0, 0.5), 0.7);
    let base = Pose {
        rotation,
        position: Vector3::new(1.0, 2.0, 3.0),
    };
    let run = Simulation::new(&Brick).initial(base, SVector::zeros(), v);
    let motion = run
        .method(Dop853::with_tolerance(1e-13))
        .duration(20.0)
        .run()
        .unwrap();
    assert_eq!(motion.base[0], base);
    let of_world = rotation * momentum;
    for sample in motion.samples() {
        let [sn, cn, dn] = jacobi(p * sample.t, m);
        let exact = Vector3::new(start.x * cn, w2 * sn, start.z * dn);
        let found: Vector3<f64> = sample.qd.fixed_rows::<3>(3).into();
        let error = (found - exact).amax();
        assert!(error < 1e-11, "{} s: {found} {exact} {error:e}", sample.t);
        let momentum = found.component_mul(&Vector3::from(inertia));
        let drift = (sample.base.rotation * momentum - of_world).amax();
        assert!(drift < 2e-11, "{} s: {drift:e}", sample.t);
        assert!((sample.base.position - base.position).amax() < 1e-14);
    }
}

/// A body with an axis of symmetry: it turns about its angular momentum L at |L| / A, and about its own axis at
/// `(1 - C/A) w3`; its centre of mass falls.
#[test]
fn a_symmetric_body_falls_and_turns_by_closed_forms() {
    let (a, c) = (2.0, 3.0);
    let com = Vector3::new(0.0, 0.0, 0.25);
    let w = Vector3::new(0.8, -0.5, 2.0);
    let rotation = turned(&Vector3::new(0.3, 1.0, -0.4), 2.0);
    let base = Pose {
        rotation,
        position: Vector3::new(0.1, -0.2, 0.3),
    };
    let velocity = Vector3::new(0.4, 1.0, 6.0);
    let of_base = rotation.tr_mul(&velocity);
    let v = SVector::from([of_base.x, of_base.y, of_base.z, w.x, w.y, w.z]);
    let fall = Simulation::new(&Disc).initial(base, SVector::zeros(), v);
    let momentum = rotation * Vector3::new(a * w.x, a * w.y, c * w.z);
    let centre = base.position + rotation * com;
    let of_centre = velocity + rotation * w.cross(&com);
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let exact = |t: f64| {
        let about_momentum = turned(&momentum, t * momentum.norm() / a);
        let turn = about_momentum * rotation * turned(&Vector3::z(), t * (1.0 - c / a) * w.z);
        (
            turn,
            centre + of_centre * t + gravity * (0.5 * t * t) - turn * com,
        )
    };
    for (method, bound) in [
        (Method::from(Dop853::with_tolerance(1e-13)), 4e-12),
        (DormandPrince::with_tolerance(1e-12).into(), 4e-11),
        (Method::RungeKutta4 { step: 1e-3 }, 4e-11),
    ] {
        let motion = fall.clone().method(method).duration(3.0).run().unwrap();
        for sample in motion.samples() {
            let (turn, position) = exact(sample.t);
            let error = (sample.base.rotation - turn)
                .amax()
                .max((sample.base.position - position).amax());
            assert!(error < bound, "{method:?} at {} s: {error:e}", sample.t);
        }
    }
}

/// Orders of the methods of fixed step, by halves of the step, against a fine run.
#[test]
fn methods_of_fixed_step_have_their_order() {
    let v = SVector::from([0.3, -0.2, 0.1, 1.0, 2.0, 1.5, 0.6, -0.1]);
    let q = SVector::from([0.4, 0.02]);
    let run = Simulation::new(&Satellite)
        .initial(Pose::identity(), q, v)
        .samples(2);
    // A torque that depends on where the base stands.
    let run = run.torque(|t, base, _, v| v * -0.5 + SVector::repeat(base.rotation.m12 + 0.3 * t));
    let end = |method: Method| run.clone().method(method).run().unwrap().last().unwrap();
    let exact = end(Dop853::with_tolerance(1e-13).into());
    let euler: [fn(f64) -> Method; 3] = [
        |step| Method::ExplicitEuler { step },
        |step| Method::CraigEuler { step },
        |step| Method::SemiImplicitEuler { step },
    ];
    let error = |method: Method| {
        let end = end(method);
        (end.base.rotation - exact.base.rotation)
            .amax()
            .max((end.qd - exact.qd).amax())
    };
    for (method, order, step) in euler.iter().map(|method| (*method, 1.0, 1e-3)).chain([(
        (|step| Method::RungeKutta4 { step }) as fn(f64) -> Method,
        4.0,
        0.02,
    )]) {
        let found = (error(method(step)) / error(method(0.5 * step))).log2();
        assert!(
            (found - order).abs() < 0.2,
            "{:?}: order {found}",
            method(step)
        );
    }
}

/// A base on six joints without mass moves as one that moves freely, with gravity, friction and torques.
#[test]
fn a_base_on_six_joints_moves_alike() {
    let v = [0.3, -0.2, 0.4, 0.5, 0.4, -0.6, 0.9, -1.1];
    let joints = |t: f64, q: [f64; 2]| [0.3 * t.sin() - q[0], 0.2 - 0.5 * q[1]];
    let (q, method) = (SVector::from([0.4, -0.7]), Dop853::with_tolerance(1e-12));
    let free = Simulation::new(&on_joints::Free)
        .initial(Pose::identity(), q, SVector::from(v))
        .torque(|t, _base, q, _v| {
            let [shoulder, elbow] = joints(t, (*q).into());
            SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, shoulder, elbow])
        });
    let free = free.method(method).run().unwrap();
    let carried = Simulation::new(&on_joints::Carried)
        .initial(
            SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, q[0], q[1]]),
            SVector::from(v),
        )
        .torque(|t, q, _| {
            let [shoulder, elbow] = joints(t, [q[6], q[7]]);
            SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, shoulder, elbow])
        });
    let carried = carried.method(method).run().unwrap();
    for (free, carried) in free.samples().zip(carried.samples()) {
        let [x, y, z, roll, pitch, yaw, shoulder, elbow] = carried.q.into();
        let axes = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
        let turns = axes.iter().zip([roll, pitch, yaw]);
        let rotation = turns.fold(Matrix3::identity(), |turn, (axis, angle)| {
            turn * Rotation3::from_axis_angle(axis, angle).into_inner()
        });
        let error = [
            (free.base.rotation - rotation).amax(),
            (free.base.position - Vector3::new(x, y, z)).amax(),
            (free.q - SVector::from([shoulder, elbow])).amax(),
            (free.qd.fixed_rows::<2>(6) - carried.qd.fixed_rows::<2>(6)).amax(),
        ];
        assert!(
            error.iter().all(|error| *error < 1e-10),
            "{} s: {error:?}",
            free.t
        );
    }
}

/// Linear momentum, and angular momentum about the world's origin, in the axes of the world.
fn momenta(base: &Pose<f64>, q: &SVector<f64, 2>, v: &SVector<f64, 8>) -> [Vector3<f64>; 2] {
    let momentum = Satellite.generalized_momentum(q, v);
    let [linear, angular] =
        [0, 3].map(|first| base.rotation * Vector3::from(momentum.fixed_rows::<3>(first)));
    [linear, angular + base.position.cross(&linear)]
}

/// A hundred turns, while the arm swings: momenta and energy drift by no more than the tolerance, and the rotation stays one.
#[test]
fn momentum_and_energy_stay_over_a_hundred_turns() {
    let turn = core::f64::consts::TAU;
    let v = SVector::from([0.1, -0.05, 0.02, 0.1, 0.2, turn, 0.5, 0.0]);
    let q = SVector::from([0.3, 0.02]);
    // A spring holds the slide against the centrifugal force.
    let stiffness = 400.0;
    let spring = |_: f64, _: &Pose<f64>, q: &SVector<f64, 2>, _: &SVector<f64, 8>| {
        SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -stiffness * q[1]])
    };
    let run = Simulation::new(&Satellite)
        .initial(Pose::identity(), q, v)
        .torque(spring);
    let settings = Dop853::with_tolerance(1e-13);
    let motion = run
        .method(settings)
        .duration(100.0)
        .samples(201)
        .run()
        .unwrap();
    let energies = motion.energies(&Satellite);
    let energy = |k: usize| energies[k] + 0.5 * stiffness * motion.q[k][1].powi(2);
    let [linear, angular] = momenta(&motion.base[0], &q, &v);
    let mut worst = [0.0_f64; 4];
    for (k, sample) in motion.samples().enumerate() {
        let [p, l] = momenta(&sample.base, &sample.q, &sample.qd);
        let drift = [
            (p - linear).amax(),
            (l - angular).amax(),
            (energy(k) / energy(0) - 1.0).abs(),
        ];
        let now = drift.into_iter().chain([skew(&sample.base.rotation)]);
        for (worst, now) in worst.iter_mut().zip(now) {
            *worst = worst.max(now);
        }
    }
    let [p, l, energy, skew] = worst;
    println!(
        "{} steps: momenta {p:.1e} {l:.1e}, energy {energy:.1e}, skew {skew:.1e}",
        motion.work.steps
    );
    assert!(p < 1e-10 && l < 1e-10, "momenta: {p:e} {l:e}");
    assert!(energy < 1e-11, "{energy:e}");
    assert!(skew < 1.5e-15, "{skew:e}");
}

/// A hundred thousand equal steps: rounding of each could add up, and does not.
#[test]
fn rotations_stay_rotations_in_many_equal_steps() {
    let w = Vector3::new(0.3, -0.4, 1.2) * 5.0;
    let v = SVector::from([0.0, 0.0, 0.0, w.x, w.y, w.z]);
    let rotation = turned(&Vector3::new(1.0, 2.0, 3.0), 1.0);
    let base = Pose {
        rotation,
        position: Vector3::zeros(),
    };
    let run = Simulation::new(&Brick)
        .initial(base, SVector::zeros(), v)
        .samples(11);
    let motion = run
        .method(Method::RungeKutta4 { step: 1e-3 })
        .duration(100.0)
        .run()
        .unwrap();
    assert_eq!(motion.work.steps, 100_000);
    let worst = motion
        .base
        .iter()
        .map(|base| skew(&base.rotation))
        .fold(0.0, f64::max);
    println!("{worst:.1e}");
    assert!(worst < 1.5e-15, "{worst:e}");
}

/// The numeric side moves like the generated functions; samples between the steps are those of a run that ends there.
#[test]
fn numeric_robots_and_dense_output() {
    let v = SVector::from([0.3, -0.2, 0.1, 1.0, 2.0, 1.5, 0.6, -0.1]);
    let q = SVector::from([0.4, 0.02]);
    let (base, tolerance) = (Pose::identity(), Dop853::with_tolerance(1e-12));
    let generated = Simulation::new(&Satellite)
        .initial(base, q, v)
        .method(tolerance)
        .run()
        .unwrap();
    let numeric = FloatingNewtonEuler::<2, 8>::new(&Satellite.table());
    let numeric = Simulation::new(&numeric)
        .initial(base, q, v)
        .method(tolerance)
        .run()
        .unwrap();
    for (one, other) in generated.samples().zip(numeric.samples()) {
        assert!((one.base.rotation - other.base.rotation).amax() < 1e-11);
        assert!((one.qd - other.qd).amax() < 1e-11 && (one.qdd - other.qdd).amax() < 1e-10);
    }
    assert!(generated.work.steps < 100, "{}", generated.work.steps);
    for (k, method) in [
        (37, Method::from(tolerance)),
        (52, DormandPrince::with_tolerance(1e-12).into()),
    ] {
        let run = Simulation::new(&Satellite)
            .initial(base, q, v)
            .method(method);
        let sampled = run.clone().run().unwrap();
        let until = run
            .duration(generated.t[k])
            .samples(2)
            .run()
            .unwrap()
            .last()
            .unwrap();
        let error = (sampled.base[k].rotation - until.base.rotation).amax();
        assert!(error < 1e-10, "{method:?}: {error:e}");
    }
}

/// Stops throw the weight and the sledge apart: velocities change places as two masses have it, whatever the axes.
#[test]
fn a_weight_hits_its_stop_and_friction_holds_it() {
    let rotation = turned(&Vector3::new(-0.2, 0.5, 1.0), 1.3);
    let base = Pose {
        rotation,
        position: Vector3::new(1.0, 0.0, 0.0),
    };
    let v = SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0]);
    let run = Simulation::new(&Sledge).initial(base, SVector::zeros(), v);
    let motion = run
        .friction(Friction::Sticking)
        .stops(0.5)
        .duration(8.0)
        .run()
        .unwrap();
    // Friction brakes the relative motion by 0.3 N over the reduced mass of 3/4 kg: v^2 falls by 2 a x.
    let braking = 0.3 / 0.75;
    let arrival = (4.0_f64 - 2.0 * braking * 0.5).sqrt();
    let (mut speed, mut t, mut at) = (0.5 * arrival, (2.0 - arrival) / braking, 0.5);
    // It goes back to the other stop, or rests before.
    let mut way = -1.0;
    while speed * speed > 2.0 * braking {
        let next = (speed * speed - 2.0 * braking).sqrt();
        t += (speed - next) / braking;
        (speed, way, at) = (0.5 * next, -way, -at);
    }
    let rest = at + way * speed * speed / (2.0 * braking);
    t += speed / braking;
    assert!(t < 7.0);
    let end = motion.last().unwrap();
    assert!((end.q[0] - rest).abs() < 1e-9, "{} {rest}", end.q[0]);
    assert_eq!(end.qd[6], 0.0);
    // Both go on with the momentum that they had: 2 kg m/s of 4 kg along the slide.
    let expected = Vector3::new(0.5, 0.0, 0.0);
    assert!(
        (Vector3::from(end.qd.fixed_rows::<3>(0)) - expected).amax() < 1e-9,
        "{}",
        end.qd
    );
    let centre = end.base.position + rotation * Vector3::new(0.25 * end.q[0], 0.0, 0.0);
    assert!((centre - base.position - rotation * expected * 8.0).amax() < 1e-8);
}

/// Elastic stops on a turning satellite keep its momenta and its energy.
#[test]
fn impacts_keep_the_momenta() {
    let v = SVector::from([0.1, -0.05, 0.02, 0.4, 0.2, 1.5, 0.5, 0.3]);
    let q = SVector::from([0.3, 0.02]);
    let run = Simulation::new(&Satellite)
        .initial(Pose::identity(), q, v)
        .stops(1.0);
    let motion = run
        .method(Dop853::with_tolerance(1e-12))
        .duration(3.0)
        .run()
        .unwrap();
    let [linear, angular] = momenta(&motion.base[0], &q, &v);
    let end = motion.last().unwrap();
    let [p, l] = momenta(&end.base, &end.q, &end.qd);
    assert!((p - linear).amax() < 1e-10 && (l - angular).amax() < 1e-10);
    assert!(motion.energy_drift(&Satellite) < 1e-9);
    assert!(
        motion
            .q
            .iter()
            .all(|q| (-0.1 - 1e-12..=0.15 + 1e-12).contains(&q[1]))
    );
    let turns = motion
        .qd
        .windows(2)
        .filter(|pair| pair[0][7] * pair[1][7] < 0.0)
        .count();
    assert!(turns > 1, "{turns} impacts");
    let error = Simulation::new(&Satellite)
        .initial(Pose::identity(), q, v)
        .limits_are_errors()
        .run();
    let error = error.unwrap_err();
    assert_eq!(
        error.cause,
        Cause::JointLimit {
            joint: 7,
            limit: 0.15
        }
    );
    assert!(
        error
            .to_string()
            .contains("joint 2 passes its limit 0.15 (base = ["),
        "{error}"
    );
}

/// A controller is asked once each period, and its force is held; motors have limits, and bases have none.
#[test]
fn sampled_laws_are_held_and_motors_saturate() {
    let mut calls = Vec::new();
    let run = Simulation::new(&Sledge)
        .control_period(0.25)
        .torque(|t, base, q, v| {
            calls.push((t, base.position.x, q[0], v[0]));
            SVector::from([4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0])
        });
    let motion = run
        .friction(Friction::Sticking)
        .saturate()
        .duration(1.0)
        .samples(5)
        .run()
        .unwrap();
    assert_eq!(
        motion.tau[2],
        SVector::from([4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0])
    );
    assert_eq!(
        calls.iter().map(|call| call.0).collect::<Vec<_>>(),
        [0.0, 0.25, 0.5, 0.75]
    );
    let end = motion.last().unwrap();
    // Friction leaves 1.7 N of the motor's 2 N. They pull the weight, and push the sledge back.
    let (of_sledge, of_weight) = ((4.0 - 1.7) / 3.0, 1.7);
    assert!((end.qd[0] - of_sledge).abs() < 1e-10, "{}", end.qd);
    assert!((end.qd[6] - (of_weight - of_sledge)).abs() < 1e-10);
    assert!((end.base.position.x - 0.5 * of_sledge).abs() < 1e-10);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let run =
        || Simulation::new(&Sledge).initial(Pose::identity(), SVector::zeros(), SVector::zeros());
    let refused =
        |error: Box<robot_dynamics::simulation::SizedSimulationError<OnBase<_, _>>>| match error
            .cause
        {
            Cause::InvalidSetting(setting) => (setting, error.to_string()),
            cause => panic!("{cause}"),
        };
    let step = 0.01;
    for method in [
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
        Radau5::default().into(),
    ] {
        let (setting, text) = refused(run().method(method).run().unwrap_err());
        assert_eq!(setting, InvalidSetting::MovingBase);
        assert!(
            text.contains("take DormandPrince, Dop853, RungeKutta4"),
            "{text}"
        );
    }
    let mirrored = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
    let scaled = Matrix3::identity() * 1.001;
    let unknown = Matrix3::repeat(f64::NAN);
    for rotation in [mirrored, scaled, unknown, Matrix3::zeros()] {
        let base = Pose {
            rotation,
            position: Vector3::zeros(),
        };
        let error = run()
            .initial(base, SVector::zeros(), SVector::zeros())
            .run()
            .unwrap_err();
        assert!(error.trajectory.is_empty());
        let (setting, text) = refused(error);
        assert_eq!(setting, InvalidSetting::Rotation);
        assert!(text.contains("the rotation of the base is none"), "{text}");
    }
    let far = Pose {
        position: Vector3::new(0.0, f64::INFINITY, 0.0),
        ..Pose::identity()
    };
    let error = run()
        .initial(far, SVector::zeros(), SVector::zeros())
        .run()
        .unwrap_err();
    let (setting, text) = refused(error);
    assert_eq!(setting, InvalidSetting::InitialState { joint: 1 });
    assert!(
        text.contains("the initial state of base vy is not finite"),
        "{text}"
    );
    let error = run()
        .torque(|_, _, _, _| SVector::repeat(f64::NAN))
        .run()
        .unwrap_err();
    assert!(
        error
            .to_string()
            .contains("the torque of base vx is not finite"),
        "{error}"
    );
}

/// A table is read to the last bit, and says where it is none; a figure has panels of the base and of the joints.
#[test]
fn motions_are_written_read_and_drawn() {
    let v = SVector::from([0.3, -0.2, 0.1, 1.0, 2.0, 1.5, 0.6, -0.1]);
    let q = SVector::from([0.4, 0.02]);
    let run = Simulation::new(&Satellite)
        .initial(Pose::identity(), q, v)
        .samples(5);
    let mut motion = run.run().unwrap();
    let mut text = Vec::new();
    motion.write_csv(&Satellite, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let header = text.lines().next().unwrap();
    let first = "t [s],base.r11,base.r12,base.r13,base.r21,base.r22,base.r23,base.r31,base.r32,base.r33,\
                 base.x [m],base.y [m],base.z [m],q.shoulder [rad],q.slide [m],base.vx [m/s],";
    assert!(header.starts_with(first), "{header}");
    let last =
        "base.nz [N m],tau.shoulder [N m],tau.slide [N],kinetic energy [J],potential energy [J]";
    assert!(header.ends_with(last), "{header}");
    motion.work = Default::default();
    assert_eq!(
        FloatingTrajectory::<2, 8>::read_csv(text.as_bytes()).unwrap(),
        motion
    );
    // Accelerations and forces may be missing.
    let places_and_velocities = |line: &str| line.split(',').take(23).collect::<Vec<_>>().join(",");
    let short: Vec<_> = text.lines().map(places_and_velocities).collect();
    let short = FloatingTrajectory::<2, 8>::read_csv(short.join("\n").as_bytes()).unwrap();
    assert_eq!((short.qdd.len(), short.samples().len()), (0, 5));
    let end = short.last().unwrap();
    assert_eq!((end.base, end.qd), (motion.base[4], motion.qd[4]));
    assert!(end.qdd.iter().chain(&end.tau).all(|x| x.is_nan()));
    for (broken, message) in [
        (
            text.replacen("base.r12", "base.r21", 1),
            "line 1, column 3: a column `base.r12` was expected",
        ),
        (
            text.replacen("q.slide [m],", "", 1),
            "line 1, column 15: a column `q` was expected",
        ),
        (
            text.replacen("q.slide", "q.slide,q.hand", 1),
            "line 1, column 16: a column `base.vx` was expected",
        ),
        (
            text.replacen("\n0,1,", "\n0,x,", 1),
            "line 2, column 2: `x`: expected a number",
        ),
        (
            "t,q.a,q.b".to_owned(),
            "line 1, column 2: a column `base.r11` was expected",
        ),
    ] {
        let error = FloatingTrajectory::<2, 8>::read_csv(broken.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let svg = motion.figure(&Satellite).svg().unwrap();
    for text in [
        "base, rad/s",
        "yaw",
        "position, rad",
        "position, m",
        "force, N",
        "slide",
        "energy, J",
    ] {
        assert!(svg.contains(text), "{text}");
    }
}
