//! The parameters of a link: what it keeps, and what moves to the link before it.

use super::geometry::Geometry;
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::{Coefficient, Grouping, Parameter, Sense};
use crate::spatial::Body;

/// The parameters of a link after some have moved.
pub(crate) struct Moved<R> {
    /// The base parameters of the link.
    pub(crate) kept: Vec<R>,
    /// Parameters that move, in the frame of the previous link.
    pub(crate) inward: Body<R>,
}

impl<R: Ring> Body<R> {
    /// The ten parameters in the order of [`Parameter::ALL`].
    pub(crate) fn parameters(&self) -> [R; 10] {
        let (j, h) = (&self.inertia, self.moment);
        [
            j.xx, j.xy, j.xz, j.yy, j.yz, j.zz, h[0], h[1], h[2], self.mass,
        ]
    }

    /// The body with all parameters multiplied.
    pub(crate) fn times(&self, factor: R) -> Self {
        Body::from_parameters(self.parameters().map(|x| x * factor))
    }

    /// A body by its ten parameters.
    pub(crate) fn from_parameters(p: [R; 10]) -> Self {
        let mut body = Body::splat(p[9]);
        body.moment = Vector3::new(p[6], p[7], p[8]);
        let j = &mut body.inertia;
        (j.xx, j.xy, j.xz, j.yy, j.yz, j.zz) = (p[0], p[1], p[2], p[3], p[4], p[5]);
        body
    }
}

/// Groups the parameters of link i: those of its own and what came from beyond, with the motor's.
pub(crate) fn group<R: Ring>(
    grouping: &Grouping,
    geometry: &Geometry<R>,
    i: usize,
    (body, motor): (Body<R>, R),
) -> Moved<R> {
    let link = &grouping.links[i];
    let rotation = geometry.rotation_of_moments(i, link.axes);
    let turned = |body: Body<R>, rotation: &Matrix3<R>| Body {
        moment: rotation.apply(body.moment),
        ..body
    };
    let body = rotation.as_ref().map_or(body, |r| turned(body, r));
    let mut values = body.parameters().to_vec();
    values.push(motor);
    let mut inward = [geometry.zero; 10];
    for &parameter in Parameter::of_link(false) {
        if !link.kept.contains(&parameter) {
            inward[parameter.index()] = values[parameter.index()];
        }
    }
    let mut kept = values.clone();
    for tie in &link.ties {
        let (from, to) = (tie.dropped.index(), tie.kept.index());
        let part = match tie.coefficient {
            Coefficient::One => values[from],
            Coefficient::Height => height(grouping, geometry, i) * values[from],
        };
        let part = if tie.negative { -part } else { part };
        kept[to] = kept[to] + part;
        // Motor and J_zz have the same effect only on an axis whose link is turned by nothing else: no
        // motion of the link before it feels J_zz.
        let is_felt = tie.dropped != Parameter::Motor || tie.kept != Parameter::Jzz;
        if to < 10 && is_felt {
            inward[to] = inward[to] - part;
        }
    }
    let inward = Body::from_parameters(inward);
    let inward = rotation.map_or(inward, |r| turned(inward, &r.transpose()));
    Moved {
        kept: link.kept.iter().map(|k| kept[k.index()]).collect(),
        inward: geometry.leave(i, inward),
    }
}

/// The body of unit `parameter` of link i, in the link's own axes; none for a motor.
pub(crate) fn unit<R: Ring>(
    grouping: &Grouping,
    geometry: &Geometry<R>,
    i: usize,
    parameter: Parameter,
) -> Option<Body<R>> {
    let mut values = [geometry.zero; 10];
    *values.get_mut(parameter.index())? = geometry.one;
    let mut body = Body::from_parameters(values);
    if let Some(rotation) = geometry.rotation_of_moments(i, grouping.links[i].axes) {
        body.moment = rotation.transpose().apply(body.moment);
    }
    Some(body)
}

impl<R: Ring> Geometry<R> {
    /// From link i's axes to those of link `to`, in which its first moments are written; `None` where these are its own.
    pub(super) fn rotation_of_moments(&self, i: usize, to: usize) -> Option<Matrix3<R>> {
        (to != i).then(|| self.rotation(i, to))
    }
}

/// How far along the axis the origin is from where the axis meets the one before it; axes that
/// coincide count as one.
pub(super) fn height<R: Ring>(grouping: &Grouping, geometry: &Geometry<R>, i: usize) -> R {
    let (link, direction) = (&geometry.links[i], geometry.direction(i));
    let [x, y, z] = link.before.origin.0;
    let coincides = grouping.links[i].coincides.zip(geometry.tree.parent(i));
    let Some((sense, before)) = coincides else {
        return link.d + x * direction[0] + y * direction[1];
    };
    let before = z + height(grouping, geometry, before);
    match sense {
        Sense::Same => link.d + before,
        Sense::Opposite => link.d - before,
    }
}
