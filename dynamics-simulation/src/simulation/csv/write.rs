//! Trajectories are written.

use std::io::{self, Write};

use dynamics_runtime::table::{AsArm as _, JointType};
use dynamics_runtime::{JointVector as _, Place, Pose, Size as _, SizedModel, Sizes};
use nalgebra::Dim as _;

use super::super::trajectory::SizedTrajectory;
use super::columns::{QUANTITIES, of_base};

impl<K: Sizes> SizedTrajectory<K> {
    /// Writes the samples as comma-separated values: a header, then a line for each sample.
    ///
    /// The columns are `t [s]`; `q.NAME [rad]` of each joint, in m where it is prismatic; `qd.NAME`,
    /// `qdd.NAME` and `tau.NAME` with their units; and `kinetic energy [J]`, `potential energy [J]` where
    /// the robot knows them ([`Model::energies`](dynamics_runtime::Model::energies)). Numbers have as many digits as it takes to read the same
    /// ones back, with a decimal point whatever the language; a number that is not finite is `NaN`, `inf` or `-inf`.
    /// Velocities, accelerations or torques have no columns where the trajectory does not have one for each time. Energies have
    /// none without velocities.
    ///
    /// On a base that moves, its columns come first among those of a quantity. Before `q.NAME` these are the rotation by rows,
    /// `base.r11` to `base.r33`, and the position, `base.x [m]` to `base.z`. Then they are the velocities, `base.vx [m/s]` to
    /// `base.wz`; the accelerations, `base.vxd` to `base.wzd`; and the forces, `base.fx` to `base.nz`.
    ///
    /// It needs the feature `csv`.
    ///
    /// ```
    /// use robot_dynamics::{Simulation, nalgebra::SVector, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A stone that falls along z.
    ///     struct Stone;
    ///     convention: modified,
    ///     gravity: [0, 0, -8],
    ///     joints: [height: prismatic { mass: 2 }],
    /// }
    ///
    /// let fall = Simulation::new(&Stone).samples(3).run()?;
    /// let mut text = Vec::new();
    /// fall.write_csv(&Stone, &mut text)?;
    /// let text = String::from_utf8(text)?;
    /// let mut lines = text.lines();
    /// assert_eq!(
    ///     lines.next(),
    ///     Some("t [s],q.height [m],qd.height [m/s],qdd.height [m/s^2],tau.height [N],\
    ///           kinetic energy [J],potential energy [J]"),
    /// );
    /// assert!(lines.next().unwrap().starts_with("0,0,0,-8,0,0,"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of the writer.
    pub fn write_csv<R: SizedModel<K>>(&self, robot: &R, out: impl Write) -> io::Result<()> {
        let (names, table) = (robot.names(), robot.sized_table());
        let (names, moves) = (names.as_ref(), self.base_moves());
        let rates = [&self.qd, &self.qdd, &self.tau];
        let is_there = |k: &usize| *k == 0 || rates[k - 1].len() == self.len();
        let mut header = vec!["t [s]".to_owned()];
        for k in (0..QUANTITIES.len()).filter(is_there) {
            header.extend(of_base(moves, k).iter().map(|name| (*name).to_owned()));
            let (symbol, units) = QUANTITIES[k];
            for (name, row) in names.iter().zip(table.arm().rows) {
                let unit = units[usize::from(row.joint_type == JointType::Prismatic)];
                header.push(format!("{symbol}.{name} [{unit}]"));
            }
        }
        let start = Place {
            base: moves.then(Pose::identity),
            q: K::Joints::from_usize(names.len()).vector(),
        };
        let rest = K::Freedoms::from_usize(of_base(moves, 1).len() + names.len()).vector();
        let has_velocities = is_there(&1);
        if has_velocities && robot.sized_energies(&start, &rest).is_some() {
            header.extend(["kinetic", "potential"].map(|kind| format!("{kind} energy [J]")));
        }
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(header)?;
        for (k, (t, place)) in self.t.iter().zip(self.places()).enumerate() {
            let qd = self.qd.get(k).filter(|_| has_velocities);
            let energies = qd.and_then(|qd| robot.sized_energies(&place, qd));
            let base = place.base.as_ref().map(Pose::entries);
            let place = [t]
                .into_iter()
                .chain(base.iter().flatten())
                .chain(place.q.entries());
            let of_rates = (1..QUANTITIES.len()).filter(is_there);
            let of_rates = of_rates.flat_map(|quantity| rates[quantity - 1][k].entries());
            let numbers = place.chain(of_rates).chain(energies.iter().flatten());
            writer.write_record(numbers.copied().map(shortest))?;
        }
        writer.flush()
    }
}

/// A number in as few letters as it takes: `0.5`, `1e-17`.
#[doc(hidden)]
pub fn shortest(x: f64) -> String {
    let (decimal, scientific) = (x.to_string(), format!("{x:e}"));
    if decimal.len() <= scientific.len() {
        decimal
    } else {
        scientific
    }
}
