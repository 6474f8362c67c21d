//! The states at which a model is checked.

use core::f64::consts::FRAC_PI_2;
use core::ops::RangeInclusive;

use dynamics_runtime::internal::SplitMix64;
use dynamics_runtime::table::{Arm, JointType, Stribeck};
use dynamics_runtime::{Pose, SizedState};
use nalgebra::{DVector, Dyn, Quaternion, UnitQuaternion, Vector3};

use super::Check;

/// Right angles in all combinations would be 4^N states; this many random combinations do.
const RIGHT_ANGLES: usize = 8;
const LARGE_ANGLES: usize = 4;
const AT_REST: usize = 4;
const SLOW: usize = 16;

impl Check {
    /// The special states, then the random ones, each with a name. `farthest` says how far the
    /// followers of a joint go for each unit of it: their angles stay as small, because a rounded angle has a wrong sine.
    pub(super) fn states(
        &self,
        joints: &[JointType],
        farthest: &[f64],
    ) -> Vec<(String, SizedState<Dyn>)> {
        let mut random = SplitMix64(self.seed);
        let mut states = vec![(
            "zero".into(),
            SizedState {
                q: DVector::zeros(joints.len()),
                qd: DVector::zeros(joints.len()),
                qdd: DVector::zeros(joints.len()),
            },
        )];
        let mut add = |label: String, change: &dyn Fn(&mut SplitMix64, &mut SizedState<Dyn>)| {
            let mut state = self.random_state(joints.len(), &mut random);
            change(&mut random, &mut state);
            states.push((label, state));
        };

        add("zero, moving".into(), &|_, state| state.q.fill(0.0));
        add("pi/2".into(), &|_, state| state.q.fill(FRAC_PI_2));
        add("-pi/2".into(), &|_, state| state.q.fill(-FRAC_PI_2));
        for i in 0..RIGHT_ANGLES {
            add(format!("right angles {i}"), &|random, state| {
                state
                    .q
                    .apply(|q| *q = (random.next() % 4) as f64 * FRAC_PI_2);
            });
        }
        for i in 0..LARGE_ANGLES {
            add(format!("large angles {i}"), &|random, state| {
                for ((q, joint_type), farthest) in state.q.iter_mut().zip(joints).zip(farthest) {
                    let angle = random.within(&(-1e3..=1e3)) / farthest;
                    // No slide moves by a kilometre: moments of inertia over that distance cost
                    // the numeric side digits that the model has.
                    if *joint_type == JointType::Revolute {
                        *q = angle;
                    }
                }
            });
        }
        for i in 0..AT_REST {
            add(format!("at rest {i}"), &|_, state| state.qd.fill(0.0));
        }
        for i in 0..self.samples {
            add(format!("random {i}"), &|_, _| {});
        }
        states
    }

    /// States at which friction falls with the velocity: no joint is faster than about three times its
    /// Stribeck velocity. There are none where no joint has one.
    pub(super) fn slow_states(&self, table: Arm<'_>) -> Vec<(String, SizedState<Dyn>)> {
        let stribeck: Vec<_> = table.rows.iter().map(|row| row.stribeck).collect();
        if stribeck.iter().all(Option::is_none) {
            return Vec::new();
        }
        let mut random = SplitMix64(!self.seed);
        let slow = |i| {
            let mut state = self.random_state(stribeck.len(), &mut random);
            for (qd, stribeck) in state.qd.iter_mut().zip(&stribeck) {
                if let Some(Stribeck { velocity, .. }) = stribeck {
                    *qd = velocity * random.within(&(-3.0..=3.0));
                }
            }
            (format!("slow {i}"), state)
        };
        (0..SLOW).map(slow).collect()
    }

    /// Gives the states of the joints a base that moves: velocities and accelerations before those of the joints, zero where
    /// the state is at rest. Returned is where it stands.
    pub(super) fn on_moving_base(
        &self,
        states: &mut [(String, SizedState<Dyn>)],
    ) -> Vec<Pose<f64>> {
        let mut random = SplitMix64(self.seed ^ 0xba5e);
        let mut pose_of = |(label, state): &mut (String, SizedState<Dyn>)| {
            let mut before = |values: &DVector<f64>, range: &RangeInclusive<f64>, is_zero: bool| {
                let six: Vec<f64> = (0..6).map(|_| random.within(range)).collect();
                let six = six.into_iter().map(|x| if is_zero { 0.0 } else { x });
                DVector::from_iterator(6 + values.len(), six.chain(values.iter().copied()))
            };
            let is_zero = label == "zero";
            let is_at_rest = is_zero || label.starts_with("at rest");
            state.qd = before(&state.qd, &self.velocities, is_at_rest);
            state.qdd = before(&state.qdd, &self.accelerations, is_zero);
            let pose = random_pose(&mut random);
            if is_zero { Pose::identity() } else { pose }
        };
        states.iter_mut().map(&mut pose_of).collect()
    }

    fn random_state(&self, joints: usize, random: &mut SplitMix64) -> SizedState<Dyn> {
        let mut vector = |range| DVector::from_fn(joints, |_, _| random.within(range));
        SizedState {
            q: vector(&self.positions),
            qd: vector(&self.velocities),
            qdd: vector(&self.accelerations),
        }
    }
}

/// A base that stands within 2 m of the world's origin, turned in any way.
fn random_pose(random: &mut SplitMix64) -> Pose<f64> {
    let mut number = |size: f64| random.within(&(-size..=size));
    let quaternion = Quaternion::new(number(1.0), number(1.0), number(1.0), number(1.0));
    let position = Vector3::from_fn(|_, _| number(2.0));
    let turn = UnitQuaternion::from_quaternion(quaternion);
    Pose {
        rotation: turn.to_rotation_matrix().into_inner(),
        position,
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_PI_2;

    use dynamics_runtime::SizedState;
    use dynamics_runtime::table::{JointType::Prismatic, JointType::Revolute};
    use nalgebra::Dyn;

    use crate::check::Check;

    #[test]
    fn equal_settings_give_equal_states() {
        let states = |check: &Check| check.states(&[Revolute; 4], &[1.0; 4]);
        let check = Check::new().samples(5).seed(3);
        assert_eq!(states(&check), states(&check.clone()));
        assert_ne!(states(&check), states(&check.clone().seed(4)));
    }

    #[test]
    fn only_what_turns_is_at_large_angles() {
        let states = Check::new().states(&[Prismatic, Revolute], &[1.0; 2]);
        let mut large = states
            .iter()
            .filter(|(label, _)| label.starts_with("large"));
        let within = |(_, state): &(String, SizedState<Dyn>)| {
            state.q[0].abs() <= 2.0 * FRAC_PI_2 && state.q[1].abs() <= 1e3
        };
        assert!(large.clone().count() > 0 && large.all(within));
    }

    #[test]
    fn special_states_are_what_their_names_say() {
        let states = Check::new().samples(2).states(&[Revolute; 3], &[1.0; 3]);
        for (label, state) in &states {
            let quarters = &state.q / FRAC_PI_2;
            match label.split(' ').next().unwrap() {
                "zero" => assert!(state.qdd.amax() == 0.0 && state.q == state.qd),
                "zero," => assert!(state.q.amax() == 0.0 && state.qd.amin() > 0.0),
                "pi/2" | "-pi/2" | "right" => assert_eq!(quarters, quarters.map(f64::round)),
                "large" => assert!(state.q.amax() > 100.0),
                "at" => assert!(state.qd.amax() == 0.0 && state.qdd.amin() > 0.0),
                _ => assert!(state.q.amax() <= 2.0 * FRAC_PI_2),
            }
        }
        assert_eq!(states.len(), 1 + 1 + 2 + 8 + 4 + 4 + 2);
    }
}
