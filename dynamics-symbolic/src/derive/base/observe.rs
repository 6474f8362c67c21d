//! Which parameters the forces can tell apart: linear algebra on random motions in the prime field.
//!
//! For a link and a random state let the row of a matrix be the energies of the link's unit
//! parameters, less the same at q_i = 0, qd_i = 0. A combination of columns that vanishes in
//! enough rows vanishes for all states (Schwartz 1980, Zippel 1979): it is in A_i.

use super::geometry::{Geometry, geometry};
use super::group::height;
use crate::derive::place;
use crate::derive::symbols::Symbols;
use crate::exact::{SplitMix64, circle_point};
use crate::expr::{Expr, Fingerprint, Graph};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Base, Coefficient, Grouping, LinkGrouping, Parameter, Robot, Sense, Tie};
use crate::spatial::{AxisMotion, Joint, Motion, Turn, Turns};

type Vector = Vector3<Fingerprint>;

/// Two rows for each sample; no link has more than 11 columns.
const SAMPLES: usize = 14;

impl Grouping {
    /// The grouping that an arm's geometry, joint types, gravity and motors lead to.
    pub fn of(robot: &Robot) -> Self {
        Grouping::of_mechanism(&Mechanism::from(robot))
    }

    /// The same of a mechanism.
    pub(crate) fn of_mechanism(arm: &Mechanism) -> Self {
        let graph = Graph::new();
        let mut symbols = Symbols::new(&graph, arm);
        let exprs = geometry(&mut symbols, arm);
        let links = exprs.map(|x| x.fingerprint());
        let gravity = place::gravity(&mut symbols, arm);
        let gravity = Vector3(gravity.0.map(|g| g.fingerprint()));
        let axes = (0..links.tree.len()).map(|i| moment_axes(&links, i));
        let axes: Vec<_> = axes.collect();
        let mut rows = vec![Vec::new(); axes.len()];
        let mut random = SplitMix64::new(0x6261_7365);
        for _ in 0..SAMPLES {
            for (i, row) in energies(&links, &axes, gravity, &mut random)
                .into_iter()
                .enumerate()
            {
                rows[i].extend(row);
            }
        }
        let mut grouping = Grouping { links: Vec::new() };
        for (i, joint) in arm.joints.iter().enumerate() {
            grouping.links.push(LinkGrouping {
                axes: axes[i],
                kept: Vec::new(),
                ties: Vec::new(),
                coincides: coincides(&exprs, i),
            });
            let height = height(&grouping, &links, i);
            let (kept, ties) = match joint.law {
                // The last of these joints moves the base's body in all directions, the others move nothing else.
                Law::Base { number } if number + 1 < Base::FREEDOMS => (Vec::new(), Vec::new()),
                Law::Base { .. } => (Parameter::of_link(false).to_vec(), Vec::new()),
                _ => combinations(&rows[i], Parameter::of_link(joint.has_motor()), height),
            };
            let link = &mut grouping.links[i];
            (link.kept, link.ties) = (kept, ties);
        }
        grouping
    }
}

fn coincides(geometry: &Geometry<Expr<'_>>, i: usize) -> Option<Sense> {
    let link = &geometry.links[i];
    geometry.tree.parent(i)?;
    let ([x, y, _], direction) = (link.before.origin.0, geometry.direction(i));
    let is_on_axis = [x, y, direction[0], direction[1]];
    if is_on_axis.iter().any(|x| !x.is_zero()) {
        return None;
    }
    Some(if direction[2].fingerprint() == Fingerprint::ONE {
        Sense::Same
    } else {
        Sense::Opposite
    })
}

/// See [`LinkGrouping::axes`].
fn moment_axes(geometry: &Geometry<Fingerprint>, i: usize) -> usize {
    let is_prismatic = geometry.links[i].axis_motion == AxisMotion::Slides;
    let Some(to) = geometry.last_revolute(i).filter(|_| is_prismatic) else {
        return i;
    };
    let along = geometry.rotation(i, to).0[2];
    let is_oblique = along.iter().filter(|x| !x.is_zero()).count() > 1;
    if is_oblique { to } else { i }
}

/// Twice the kinetic energy, and the potential energy, of the unit parameters of one link.
pub(super) struct Energies<R> {
    pub(super) kinetic: [R; 11],
    pub(super) potential: [R; 11],
}

/// 2 T = w.J w + 2 h.(v x w) + m v.v + I qd^2 and U = -m g.p - g.h, in the link's frame, with w, v
/// the velocities of frame and origin, and p the position of the origin.
pub(super) fn unit_energies<R: Ring>(
    Motion { w, v }: Motion<R>,
    qd: R,
    g: Vector3<R>,
    weight: R,
    zero: R,
) -> Energies<R> {
    let [x, y, z] = w.0;
    let h = v.cross(w);
    let twice = |a: R| a + a;
    Energies {
        kinetic: [
            x * x,
            twice(x * y),
            twice(x * z),
            y * y,
            twice(y * z),
            z * z,
            twice(h[0]),
            twice(h[1]),
            twice(h[2]),
            v.dot(v),
            qd * qd,
        ],
        potential: [
            zero, zero, zero, zero, zero, zero, -g[0], -g[1], -g[2], -weight, zero,
        ],
    }
}

/// A joint at a random position, with no geometry before it.
fn anywhere(axis_motion: AxisMotion, random: &mut SplitMix64) -> Joint<Fingerprint> {
    let zero = Fingerprint::ZERO;
    let none = Turn::none(zero, Fingerprint::ONE);
    let (turn, slide) = match axis_motion {
        AxisMotion::Turns => (Turn::from(circle_point(random)), zero),
        AxisMotion::Slides => (none, Fingerprint::random(random)),
    };
    Joint {
        zero,
        axis_motion,
        before: none,
        twist: Turns(Vec::new()),
        turn,
        offset: Vector3::splat(zero),
        slide,
    }
}

/// The rows of every link at one random state.
fn energies(
    geometry: &Geometry<Fingerprint>,
    axes: &[usize],
    gravity: Vector,
    random: &mut SplitMix64,
) -> Vec<[Vec<Fingerprint>; 2]> {
    let zero = Fingerprint::ZERO;
    let mut rows = Vec::with_capacity(axes.len());
    geometry
        .tree
        .outward((Motion::splat(zero), gravity), |i, (motion, g)| {
            let link = &geometry.links[i];
            let still = geometry.joint(i);
            let (mut motion, mut g) = (motion.enter(&still), still.enter(*g));
            let before = unit_energies(motion, zero, g, zero, zero);
            let (mut qd, mut weight) = (zero, zero);
            if !link.stands {
                qd = Fingerprint::random(random);
                if !link.is_of_base {
                    let moved = anywhere(link.axis_motion, random);
                    motion = motion.enter(&moved);
                    g = moved.enter(g);
                    weight = g[2] * moved.slide;
                }
                motion = motion.with_joint(link.axis_motion, qd);
            }
            let after = unit_energies(motion, qd, g, weight, zero);
            let rotation = geometry.rotation_of_moments(i, axes[i]);
            let row = |after: [Fingerprint; 11], before: [Fingerprint; 11]| {
                let mut row: [_; 11] = core::array::from_fn(|k| after[k] - before[k]);
                rotate_moments(&mut row, rotation.as_ref());
                row.to_vec()
            };
            rows.push([
                row(after.kinetic, before.kinetic),
                row(after.potential, before.potential),
            ]);
            (motion, g)
        });
    rows
}

/// Turns the entries that belong to a link's first moments into the axes in which these are written.
pub(super) fn rotate_moments<R: Ring>(row: &mut [R; 11], rotation: Option<&Matrix3<R>>) {
    if let Some(rotation) = rotation {
        let moment = rotation.apply(Vector3::new(row[6], row[7], row[8]));
        row[6..9].copy_from_slice(&moment.0);
    }
}

/// Which columns are not combinations of those before them, and how the others are made of them.
fn combinations(
    rows: &[Vec<Fingerprint>],
    parameters: &[Parameter],
    height: Fingerprint,
) -> (Vec<Parameter>, Vec<Tie>) {
    let mut rows = rows.to_vec();
    let (mut kept, mut ties) = (Vec::<Parameter>::new(), Vec::new());
    for &parameter in parameters {
        let column = parameter.index();
        let pivot = (kept.len()..rows.len()).find(|&r| !rows[r][column].is_zero());
        let found = match pivot {
            Some(_) => None,
            None => ties_of(&rows, parameter, &kept, height),
        };
        match (pivot, found) {
            (Some(pivot), _) => {
                rows.swap(pivot, kept.len());
                eliminate(&mut rows, kept.len(), column);
                kept.push(parameter);
            }
            (None, Some(found)) => ties.extend(found),
            // No coefficient of this form: that would be a defect, which the proof reports.
            (None, None) => {}
        }
    }
    (kept, ties)
}

/// Reduced echelon form: 1 at the pivot, 0 elsewhere in the column.
fn eliminate(rows: &mut [Vec<Fingerprint>], pivot: usize, column: usize) {
    let inverse = rows[pivot][column].inverse().expect("a pivot is not zero");
    for x in &mut rows[pivot] {
        *x = *x * inverse;
    }
    let pivot_row = rows[pivot].clone();
    for (r, row) in rows.iter_mut().enumerate() {
        let factor = row[column];
        if r != pivot && !factor.is_zero() {
            for (x, &p) in row.iter_mut().zip(&pivot_row) {
                *x = *x - factor * p;
            }
        }
    }
}

/// The entries of a column that depends on the kept ones, as coefficients.
fn ties_of(
    rows: &[Vec<Fingerprint>],
    dropped: Parameter,
    kept: &[Parameter],
    height: Fingerprint,
) -> Option<Vec<Tie>> {
    let mut ties = Vec::new();
    for (row, &kept) in rows.iter().zip(kept) {
        let entry = row[dropped.index()];
        if entry.is_zero() {
            continue;
        }
        let sizes = [
            (Coefficient::One, Fingerprint::ONE),
            (Coefficient::Height, height),
        ];
        let (coefficient, size) = sizes
            .into_iter()
            .find(|&(_, size)| entry == size || entry == -size)?;
        ties.push(Tie {
            dropped,
            kept,
            coefficient,
            negative: entry != size,
        });
    }
    Some(ties)
}
