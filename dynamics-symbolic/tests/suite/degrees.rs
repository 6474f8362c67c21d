//! Degrees of programs as rational functions of what is drawn for their proof: pi, fields, arguments, and one
//! parameter t of each point of the circle, s = 2t/(1 + t^2), c = (1 - t^2)/(1 + t^2).

use dynamics_symbolic::Function;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::program::{Arithmetic, Program};
use dynamics_symbolic::prove::DRAWS;
use dynamics_symbolic::robot::{Robot, Symbol, Value};
use std::collections::BTreeMap;

/// A number is drawn with a probability of at most 5 / 2^64: 64 random bits modulo 2^62 - 57.
const MOST_LIKELY: f64 = 5.0 / 18_446_744_073_709_551_616.0;

/// A bound of the probability that a program, equal in degree to this one, passes the proof of its functions
/// and is wrong.
///
/// A wrong output f differs from the right one, g. The numerator of f - g is a polynomial, of degree at most
/// num f + den g or num g + den f. It vanishes at a random point with a probability of at most its degree times
/// that of the most likely number (Schwartz 1980, Zippel 1979). No degree of g exceeds that of the right program.
pub(crate) fn bound(
    robot: &Robot,
    function: Function,
    program: &Program,
    inverse: &Program,
) -> f64 {
    let mut degrees = Degrees::new(robot);
    let outputs = program.evaluate(&mut degrees);
    let largest = outputs.iter().map(|x| x.numerator + degrees.denominator(x));
    let mut largest = largest.fold(0.0, f64::max);
    let chooses_columns = [
        Function::Regressor,
        Function::PassivityRegressor,
        Function::EnergyRegressors,
        Function::BaseParameters,
    ];
    if chooses_columns.contains(&function) {
        // By chance a state may show no column beyond the k that were found: minors of k + 1 columns vanish.
        let columns = 11.0 * robot.rows.len() as f64;
        largest *= columns * (columns + 1.0) / 2.0;
    }
    if function.has_pivots() {
        // Values are not compared where a pivot of M vanishes by chance.
        let pivots = &outputs[outputs.len() - 2 * robot.dof()..][..robot.dof()];
        largest += pivots.iter().map(|pivot| pivot.numerator).sum::<f64>();
    }
    if matches!(
        function,
        Function::ForwardDynamics | Function::ForwardDynamicsAba
    ) {
        // Accelerations are put into the equations of motion.
        degrees.accelerations = outputs[..robot.dof()].to_vec();
        let residuals = inverse.evaluate(&mut degrees);
        let residuals = residuals
            .iter()
            .map(|x| x.numerator + degrees.denominator(x));
        largest = residuals.fold(largest, f64::max);
    }
    DRAWS as f64 * largest * MOST_LIKELY
}

/// A bound of the degrees of a quotient: of the numerator, and the factors of the denominator with their powers.
#[derive(Clone, Default)]
struct Degree {
    numerator: f64,
    denominator: BTreeMap<usize, f64>,
}

/// The arithmetic of degrees.
struct Degrees<'a> {
    robot: &'a Robot,
    /// The degrees of the factors of denominators; first the 1 + t^2 of the joints.
    factors: Vec<f64>,
    angles: Vec<(Value, usize)>,
    accelerations: Vec<Degree>,
}

impl<'a> Degrees<'a> {
    fn new(robot: &'a Robot) -> Self {
        Degrees {
            robot,
            factors: vec![2.0; robot.dof() + robot.followers().count()],
            angles: Vec::new(),
            accelerations: Vec::new(),
        }
    }

    fn denominator(&self, x: &Degree) -> f64 {
        let degrees = x.denominator.iter();
        degrees.map(|(k, power)| power * self.factors[*k]).sum()
    }

    fn factor(&mut self, degree: f64) -> usize {
        self.factors.push(degree);
        self.factors.len() - 1
    }

    fn angle(&mut self, angle: &Value) -> usize {
        let opposite = -angle.clone();
        let known = |(known, _): &&(Value, usize)| known == angle || *known == opposite;
        if let Some((_, factor)) = self.angles.iter().find(known) {
            return *factor;
        }
        let factor = self.factor(2.0);
        self.angles.push((angle.clone(), factor));
        factor
    }

    /// The sine and the cosine of a multiple of the angle of that factor.
    fn sine(&self, factor: usize, multiple: f64) -> Degree {
        Degree {
            numerator: 2.0 * multiple,
            denominator: [(factor, multiple)].into(),
        }
    }

    fn joint_sine(&self, index: usize) -> Degree {
        let multiple = |(leader, factor): (usize, &Value)| {
            let factor = factor.as_rational()?;
            factor
                .is_int()
                .then(|| (leader, factor.to_f64().value().abs()))
        };
        let followed = self.robot.followed(index).and_then(multiple);
        let (joint, multiple) = followed.unwrap_or((index, 1.0));
        self.sine(joint, multiple)
    }
}

impl Arithmetic for Degrees<'_> {
    type Number = Degree;

    fn rational(&mut self, _: &Rational) -> Degree {
        Degree::default()
    }

    fn symbol(&mut self, symbol: &Symbol) -> Degree {
        match symbol {
            Symbol::AngleSine(angle) | Symbol::AngleCosine(angle) => {
                let factor = self.angle(angle);
                self.sine(factor, 1.0)
            }
            Symbol::Sine(i) | Symbol::Cosine(i) => self.joint_sine(*i),
            Symbol::Acceleration(i) if *i < self.accelerations.len() => {
                self.accelerations[*i].clone()
            }
            _ => Degree {
                numerator: 1.0,
                denominator: BTreeMap::new(),
            },
        }
    }

    fn neg(&mut self, a: Degree) -> Degree {
        a
    }

    fn add(&mut self, a: Degree, b: Degree) -> Degree {
        let mut denominator = a.denominator.clone();
        for (k, power) in &b.denominator {
            let common = denominator.entry(*k).or_default();
            *common = common.max(*power);
        }
        let sum = Degree {
            numerator: 0.0,
            denominator,
        };
        let common = self.denominator(&sum);
        let expanded = [&a, &b].map(|x| x.numerator + common - self.denominator(x));
        Degree {
            numerator: expanded[0].max(expanded[1]),
            ..sum
        }
    }

    fn mul(&mut self, mut a: Degree, b: Degree) -> Degree {
        a.numerator += b.numerator;
        for (k, power) in b.denominator {
            *a.denominator.entry(k).or_default() += power;
        }
        a
    }

    fn div(&mut self, mut a: Degree, b: Degree) -> Degree {
        for (k, power) in b.denominator {
            let common = a.denominator.entry(k).or_default();
            a.numerator += (power - *common).max(0.0) * self.factors[k];
            *common = (*common - power).max(0.0);
        }
        if b.numerator > 0.0 {
            let factor = self.factor(b.numerator);
            a.denominator.insert(factor, 1.0);
        }
        a
    }
}
