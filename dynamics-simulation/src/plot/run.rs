//! A run as a figure.

use std::path::Path;

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::table::{AsArm as _, Row};
use dynamics_runtime::{JointType, JointVector, Sizes};
use nalgebra::{Matrix4, Rotation3, SVector, Vector3};

use super::{Curve, Figure, Outcome, joints};
use crate::Trajectory;
use crate::simulation::{SizedModel, SizedTrajectory};

impl<K: Sizes> SizedTrajectory<K> {
    /// Draws the run into the file, as SVG: panels of positions, velocities, accelerations, torques and, where the robot
    /// knows them ([`Model::energies`](dynamics_runtime::Model::energies)), energies. Joints that turn and joints that slide have panels of their own.
    /// The first panels are about a base that moves: its position and its roll, pitch and yaw in the world, its velocities and
    /// the force and moment on it in its own axes.
    ///
    /// ```no_run
    /// use robot_dynamics::{Simulation, nalgebra::SVector, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A rod of 2 m that swings.
    ///     struct Rod;
    ///     convention: standard,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [pivot: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) }],
    /// }
    ///
    /// let swing = Simulation::new(&Rod).duration(10.0).samples(1001).run()?;
    /// swing.plot(&Rod, "swing.svg")?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Where the file cannot be written, or there is nothing to draw.
    pub fn plot<R: SizedModel<K>>(&self, robot: &R, file: impl AsRef<Path>) -> Outcome {
        self.figure(robot).save(file)
    }

    /// The same as a figure without a title, to add panels to.
    pub fn figure<R: SizedModel<K>>(&self, robot: &R) -> Figure {
        let mut figure = Figure::new(String::new());
        if !self.base.is_empty() {
            figure = self.with_base(figure);
        }
        let q = self.q.iter().map(JointVector::entries).collect();
        let of_base = if self.base.is_empty() { 0 } else { 6 };
        let [qd, qdd, tau] = [&self.qd, &self.qdd, &self.tau].map(|list| {
            let of_joints = list.iter().map(|vector| &vector.entries()[of_base..]);
            of_joints.collect()
        });
        let (names, table) = (robot.names(), robot.sized_table());
        let lists = [q, qd, qdd, tau];
        let figure = with_joints(figure, names.as_ref(), table.arm().rows, &self.t, lists);
        with_energies(figure, &self.t, self.both_energies(robot).collect())
    }

    /// Panels of a base that moves.
    fn with_base(&self, mut figure: Figure) -> Figure {
        let base = &self.base;
        let positions = base.iter().map(|base| base.position);
        let angles = base.iter().map(|base| {
            let rotation = Rotation3::from_matrix_unchecked(base.rotation);
            let (roll, pitch, yaw) = rotation.euler_angles();
            Vector3::new(roll, pitch, yaw)
        });
        let three = |list: &[Velocities<K>], first: usize| -> Vec<_> {
            let three = |v: &Velocities<K>| Vector3::from_fn(|i, _| v[first + i]);
            list.iter().map(three).collect()
        };
        let (t, v, tau) = (&self.t, &self.qd, &self.tau);
        figure = figure
            .panel("base, m", joints(["x", "y", "z"], t, positions))
            .panel("base, rad", joints(["roll", "pitch", "yaw"], t, angles));
        if v.len() == self.len() {
            figure = figure
                .panel("base, m/s", joints(["vx", "vy", "vz"], t, three(v, 0)))
                .panel("base, rad/s", joints(["wx", "wy", "wz"], t, three(v, 3)));
        }
        if tau.len() == self.len() {
            figure = figure
                .panel("base, N", joints(["fx", "fy", "fz"], t, three(tau, 0)))
                .panel("base, N m", joints(["nx", "ny", "nz"], t, three(tau, 3)));
        }
        figure
    }
}

impl<const N: usize> Trajectory<N> {
    /// The path of a frame's origin as curves for a panel, `hand x`, `hand y` and `hand z` for a frame `hand`: `pose` is
    /// its forward kinematics, `|q| torso.forward_kinematics_hand(q)`.
    pub fn path(&self, frame: &str, pose: impl Fn(&SVector<f64, N>) -> Matrix4<f64>) -> [Curve; 3] {
        let origins: Vec<_> = self.q.iter().map(|q| pose(q).column(3).xyz()).collect();
        let curve = |(i, axis)| {
            let values = origins.iter().map(|origin| origin[i]);
            Curve::new(format!("{frame} {axis}"), &self.t, values)
        };
        [(0, "x"), (1, "y"), (2, "z")].map(curve)
    }
}

/// Panels of the joints, apart where they turn and where they slide: positions, velocities, accelerations and torques.
fn with_joints(
    mut figure: Figure,
    names: &[String],
    rows: &[Row],
    t: &[f64],
    lists: [Vec<&[f64]>; 4],
) -> Figure {
    const LABELS: [[&str; 2]; 4] = [
        ["position, rad", "position, m"],
        ["velocity, rad/s", "velocity, m/s"],
        ["acceleration, rad/s²", "acceleration, m/s²"],
        ["torque, N m", "force, N"],
    ];
    for (labels, values) in LABELS.into_iter().zip(lists) {
        if values.len() != t.len() {
            continue;
        }
        for (kind, label) in [JointType::Revolute, JointType::Prismatic]
            .into_iter()
            .zip(labels)
        {
            let joints = names.iter().zip(rows).enumerate();
            let of_kind = joints.filter(|(_, (_, row))| row.joint_type == kind);
            let curve = |i: usize, name: &String| {
                Curve::new(name, t, values.iter().map(|numbers| numbers[i]))
            };
            let curves = of_kind.map(|(i, (name, _))| curve(i, name));
            let curves: Vec<Curve> = curves.collect();
            if !curves.is_empty() {
                figure = figure.panel(label, curves);
            }
        }
    }
    figure
}

/// A panel of kinetic, potential and total energy, where they are known.
fn with_energies(figure: Figure, t: &[f64], energies: Option<Vec<[f64; 2]>>) -> Figure {
    let Some(energies) = energies.filter(|energies| energies.len() == t.len()) else {
        return figure;
    };
    let curve = |name: &str, of: fn(&[f64; 2]) -> f64| Curve::new(name, t, energies.iter().map(of));
    let curves = [
        curve("kinetic", |e| e[0]),
        curve("potential", |e| e[1]),
        curve("total", |e| e[0] + e[1]),
    ];
    figure.panel("energy, J", curves)
}

#[cfg(test)]
mod tests {
    use dynamics_numeric::NewtonEuler;
    use dynamics_runtime::{JointType, Table};
    use nalgebra::{Matrix4, Vector2, Vector3};
    use tables::CRAIG_ARM;

    use crate::{Simulation, Trajectory};

    fn file(name: &str) -> std::path::PathBuf {
        std::env::temp_dir().join(format!("{name}-{}.svg", std::process::id()))
    }

    fn drawn<R: dynamics_runtime::Model<2>>(run: &Trajectory<2>, robot: &R, name: &str) -> String {
        let file = file(name);
        run.plot(robot, &file).unwrap();
        let svg = std::fs::read_to_string(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        svg
    }

    #[test]
    fn a_run_is_drawn_with_all_that_it_has() {
        let run = Simulation::new(&CRAIG_ARM).samples(5).run().unwrap();
        let svg = drawn(&run, &CRAIG_ARM, "craig");
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        for text in [
            "position, rad",
            "torque, N m",
            "energy, J",
            "shoulder",
            "elbow",
            "time, s",
        ] {
            assert!(svg.contains(text), "{text}");
        }
        assert_eq!(svg.matches("time, s").count(), 5);
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn joints_that_slide_have_panels_of_their_own() {
        let mut table: Table<2> = dynamics_runtime::Model::table(&CRAIG_ARM);
        table.rows[1].joint_type = JointType::Prismatic;
        let arm = NewtonEuler::new(&table);
        let run = Simulation::new(&arm).samples(3).run().unwrap();
        let svg = drawn(&run, &arm, "sliding");
        for text in ["position, rad", "position, m", "force, N", "joint_2"] {
            assert!(svg.contains(text), "{text}");
        }
    }

    #[test]
    fn frames_have_curves_with_their_names() {
        let run = Simulation::new(&CRAIG_ARM).samples(5).run().unwrap();
        let pose = |q: &Vector2<f64>| Matrix4::new_translation(&Vector3::new(q[0], 7.0, -q[1]));
        let figure = run
            .figure(&CRAIG_ARM)
            .panel("position, m", run.path("left hand", pose));
        let svg = figure.svg().unwrap();
        for text in ["left hand x", "left hand y", "left hand z", "shoulder"] {
            assert!(svg.contains(text), "{text}");
        }
    }

    #[test]
    fn runs_that_are_no_numbers_are_drawn_as_far_as_they_are() {
        let mut run = Simulation::new(&CRAIG_ARM).samples(5).run().unwrap();
        run.q[3] = Vector2::new(f64::NAN, f64::INFINITY);
        run.tau.clear();
        let svg = drawn(&run, &CRAIG_ARM, "nan");
        assert!(!svg.contains("NaN") && !svg.contains("torque"));
        run.qd.clear();
        let svg = drawn(&run, &CRAIG_ARM, "points");
        assert!(svg.contains("position") && !svg.contains("velocity") && !svg.contains("energy"));
        let empty = Trajectory::default().plot(&CRAIG_ARM, file("empty"));
        assert_eq!(empty.unwrap_err().to_string(), "there is nothing to draw");
        // A file is no folder.
        let nowhere = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/run.svg");
        assert!(run.plot(&CRAIG_ARM, nowhere).is_err());
    }
}
