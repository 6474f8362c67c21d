//! Robots whose base moves: their definition is Newton's and Euler's, every function is proven, and other programs are
//! refused.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::derive::{derive_form, derive_plain, derive_together};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::{Argument, Part};
use dynamics_symbolic::linear::{Matrix3, Symmetric3, Vector3};
use dynamics_symbolic::prove::{Assignment, Cause, Definition, Number, prove, prove_together};
use dynamics_symbolic::robot::{
    Base, Body, Carrier, Convention, Coupling, Frame, Interpretation, JointType, Robot, Row,
    Spring, Symbol, Tool, Value,
};

use expect_test::expect_file;

use crate::random_tables::{assert_proven, prove_parts};
use crate::trees::{at, ratio, tree_of_five, vector};

type Vector = Vector3<Number>;

const OF_STANDING_BASES: [Function; 3] = [
    Function::CoriolisCoefficients,
    Function::CentrifugalCoefficients,
    Function::TaylorSeries,
];

/// The functions that a robot whose base moves has.
fn functions() -> Vec<Function> {
    let all = Function::ALL.into_iter();
    all.filter(|function| !OF_STANDING_BASES.contains(function))
        .collect()
}

fn body() -> Body {
    Body {
        mass: ratio(7, 2),
        com: [ratio(1, 5), ratio(-3, 7), ratio(2, 9)],
        inertia: [(5, 2), (7, 3), (9, 4), (1, 5), (-1, 6), (1, 7)].map(|(a, b)| ratio(a, b)),
    }
}

/// The robot on a base that moves, with this body.
fn on(body: Body, robot: Robot) -> Robot {
    Robot {
        base: Some(Base::Floating(body)),
        ..robot
    }
}

/// A rigid body by itself.
fn free(body: Body) -> Robot {
    let robot = Robot {
        name: "FreeBody".to_owned(),
        gravity: [ratio(1, 3), ratio(-1, 7), ratio(-981, 100)],
        rows: Vec::new(),
        ..tree_of_five()
    };
    on(body, robot)
}

fn link(name: &str, joint_type: JointType) -> Row {
    Row {
        mass: ratio(3, 2),
        com: vector([1, -1, 2]),
        inertia: [4, 5, 6, 1, 0, -1].map(Value::integer),
        ..Row::new(name, joint_type)
    }
}

/// Two branches, one of which slides, a follower and a locked joint; springs, friction, motors; frames with bodies on the base
/// and on a link; two parameters.
fn with_all_cells(convention: Convention) -> Robot {
    let [length, mass] = [0, 1].map(Value::field);
    let turning = Row {
        a: length.clone(),
        alpha: ratio(1, 3),
        d: ratio(1, 4),
        theta: Value::Pi * ratio(1, 2),
        viscous: ratio(1, 7),
        coulomb: [ratio(1, 3), ratio(2, 3)],
        motor_inertia: ratio(1, 50),
        gear_ratio: Value::integer(9),
        spring: Some(Spring {
            stiffness: Value::integer(3),
            rest: ratio(1, 5),
        }),
        ..link("turning", JointType::Revolute)
    };
    let sliding = Row {
        on: Carrier::Base,
        at: at([length, ratio(1, 2), Value::zero()]),
        alpha: ratio(2, 5),
        mass,
        ..link("sliding", JointType::Prismatic)
    };
    let locked = Row {
        on: Carrier::Row(0),
        locked: Some(ratio(1, 6)),
        ..link("locked", JointType::Revolute)
    };
    let following = Row {
        alpha: Value::Pi * ratio(1, 2),
        follows: Some(Coupling {
            leader: 0,
            factor: Value::integer(-2),
            offset: ratio(1, 9),
        }),
        ..link("following", JointType::Revolute)
    };
    let frame = |name: &str, on, mass| Frame {
        name: name.to_owned(),
        on,
        places: at(vector([1, 2, 3])),
        body: Some(Body {
            mass: Value::integer(mass),
            ..body()
        }),
    };
    let robot = Robot {
        name: "AllCells".to_owned(),
        fields: ["length", "mass"].map(str::to_owned).to_vec(),
        convention,
        gravity: [ratio(1, 3), Value::zero(), ratio(-981, 100)],
        rows: vec![turning, sliding, locked, following],
        frames: vec![frame("mast", None, 2), frame("hand", Some(3), 1)],
        ..tree_of_five()
    };
    on(body(), robot)
}

/// One joint with a tool.
fn with_tool(joint_type: JointType) -> Robot {
    let row = Row {
        a: ratio(1, 3),
        alpha: ratio(1, 2),
        d: ratio(1, 4),
        ..link("joint", joint_type)
    };
    let tool = Body {
        mass: ratio(1, 3),
        ..body()
    };
    let robot = Robot {
        rows: vec![row],
        tool: Some(Tool {
            placement: at(vector([1, 1, -1])).remove(0),
            body: tool,
        }),
        ..free(body())
    };
    on(body(), robot)
}

/// Where a free body is and how it moves, in the field.
struct Motion {
    rotation: Matrix3<Number>,
    position: Vector,
    v: Vector,
    w: Vector,
    dv: Vector,
    dw: Vector,
    gravity: Vector,
    mass: Number,
    com: Vector,
    inertia: Symmetric3<Number>,
}

impl Motion {
    fn new(point: &mut Assignment, robot: &Robot) -> Self {
        let entry = |k| point.entry(Argument::Base, k);
        let rotation = Matrix3([0, 3, 6].map(|k| [k, k + 1, k + 2].map(entry)));
        let position = Vector3([9, 10, 11].map(entry));
        let joints = point.joints();
        let velocity = |first: usize| Vector3([0, 1, 2].map(|k| joints[first + k].qd));
        let rate = |first: usize| Vector3([0, 1, 2].map(|k| joints[first + k].qdd));
        let [v, w, dv, dw] = [velocity(0), velocity(3), rate(0), rate(3)];
        let body = robot.floating().expect("a base that moves").clone();
        Motion {
            rotation,
            position,
            v,
            w,
            dv,
            dw,
            gravity: Vector3(robot.gravity.each_ref().map(|x| point.value(x))),
            mass: point.value(&body.mass),
            com: Vector3(body.com.each_ref().map(|x| point.value(x))),
            inertia: Symmetric3::from_entries(body.inertia.each_ref().map(|x| point.value(x))),
        }
    }

    /// Newton: m (a - g), with a of the centre of mass in the axes of the body. Euler: I dw/dt + w x I w about it. Then the moment
    /// about the origin of the frame.
    fn forces(&self, gravity: Vector) -> Vec<Number> {
        let of_origin = self.dv + self.w.cross(self.v);
        let of_center = self.dw.cross(self.com) + self.w.cross(self.w.cross(self.com));
        let local = self.rotation.transpose().apply(gravity);
        let force = (of_origin + of_center - local) * self.mass;
        let spin = self.inertia.apply(self.w);
        let moment = self.inertia.apply(self.dw) + self.w.cross(spin) + self.com.cross(force);
        [force.0, moment.0].concat()
    }

    /// m v of the centre of mass; the angular momentum about it, and that of m v about the origin of the frame.
    fn momenta(&self) -> Vec<Number> {
        let linear = (self.v + self.w.cross(self.com)) * self.mass;
        let angular = self.inertia.apply(self.w) + self.com.cross(linear);
        [linear.0, angular.0].concat()
    }
}

fn half() -> Number {
    Number::from_rational(&Rational::from_parts_signed(1.into(), 2_u64.into())).expect("odd")
}

#[test]
fn a_free_body_moves_as_newton_and_euler_have_it() {
    let robot = free(body());
    let point = &mut Assignment::new(&robot, 17);
    let definition = Definition::new(point, &robot);
    let expected = |function: Function| definition.expected(function, &[]).expect("defined");
    let motion = Motion::new(point, &robot);
    assert_eq!(
        expected(Function::InverseDynamics),
        motion.forces(motion.gravity)
    );
    let momenta = motion.momenta();
    assert_eq!(expected(Function::GeneralizedMomentum), momenta);
    let velocity = [motion.v.0, motion.w.0].concat();
    assert_eq!(
        expected(Function::KineticEnergy),
        [half() * dot(&momenta, &velocity)]
    );
    let center = motion.rotation.apply(motion.com) + motion.position;
    assert_eq!(expected(Function::CenterOfMass), center.0);
    assert_eq!(
        expected(Function::PotentialEnergy),
        [-(motion.mass * motion.gravity.dot(center))]
    );
    // d/dt (momenta) = tau - w x p for the linear ones, tau - w x l - v x p for the angular ones: without a force.
    let weight = Motion {
        v: Vector3::splat(Number::ZERO),
        w: Vector3::splat(Number::ZERO),
        dv: Vector3::splat(Number::ZERO),
        dw: Vector3::splat(Number::ZERO),
        ..motion
    };
    let gravity = weight.forces(motion.gravity);
    assert_eq!(expected(Function::GravityVector), gravity);
    let [p, l] = [0, 3].map(|first| Vector3([0, 1, 2].map(|k| momenta[first + k])));
    let turning = [
        motion.w.cross(p).0,
        (motion.w.cross(l) + motion.v.cross(p)).0,
    ]
    .concat();
    let bias = turning.iter().zip(&gravity).map(|(&a, &b)| -(a + b));
    assert_eq!(expected(Function::MomentumBias), bias.collect::<Vec<_>>());
}

/// By Newton and Euler, at constant velocities in the axes of the body: the momenta, and what changes them.
#[test]
fn the_momentum_of_a_free_body_about_its_center_of_mass() {
    let robot = free(body());
    let point = &mut Assignment::new(&robot, 20);
    let definition = Definition::new(point, &robot);
    let expected = |function: Function| definition.expected(function, &[]).expect("defined");
    let mut motion = Motion::new(point, &robot);
    let v = [motion.v.0, motion.w.0].concat();
    let in_world = |linear: Vector, angular: Vector| {
        let both = [linear, angular];
        both.map(|x| motion.rotation.apply(x).0).concat()
    };
    let matrix = expected(Function::CentroidalMomentumMatrix);
    let linear = (motion.v + motion.w.cross(motion.com)) * motion.mass;
    let spin = motion.inertia.apply(motion.w);
    assert_eq!(times(&matrix, &v), in_world(linear, spin));
    // A base that does not turn has no angular momentum about the centre of mass.
    for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
        assert_eq!(matrix[6 * i + j], motion.mass * motion.rotation.0[i][j]);
        assert_eq!(matrix[6 * (3 + i) + j], Number::ZERO);
    }
    let none = Vector3::splat(Number::ZERO);
    let turning = motion.w.cross(spin);
    [motion.dv, motion.dw] = [none; 2];
    let force = Vector3([0, 1, 2].map(|k| motion.forces(none)[k]));
    let rate = [force, turning].map(|x| motion.rotation.apply(x).0);
    assert_eq!(expected(Function::CentroidalMomentumBias), rate.concat());
}

/// The first rows of M u and of V are momentum and its rate about the origin of the base, in its axes.
#[test]
fn the_rows_of_the_base_are_those_of_all_bodies() {
    for robot in [Convention::Standard, Convention::Modified].map(with_all_cells) {
        let point = &mut Assignment::new(&robot, 21);
        let definition = Definition::new(point, &robot);
        let of = |function: Function| definition.expected(function, &[]).expect("defined");
        let motion = Motion::new(point, &robot);
        let joints = point.joints()[..robot.dof()].iter();
        let u: Vec<_> = joints.map(|joint| joint.qd).collect();
        let vector = |x: &[Number], first: usize| Vector3([0, 1, 2].map(|k| x[first + k]));
        let lever = vector(&of(Function::CenterOfMass), 0) - motion.position;
        let about_base = |x: &[Number]| {
            let (linear, angular) = (vector(x, 0), vector(x, 3));
            let both = [linear, angular + lever.cross(linear)];
            both.map(|x| motion.rotation.transpose().apply(x).0)
                .concat()
        };
        let momentum = times(&of(Function::CentroidalMomentumMatrix), &u);
        let by_inertia = times(&of(Function::MassMatrix), &u);
        assert_eq!(about_base(&momentum), by_inertia[..6]);
        let rate = of(Function::CentroidalMomentumBias);
        assert_eq!(about_base(&rate), of(Function::CoriolisVector)[..6]);
    }
}

/// About its centre of mass the matrix of Echeandia and Wensing has the blocks m [w]x and 1/2 ([w]x I + I [w]x - [I w]x).
#[test]
fn the_coriolis_matrix_of_a_free_body() {
    let robot = free(Body {
        com: [0; 3].map(Value::integer),
        ..body()
    });
    let point = &mut Assignment::new(&robot, 18);
    let definition = Definition::new(point, &robot);
    let found = definition.expected(Function::CoriolisMatrix, &[]);
    let motion = Motion::new(point, &robot);
    let cross = |x: Vector| Matrix3::cross(x, Number::ZERO);
    let (turn, inertia) = (cross(motion.w), motion.inertia.full());
    let spin = cross(motion.inertia.apply(motion.w));
    let [before, behind] = [turn.product(&inertia), inertia.product(&turn)];
    let mut expected = vec![Number::ZERO; 36];
    for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
        expected[6 * i + j] = motion.mass * turn.0[i][j];
        let sum = before.0[i][j] + behind.0[i][j] - spin.0[i][j];
        expected[6 * (3 + i) + 3 + j] = half() * sum;
    }
    assert_eq!(found, Some(expected));
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    let terms = a.iter().zip(b);
    terms.fold(Number::ZERO, |sum, (&a, &b)| sum + a * b)
}

fn times(matrix: &[Number], x: &[Number]) -> Vec<Number> {
    matrix.chunks(x.len()).map(|row| dot(row, x)).collect()
}

fn sum(a: &[Number], b: &[Number]) -> Vec<Number> {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

/// Identities between the definitions of different functions.
#[test]
fn definitions_agree_with_each_other() {
    for robot in [Convention::Standard, Convention::Modified].map(with_all_cells) {
        let point = &mut Assignment::new(&robot, 19);
        let definition = Definition::new(point, &robot);
        let of = |function: Function| definition.expected(function, &[]).expect("defined");
        let n = robot.dof();
        assert_eq!(n, 8);
        let joints = &point.joints()[..n];
        let [u, du]: [Vec<_>; 2] = [
            joints.iter().map(|joint| joint.qd).collect(),
            joints.iter().map(|joint| joint.qdd).collect(),
        ];
        let entries = |argument| -> Vec<_> { (0..n).map(|k| point.entry(argument, k)).collect() };
        let (jerk, reference) = (
            entries(Argument::Jerk),
            entries(Argument::ReferenceVelocity),
        );
        let (mass, coriolis) = (of(Function::MassMatrix), of(Function::CoriolisMatrix));
        // C u = V
        assert_eq!(times(&coriolis, &u), of(Function::CoriolisVector));
        // dM/dt = C + C', where dM/dt = sum dM/dq_k u_k.
        let second = of(Function::InverseDynamicsSecondDerivatives);
        let rate = times(&second[3 * n * n * n..], &u);
        for (i, j) in (0..n * n).map(|k| (k / n, k % n)) {
            assert_eq!(
                rate[n * i + j],
                coriolis[n * i + j] + coriolis[n * j + i],
                "{i} {j}"
            );
        }
        // M does not depend on where the base is.
        let by_base = (0..n * n).flat_map(|k| (0..6).map(move |base| n * k + base));
        assert!(
            by_base
                .map(|k| second[3 * n * n * n + k])
                .all(|x| x.is_zero())
        );
        // Y_r times the base parameters is the passivity torque but for springs and friction.
        let own = sum(&of(Function::SpringVector), &of(Function::FrictionVector));
        assert!(own[..6].iter().all(|x| x.is_zero()));
        let parameters = of(Function::BaseParameters);
        let of_links = times(&of(Function::PassivityRegressor), &parameters);
        assert_eq!(sum(&of_links, &own), of(Function::PassivityTorque));
        let inertial = times(&mass, &entries(Argument::ReferenceAcceleration));
        let motion = sum(&inertial, &times(&coriolis, &reference));
        assert_eq!(of_links, sum(&motion, &of(Function::GravityVector)));
        let of_links = times(&of(Function::Regressor), &parameters);
        assert_eq!(sum(&of_links, &own), of(Function::InverseDynamics));
        // d tau/dt = d tau/dq u + d tau/du du/dt + M times the jerk: displacements along the motion.
        let slopes = of(Function::InverseDynamicsDerivatives);
        let (by_position, by_velocity) = slopes.split_at(n * n);
        let along = sum(&times(by_position, &u), &times(by_velocity, &du));
        let rates = of(Function::InverseDynamicsRates);
        assert_eq!(sum(&along, &times(&mass, &jerk)), rates[..n]);
        // T, and U but for the springs, which U alone has.
        let energies = times(&of(Function::EnergyRegressors), &parameters);
        let springs = &robot.rows[0].spring.as_ref().expect("a spring");
        let [stiffness, rest] = [&springs.stiffness, &springs.rest].map(|x| point.value(x));
        let stretch = point.joints()[6].q - rest;
        let of_spring = half() * stiffness * stretch * stretch;
        let of_links = [
            of(Function::KineticEnergy)[0],
            of(Function::PotentialEnergy)[0] - of_spring,
        ];
        assert_eq!(energies, of_links);
    }
}

/// The base keeps all ten parameters of its body, and of what its joints do not move: these come first.
#[test]
fn the_ten_parameters_of_the_base_come_first() {
    let robot = free(body());
    let point = &mut Assignment::new(&robot, 20);
    let definition = Definition::new(point, &robot);
    let found = definition.expected(Function::BaseParameters, &[]);
    let Motion {
        mass, com, inertia, ..
    } = Motion::new(point, &robot);
    // I + m (c.c 1 - c c')
    let about_origin = |i: usize, j: usize| {
        let square = if i == j { com.dot(com) } else { Number::ZERO };
        inertia.full().0[i][j] + mass * (square - com[i] * com[j])
    };
    let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let mut expected = pairs.map(|(i, j)| about_origin(i, j)).to_vec();
    expected.extend((com * mass).0);
    expected.push(mass);
    assert_eq!(found, Some(expected));
}

fn robots() -> Vec<Robot> {
    vec![
        free(body()),
        with_tool(JointType::Revolute),
        with_tool(JointType::Prismatic),
        with_all_cells(Convention::Standard),
        with_all_cells(Convention::Modified),
    ]
}

#[test]
fn every_function_is_proven() {
    for (number, robot) in robots().iter().enumerate() {
        prove_parts(robot, number, &functions(), derive_plain);
    }
}

/// Operations of robots on bases that move, without friction in their joints.
#[test]
fn snapshot_of_moving_bases() {
    let mut table =
        "robot      function                        mul    add   div  total\n".to_owned();
    for name in ["free_body", "hyq", "torso"] {
        let robot = arms::floating(name);
        for function in Function::default_set(false) {
            let count = crate::derive(&robot, function).operations();
            table += &format!(
                "{name:10} {:28} {:6} {:6} {:5} {:6}\n",
                function.name(),
                count.multiplications,
                count.additions,
                count.divisions,
                count.total(),
            );
        }
    }
    expect_file!["../golden/moving_bases.txt"].assert_eq(&table);
}

/// A graph of CasADi with its common subexpressions takes 2,101 operations for the torques of the quadruped.
#[test]
fn programs_of_a_quadruped_are_short() {
    let robot = arms::floating("hyq");
    for (function, most) in [
        (Function::InverseDynamics, 1300),
        (Function::MassMatrix, 1100),
    ] {
        let total = crate::derive(&robot, function).operations().total();
        assert!(total <= most, "{function:?} {total}");
    }
}

/// The other forms in which functions are written.
#[test]
fn every_form_is_proven() {
    let columns = [
        Function::GravityVector,
        Function::CoriolisVector,
        Function::BiasForce,
    ];
    let functions = functions().into_iter();
    let assembled = functions.filter(|f| f.row().second.is_some() && !columns.contains(f));
    let forms: Vec<_> = assembled
        .chain(columns)
        .map(|function| (function, Form::Assembled))
        .chain(columns.map(|function| (function, Form::Columns)))
        .chain([(Function::ForwardDynamics, Form::Articulated)])
        .collect();
    for robot in &robots() {
        for &(function, form) in &forms {
            if form == Form::Articulated && robot.is_coupled() {
                continue;
            }
            let program = derive_form(robot, function, form);
            let proof = prove(robot, function, &program);
            assert_eq!(proof, Ok(()), "{} {function:?} {form:?}", robot.name);
        }
    }
}

#[test]
fn every_short_program_is_proven() {
    for (number, robot) in robots()[..3].iter().enumerate() {
        let has_tip = robot.tip_row().is_some();
        for function in functions() {
            if has_tip || !function.row().of_tip {
                let program = crate::derive(robot, function);
                assert_proven(robot, number, function.into(), &program);
            }
        }
    }
}

/// Random trees of one to four joints on bases that move, every other one with all cells.
#[test]
fn every_function_of_random_trees_is_proven() {
    prove_random(31, 12);
}

#[test]
#[ignore = "takes a minute: .ci/run runs it"]
fn every_function_of_many_random_trees_is_proven() {
    prove_random(32, 60);
}

fn prove_random(seed: u64, count: usize) {
    let mut tables = Tables::new(seed, Bodies::Any);
    for number in 0..count {
        let robot = match number % 3 {
            0 => tables.tree(),
            1 => tables.tree_with_all_cells(),
            _ => tables.robot_with_joint_forces(),
        };
        let body = Body {
            mass: tables.number(),
            com: [(); 3].map(|()| tables.number()),
            inertia: [(); 6].map(|()| tables.number()),
        };
        prove_parts(&on(body, robot), number, &functions(), derive_plain);
    }
}

/// Functions whose definitions read bodies, poses and velocities.
const SOME: [Function; 6] = [
    Function::InverseDynamics,
    Function::MassMatrix,
    Function::BaseParameters,
    Function::CoriolisMatrix,
    Function::InverseDynamicsDerivatives,
    Function::KineticEnergy,
];

#[test]
fn programs_of_other_bases_are_refused() {
    let robot = with_tool(JointType::Revolute);
    let with = |change: fn(&mut Body)| {
        let mut body = body();
        change(&mut body);
        on(body, robot.clone())
    };
    let frame = |mass: i64| Frame {
        name: "mast".to_owned(),
        on: None,
        places: at(vector([1, 0, 2])),
        body: Some(Body {
            mass: Value::integer(mass),
            ..body()
        }),
    };
    let loaded = |mass| Robot {
        frames: vec![frame(mass)],
        ..robot.clone()
    };
    let standing = Robot {
        base: None,
        ..robot.clone()
    };
    let others = [
        with(|body| body.mass = ratio(7, 3)),
        with(|body| body.com[1] = ratio(3, 7)),
        with(|body| body.inertia[0] = ratio(5, 3)),
        with(|body| body.inertia[3] = ratio(-1, 5)),
        loaded(1),
        loaded(2),
        standing,
    ];
    for function in SOME {
        let program = derive_plain(&robot, function);
        assert_eq!(prove(&robot, function, &program), Ok(()));
        for other in &others {
            let of_other = derive_plain(other, function);
            assert_eq!(prove(other, function, &of_other), Ok(()));
            let refusal = prove(&robot, function, &of_other);
            assert!(refusal.is_err(), "{function:?}");
        }
    }
}

/// Linear and angular velocities or accelerations exchanged, the rotation transposed, the position's entries in another
/// order.
#[test]
fn programs_that_mix_up_their_arguments_are_refused() {
    let robot = with_tool(JointType::Revolute);
    let exchanged: [fn(&Symbol) -> Option<Symbol>; 4] = [
        |symbol| match *symbol {
            Symbol::Velocity(k) if k < 6 => Some(Symbol::Velocity((k + 3) % 6)),
            _ => None,
        },
        |symbol| match *symbol {
            Symbol::Acceleration(k) if k < 6 => Some(Symbol::Acceleration((k + 3) % 6)),
            _ => None,
        },
        |symbol| match *symbol {
            Symbol::Entry(Argument::Base, k) if k < 9 => {
                Some(Symbol::Entry(Argument::Base, k % 3 * 3 + k / 3))
            }
            _ => None,
        },
        |symbol| match *symbol {
            Symbol::Entry(Argument::Base, k) if k > 8 => {
                Some(Symbol::Entry(Argument::Base, 9 + (k + 1) % 3))
            }
            _ => None,
        },
    ];
    let mut refused = 0;
    for function in functions() {
        let sound = crate::derive(&robot, function);
        for exchange in exchanged {
            let mut program = (*sound).clone();
            for input in &mut program.inputs {
                *input = exchange(input).unwrap_or_else(|| input.clone());
            }
            if program.inputs != sound.inputs {
                let refusal = prove(&robot, function, &program).map_err(|failure| failure.cause);
                assert!(matches!(refusal, Err(Cause::Output(_))), "{function:?}");
                refused += 1;
            }
        }
    }
    assert!(refused > 50, "{refused}");
}

/// Every single operation matters.
#[test]
fn damaged_programs_are_refused() {
    let of = |robot: &Robot, functions: &[Function]| -> usize {
        let refused = |&f: &Function| crate::damage::refused(robot, f, &crate::derive(robot, f));
        functions.iter().map(refused).sum()
    };
    let refused = of(&free(body()), &all_but_of_tip());
    assert!(refused > 1000, "{refused}");
    let robot = with_tool(JointType::Revolute);
    let refused = of(
        &robot,
        &[
            Function::InverseDynamics,
            Function::CoriolisMatrix,
            Function::MomentumBias,
            Function::JacobianRate,
            Function::ToolAcceleration,
            Function::CenterOfMassJacobian,
        ],
    );
    assert!(refused > 1000, "{refused}");
}

fn all_but_of_tip() -> Vec<Function> {
    let functions = functions().into_iter();
    functions.filter(|f| !f.row().of_tip).collect()
}

/// Arrays over the joints alone stand before arrays over all degrees of freedom.
#[test]
fn functions_in_one_program_are_proven_each() {
    let robot = with_all_cells(Convention::Standard);
    let parts = [
        Function::LinkPoses,
        Function::InverseDynamicsDerivatives,
        Function::Regressor,
        Function::LinkJacobians,
    ];
    let mut parts = parts.map(Part::from);
    let program = derive_together(&robot, &parts);
    assert_eq!(prove_together(&robot, &parts, &program), Ok(()));
    parts.swap(0, 3);
    assert!(prove_together(&robot, &parts, &program).is_err());
}

/// Nothing is defined of functions that a base that moves does not have.
#[test]
fn functions_of_standing_bases_are_not_defined() {
    let robot = with_tool(JointType::Revolute);
    let definition = Definition::new(&mut Assignment::new(&robot, 1), &robot);
    for function in OF_STANDING_BASES {
        assert_eq!(definition.expected(Part::from(function), &[]), None);
    }
}
