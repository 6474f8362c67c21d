//! Random tables of both conventions, revolute and prismatic joints, symbolic fields among the cells: the
//! generated programs of all functions in double precision against the runtime's numeric Newton-Euler.
//!
//! The bound is that of [`Check`], 1e-13 per joint relative to the magnitude that each quantity could have.

mod printed;
mod runs;
mod second_derivatives;
mod trees;

use arms::{Bodies, Tables};
use dynamics_evaluation::{RuntimeRobot, Value};
use dynamics_symbolic::Proven;
use dynamics_symbolic::derive::center_of_mass::is_massless;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::robot::{JointType, Robot, Row};
use dynamics_symbolic::{Function, Request};
use robot_dynamics::check::Check;

/// The counts of a comparison, and its largest error.
#[derive(Default)]
struct Tally {
    arms: usize,
    with_fields: usize,
    /// Arms with forward dynamics at some state: the others have a mass matrix that is singular.
    solved: usize,
    /// Values of functions at frames.
    at_frames: usize,
    largest: f64,
}

fn compare(seed: u64, count: usize) -> Tally {
    compare_drawn(seed, count, Tables::robot)
}

/// A tree in which no slide follows a joint that turns. At a thousand radians the slide is a thousand metres long, and
/// where the turns of two such joints cancel, Newton-Euler's M is a small difference of large numbers.
fn tree_of_usual_length(tables: &mut Tables) -> Robot {
    of_usual_length(tables, Tables::tree)
}

fn tree_with_all_cells_of_usual_length(tables: &mut Tables) -> Robot {
    of_usual_length(tables, Tables::tree_with_all_cells)
}

fn of_usual_length(tables: &mut Tables, draw: fn(&mut Tables) -> Robot) -> Robot {
    loop {
        let robot = draw(tables);
        let follows_a_turn = |row: &Row| {
            let leader = row.follows.as_ref().map(|of| &robot.rows[of.leader]);
            let turns = leader.is_some_and(|leader| leader.joint_type == JointType::Revolute);
            row.joint_type == JointType::Prismatic && turns
        };
        if !robot.rows.iter().any(follows_a_turn) {
            return robot;
        }
    }
}

/// Such a tree on a base that moves.
fn tree_on_moving_base(tables: &mut Tables) -> Robot {
    let tree = tree_of_usual_length(tables);
    tables.on_moving_base(tree)
}

/// The arms that `draw` makes.
fn compare_drawn(seed: u64, count: usize, draw: fn(&mut Tables) -> Robot) -> Tally {
    compare_by_turns(seed, count, 1, draw)
}

/// Compares M of each arm, and of the other functions one in `turns`, by turns. One turn is all functions.
fn compare_by_turns(
    seed: u64,
    count: usize,
    turns: usize,
    draw: fn(&mut Tables) -> Robot,
) -> Tally {
    let mut tables = Tables::new(seed, Bodies::Physical);
    let mut tally = Tally::default();
    for number in 0..count {
        let robot = draw(&mut tables);
        // Positive, and of no special value.
        let fields =
            (0..robot.fields.len()).map(|_| 0.1 + tables.below(1 << 20) as f64 / 524_287.0);
        let fields: Vec<_> = fields.collect();
        tally.with_fields += usize::from(!fields.is_empty());
        let label = format!("table {number} of seed {seed}");
        let joints = robot.freedoms().joints;
        assert!((1..=4).contains(&joints), "{joints} joints");
        let is_in_turn = |k: usize| k == 0 || k % turns == number % turns;
        tally.add(&robot, &fields, &label, is_in_turn);
    }
    tally
}

impl Tally {
    fn add(
        &mut self,
        robot: &Robot,
        fields: &[f64],
        label: &str,
        is_in_turn: impl Fn(usize) -> bool,
    ) {
        // A series is no straight-line program: `tests/suite/taylor.rs` has its values.
        let exists = |f: &Function| !(f.divides_by_mass() && is_massless(robot));
        let functions = Function::ALL.into_iter().filter(exists);
        let is_of_standing_base = |f: &Function| {
            let coefficients = [
                Function::CoriolisCoefficients,
                Function::CentrifugalCoefficients,
            ];
            robot.floating().is_some() && coefficients.contains(f)
        };
        let functions =
            functions.filter(|f| *f != Function::TaylorSeries && !is_of_standing_base(f));
        let of_tip = Function::ALL.into_iter().filter(|f| f.row().of_tip);
        let requests = functions
            .filter(|f| !f.row().of_tip || robot.tip_row().is_some())
            .map(Request::from);
        let frames = robot.frames.iter().enumerate();
        let of_frames = frames.flat_map(|(i, frame)| {
            let of_tip = of_tip.clone().filter(exists);
            of_tip.map(move |function| Request::of_frame(function, i, &frame.name))
        });
        let requests = requests.chain(of_frames).enumerate();
        let requests = requests.filter(|(k, _)| is_in_turn(*k));
        let arm = RuntimeRobot::new(robot.clone(), requests.map(|(_, request)| request));
        let mut arm = arm.expect("programs are proven");
        arm.set_fields(fields).expect("a value for each field");
        let report = Check::new().samples(8).run_any(&arm);
        assert!(report.is_ok(), "{label}: {report}\n{robot:#?}\n{fields:?}");
        if robot.floating().is_some() {
            let q = vec![0.3; robot.freedoms().joints];
            assert!(is_positive(&arm, &q), "{label}: M\n{robot:#?}");
        }
        self.arms += 1;
        self.solved += usize::from(!report.not_compared.contains(&"forward_dynamics"));
        let functions = report.functions.iter();
        self.at_frames += functions.filter(|found| found.frame.is_some()).count();
        let errors = report.functions.iter().map(|function| function.error);
        self.largest = errors.fold(self.largest, f64::max);
    }
}

/// Whether M is positive definite, or semidefinite to rounding: a joint at the end may move no mass.
fn is_positive(arm: &RuntimeRobot, q: &[f64]) -> bool {
    match arm.evaluate("mass_matrix", &[q]) {
        Ok(Value::Matrix(mut matrix)) => {
            let rounding = 1e-13 * matrix.amax();
            for i in 0..matrix.nrows() {
                matrix[(i, i)] += rounding;
            }
            matrix.cholesky().is_some()
        }
        _ => false,
    }
}

#[track_caller]
fn assert_varied(tally: &Tally) {
    let Tally {
        arms,
        with_fields,
        solved,
        largest,
        ..
    } = tally;
    println!(
        "{arms} arms, {with_fields} with fields, {solved} regular somewhere, largest error {largest:.1e}"
    );
    assert!(2 * with_fields > *arms && 3 * solved > *arms);
}

#[test]
fn programs_of_random_arms_agree_with_newton_euler() {
    assert_varied(&compare(1, 8));
}

/// Bases and tools of numbers, angles and fields.
#[test]
fn programs_of_random_arms_with_base_and_tool_agree_with_newton_euler() {
    assert_varied(&compare_drawn(3, 5, Tables::mounted_robot));
}

/// Springs, friction by direction and friction that falls with the velocity.
#[test]
fn programs_of_random_arms_with_joint_forces_agree_with_newton_euler() {
    assert_varied(&compare_drawn(4, 5, Tables::robot_with_joint_forces));
}

/// `cargo test -p random_arms -- --ignored`. The counts are those of a release, over `share`.
fn compare_many(share: usize) {
    type Seed = fn(usize) -> Tally;
    let seeds: [Seed; 6] = [
        |share| compare(10, 200 / share),
        |share| compare_drawn(11, 80 / share, Tables::mounted_robot),
        |share| compare_drawn(12, 80 / share, Tables::robot_with_joint_forces),
        |share| compare_drawn(13, 30 / share, Tables::coupled_robot),
        |share| compare_by_turns(14, 5_000 / share, 17, tree_of_usual_length),
        |share| compare_by_turns(15, 5_000 / share, 17, tree_of_usual_length),
    ];
    let tallies = seeds.map(|seed| std::thread::spawn(move || seed(share)));
    for tally in tallies {
        assert_varied(&tally.join().expect("all arms agree"));
    }
}

#[test]
#[ignore = "takes half a minute: .ci/run runs it"]
fn programs_of_many_random_arms_agree_with_newton_euler() {
    compare_many(10);
}

/// Rows on any link with all cells that a table may have at once.
#[test]
fn programs_of_random_trees_with_all_cells_agree_with_newton_euler() {
    let tally = compare_by_turns(17, 40, 17, tree_with_all_cells_of_usual_length);
    assert_varied(&tally);
    assert!(tally.at_frames > 15, "{}", tally.at_frames);
}

/// M, and one function of each robot by turns.
fn compare_many_on_moving_bases(count: usize) {
    let tally = compare_by_turns(16, count, 31, tree_on_moving_base);
    println!("largest error {:.1e}", tally.largest);
    assert!(2 * tally.with_fields > tally.arms);
}

#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn programs_of_many_random_robots_on_moving_bases_agree_with_newton_euler() {
    compare_many_on_moving_bases(100);
}

/// M of trees on a base that moves is positive definite, at a state each, but for joints that move no mass.
fn assert_positive(count: usize) {
    let mut tables = Tables::new(18, Bodies::Physical);
    for number in 0..count {
        let robot = tree_on_moving_base(&mut tables);
        let fields = (0..robot.fields.len()).map(|_| 0.1 + tables.below(1_000) as f64 / 500.0);
        let fields: Vec<_> = fields.collect();
        let joints = robot.freedoms().joints;
        let q = (0..joints).map(|_| tables.below(6_000) as f64 / 1_000.0 - 3.0);
        let q: Vec<_> = q.collect();
        // By the plain recursion: another way of writing M changes its rounding alone.
        let program = derive_plain(&robot, Function::MassMatrix);
        let constants = program.rounded_constants();
        let program = Proven { program, constants };
        let programs = [(Function::MassMatrix.into(), program)];
        let mut arm = RuntimeRobot::of_programs(robot, &programs).expect("a robot");
        arm.set_fields(&fields).expect("a value for each field");
        assert!(
            is_positive(&arm, &q),
            "table {number}: M at {q:?}, {fields:?}"
        );
    }
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn mass_matrices_of_many_random_robots_on_moving_bases_are_positive() {
    assert_positive(1_000);
}

/// Ten times as many robots: `cargo test -p random_arms -- --ignored release::`.
mod release {
    #[test]
    #[ignore = "four minutes: run before a release"]
    fn programs_of_many_random_arms_agree_with_newton_euler() {
        super::compare_many(1);
    }

    #[test]
    #[ignore = "two minutes: run before a release"]
    fn programs_of_many_random_robots_on_moving_bases_agree_with_newton_euler() {
        super::compare_many_on_moving_bases(1_000);
    }

    #[test]
    #[ignore = "a minute: run before a release"]
    fn mass_matrices_of_many_random_robots_on_moving_bases_are_positive() {
        super::assert_positive(10_000);
    }
}

/// Followers by factors and offsets of numbers, angles and fields, beside joints that are locked.
#[test]
fn programs_of_random_arms_with_followers_agree_with_newton_euler() {
    assert_varied(&compare_drawn(4, 3, Tables::coupled_robot));
}

/// A gripper, two arms, legs, a hand, a torso and a forked chain, with all functions of the default set.
#[test]
fn programs_of_grippers_hands_and_legs_agree_with_newton_euler() {
    for name in arms::TREES.into_iter().filter(|name| *name != "humanoid") {
        let robot = arms::tree(name);
        let functions = Function::default_set(false);
        let mut arm = RuntimeRobot::new(robot.clone(), functions).expect("programs are proven");
        arm.set_fields(&vec![0.7; robot.fields.len()])
            .expect("a value for each field");
        let report = Check::new().samples(24).run_any(&arm);
        let worst = report.functions.iter().map(|found| found.error);
        assert!(
            worst.fold(0.0, f64::max) < 2e-15 * robot.dof() as f64,
            "{name}: {report}"
        );
    }
}

/// All functions of trees on a base that moves: the six numbers of the base, its pose, and M that is positive definite.
#[test]
fn programs_of_random_trees_on_moving_bases_agree_with_newton_euler() {
    let tally = compare_drawn(6, 4, tree_on_moving_base);
    println!("largest error {:.1e}", tally.largest);
    assert_eq!(tally.solved, tally.arms);
}

/// Rows on any link and on the base, at places of their own; frames on links and on the base, with bodies and without.
/// Some joints are locked, some follow others on any branch.
#[test]
fn programs_of_random_trees_agree_with_newton_euler() {
    let tally = compare_drawn(5, 8, Tables::tree);
    assert_varied(&tally);
    assert!(tally.at_frames > 0);
}
