//! Dry friction of a joint, from its row.

#[cfg(feature = "std")]
use crate::size::Size;
#[cfg(feature = "std")]
use crate::table::Arm;
use crate::{Row, Scalar, Stribeck};

/// Friction beside the viscous one: Coulomb's, which may differ by direction, and static friction that falls to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DryFriction {
    coulomb: [f64; 2],
    stribeck: Option<Stribeck>,
}

impl DryFriction {
    /// None.
    pub const NONE: DryFriction = DryFriction {
        coulomb: [0.0; 2],
        stribeck: None,
    };

    /// The dry friction of a row.
    pub fn of(row: &Row) -> Self {
        DryFriction {
            coulomb: row.coulomb,
            stribeck: row.stribeck,
        }
    }

    /// C + (S - C) exp(-(qd/v)^2) of a motion one way: C is that of positive velocities where `way` is
    /// positive.
    pub fn magnitude(&self, way: f64, qd: f64) -> f64 {
        self.coulomb(way) + self.beyond_coulomb(way, qd)
    }

    fn coulomb(&self, way: f64) -> f64 {
        let [positive, negative] = self.coulomb;
        if way < 0.0 { negative } else { positive }
    }

    /// (S - C) exp(-(qd/v)^2)
    fn beyond_coulomb(&self, way: f64, qd: f64) -> f64 {
        self.stribeck
            .map_or(0.0, |Stribeck { friction, velocity }| {
                let x = qd / velocity;
                (friction - self.coulomb(way)) * Scalar::exp(-(x * x))
            })
    }

    /// The force at a velocity, with its sign; zero at rest.
    pub fn force(&self, qd: f64) -> f64 {
        let way = Scalar::sign(qd);
        way * self.magnitude(way, qd)
    }

    /// The derivative of the force by the velocity, where the velocity does not change its sign.
    pub fn slope(&self, qd: f64) -> f64 {
        let way = Scalar::sign(qd);
        self.stribeck.map_or(0.0, |Stribeck { velocity: v, .. }| {
            -way * self.beyond_coulomb(way, qd) * (2.0 * qd / v / v)
        })
    }

    /// The second derivative of the force by the velocity: of x = exp(-(qd/v)^2) it is
    /// ((2 qd/v^2)^2 - 2/v^2) x.
    pub fn curvature(&self, qd: f64) -> f64 {
        let way = Scalar::sign(qd);
        self.stribeck.map_or(0.0, |Stribeck { velocity: v, .. }| {
            let slope = 2.0 * qd / v / v;
            way * self.beyond_coulomb(way, qd) * (slope * slope - 2.0 / v / v)
        })
    }
}

#[cfg(feature = "std")]
impl DryFriction {
    /// Whether there is none at any velocity.
    pub fn is_none(&self) -> bool {
        let beyond = self.stribeck.map_or(0.0, |stribeck| stribeck.friction);
        self.coulomb == [0.0; 2] && beyond == 0.0
    }

    /// The greatest that it can be.
    pub fn greatest(&self) -> f64 {
        let stribeck = self.stribeck.map_or(0.0, |stribeck| stribeck.friction);
        let [positive, negative] = self.coulomb.map(f64::abs);
        stribeck.abs().max(positive).max(negative)
    }

    /// The greatest that its slope can be: exp(-x^2) has a slope of at most sqrt(2/e) < 0.86.
    pub fn greatest_slope(&self) -> f64 {
        self.stribeck.map_or(0.0, |stribeck| {
            0.86 * self.greatest() / stribeck.velocity.abs()
        })
    }

    /// The greatest that its curvature can be.
    pub fn greatest_curvature(&self) -> f64 {
        self.stribeck.map_or(0.0, |stribeck| {
            2.0 * self.greatest() / (stribeck.velocity * stribeck.velocity)
        })
    }
}

/// The dry friction that a joint feels: its own, and by their factors that of its followers.
///
/// A follower moves at k qd, and a force f on it is k f to the joint that it follows.
#[cfg(feature = "std")]
#[derive(Clone, Debug, PartialEq)]
pub struct JointFriction {
    own: DryFriction,
    followers: Vec<(f64, DryFriction)>,
}

#[cfg(feature = "std")]
impl JointFriction {
    /// None.
    pub const NONE: JointFriction = JointFriction {
        own: DryFriction::NONE,
        followers: Vec::new(),
    };

    /// Whether there is none at any velocity.
    pub fn is_none(&self) -> bool {
        self.parts()
            .all(|(factor, dry)| factor == 0.0 || dry.is_none())
    }

    /// The friction against a motion one way, as [`DryFriction::magnitude`].
    pub fn magnitude(&self, way: f64, qd: f64) -> f64 {
        self.parts()
            .map(|(factor, dry)| factor.abs() * dry.magnitude(factor * way, factor * qd))
            .sum()
    }

    /// The greatest force that holds the joint at rest against a motion that way.
    pub fn breakaway(&self, way: f64) -> f64 {
        self.magnitude(way, 0.0)
    }

    /// The force at a velocity, with its sign; zero at rest.
    pub fn force(&self, qd: f64) -> f64 {
        self.parts()
            .map(|(factor, dry)| factor * dry.force(factor * qd))
            .sum()
    }

    fn parts(&self) -> impl Iterator<Item = (f64, DryFriction)> {
        let followers = self.followers.iter().copied();
        core::iter::once((1.0, self.own)).chain(followers)
    }
}

#[cfg(feature = "std")]
impl Arm<'_> {
    /// The dry friction that holds and brakes the joints: their own, and that of the joints that follow them. A base that moves
    /// has none.
    pub fn dry_friction<V: Size>(self) -> V::Each<JointFriction> {
        let of_joint = |joint: usize| {
            let all = self.followers.iter();
            let followers = all.filter(|follower| follower.leader == joint);
            JointFriction {
                own: DryFriction::of(&self.rows[joint]),
                followers: followers
                    .map(|follower| (follower.factor, DryFriction::of(&follower.row)))
                    .collect(),
            }
        };
        let of_base = JointFriction::NONE;
        V::from_usize(self.freedoms()).each(|k| self.joint_of(k).map_or(of_base.clone(), of_joint))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::Const;

    use super::DryFriction;
    use crate::table::AsArm as _;
    use crate::{Convention, Follower, JointType, Row, Stribeck, Table};

    fn joint() -> DryFriction {
        DryFriction::of(&Row {
            coulomb: [0.5, 0.4],
            stribeck: Some(Stribeck {
                friction: 0.8,
                velocity: 0.1,
            }),
            ..Row::new(JointType::Revolute)
        })
    }

    #[test]
    fn static_friction_falls_to_that_of_the_direction() {
        let joint = joint();
        assert_eq!(joint.force(0.0), 0.0);
        assert_eq!([1.0, -1.0].map(|way| joint.magnitude(way, 0.0)), [0.8, 0.8]);
        assert_eq!([50.0, -50.0].map(|qd| joint.force(qd)), [0.5, -0.4]);
        let left = (-1.0_f64).exp();
        assert_relative_eq!(joint.force(0.1), 0.5 + 0.3 * left, max_relative = 1e-15);
        assert_relative_eq!(joint.force(-0.1), -0.4 - 0.4 * left, max_relative = 1e-15);
    }

    #[test]
    fn the_slope_is_that_of_the_force() {
        let (joint, h) = (joint(), 1e-6);
        for qd in [-0.3, -0.1, -0.02, 0.01, 0.07, 0.2] {
            let slope = (joint.force(qd + h) - joint.force(qd - h)) / (2.0 * h);
            assert_relative_eq!(joint.slope(qd), slope, epsilon = 1e-8);
            assert!(slope.abs() <= joint.greatest_slope());
        }
        assert_eq!(joint.slope(0.0), 0.0);
    }

    /// A follower that moves half as fast the other way: what holds it holds the joint by a half.
    #[test]
    fn friction_of_followers_counts_by_their_factors() {
        let follower = Follower {
            row: Row {
                coulomb: [0.3, 0.2],
                ..Row::new(JointType::Prismatic)
            },
            place: 1,
            leader: 0,
            factor: -0.5,
            offset: 0.0,
        };
        let mut table = Table::new(
            Convention::Modified,
            [0.0; 3],
            [Row {
                coulomb: [0.5, 0.4],
                ..Row::new(JointType::Revolute)
            }],
        );
        table.followers.push(follower);
        let [joint] = table.arm().dry_friction::<Const<1>>();
        assert!(!joint.is_none());
        assert_relative_eq!(joint.force(2.0), 0.5 + 0.5 * 0.2);
        assert_relative_eq!(joint.force(-2.0), -0.4 - 0.5 * 0.3);
        assert_eq!([1.0, -1.0].map(|way| joint.breakaway(way)), [0.6, 0.55]);
    }

    #[test]
    fn none_is_none_both_ways() {
        assert!(DryFriction::NONE.is_none() && !joint().is_none());
        let one_way = DryFriction {
            coulomb: [0.0, 0.1],
            ..DryFriction::NONE
        };
        assert!(!one_way.is_none());
    }
}
