//! A robot from any bytes.

use arbitrary::{Result, Unstructured};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{
    Base, Body, Convention, Coupling, JointType, Placement, Robot, Row, Spring, Stribeck, Tool,
    Value,
};

/// Cells of a robot, and the values of its fields.
struct Cells<'a> {
    bytes: Unstructured<'a>,
    fields: Vec<f64>,
}

/// A robot of one to four joints, and the values of its fields.
pub(crate) fn robot(bytes: &[u8]) -> Result<(Robot, Vec<f64>)> {
    let mut cells = Cells {
        bytes: Unstructured::new(bytes),
        fields: Vec::new(),
    };
    let dof = cells.bytes.int_in_range(1..=4)?;
    let convention = match cells.bytes.arbitrary()? {
        true => Convention::Standard,
        false => Convention::Modified,
    };
    let gravity = cells.cells()?;
    let rows = (1..=dof).map(|i| cells.row(i)).collect::<Result<_>>()?;
    let (base, tool) = (cells.base()?, cells.tool()?);
    let robot = Robot {
        name: "random".to_owned(),
        fields: (0..cells.fields.len()).map(|i| format!("p{i}")).collect(),
        convention,
        gravity,
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base,
        tool,
    };
    Ok((robot, cells.fields))
}

/// A robot of two to seven joints, some of which follow others, and the values of its fields. A joint that follows a
/// follower follows that one's leader.
pub(crate) fn coupled_robot(bytes: &[u8]) -> Result<(Robot, Vec<f64>)> {
    let mut cells = Cells {
        bytes: Unstructured::new(bytes),
        fields: Vec::new(),
    };
    let count = cells.bytes.int_in_range(2..=7)?;
    let mut rows = (0..count)
        .map(|i| cells.row(i))
        .collect::<Result<Vec<_>>>()?;
    for i in 1..count {
        let before = cells.bytes.int_in_range(0..=2 * i)?;
        // Half of the joints move by themselves.
        let Some(next) = rows
            .get(before)
            .filter(|_| before < i)
            .map(|row| row.follows.clone())
        else {
            continue;
        };
        let (factor, offset) = (cells.factor()?, cells.angle()?);
        rows[i].follows = Some(match next {
            None => Coupling {
                leader: before,
                factor,
                offset,
            },
            // k (k' q + c') + c
            Some(next) => Coupling {
                leader: next.leader,
                factor: factor.clone() * next.factor,
                offset: factor * next.offset + offset,
            },
        });
    }
    let gravity = cells.cells()?;
    let robot = Robot {
        name: "random".to_owned(),
        fields: (0..cells.fields.len()).map(|i| format!("p{i}")).collect(),
        convention: Convention::Modified,
        gravity,
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    };
    Ok((robot, cells.fields))
}

impl Cells<'_> {
    /// A factor of up to six decimals between -3 and 3, or a field.
    fn factor(&mut self) -> Result<Value> {
        let decimals = self.bytes.int_in_range(0..=7)?;
        if decimals == 7 {
            return self.field();
        }
        let scale = 10_i64.pow(decimals);
        let numerator = self.bytes.int_in_range(1..=3 * scale)?;
        let size = Value::Rational(Rational::from(numerator) / Rational::from(scale));
        Ok(if self.bytes.arbitrary()? { -size } else { size })
    }

    fn row(&mut self, i: usize) -> Result<Row> {
        let joint_type = match self.bytes.arbitrary()? {
            true => JointType::Revolute,
            false => JointType::Prismatic,
        };
        Ok(Row {
            a: self.cell()?,
            alpha: self.angle()?,
            d: self.cell()?,
            theta: self.angle()?,
            mass: self.positive()?,
            com: self.cells()?,
            inertia: self.tensor()?,
            motor_inertia: self.positive()?,
            gear_ratio: self.cell()?,
            viscous: self.positive()?,
            coulomb: [self.positive()?, self.positive()?],
            stribeck: self.stribeck()?,
            spring: self.spring()?,
            ..Row::new(format!("joint{i}"), joint_type)
        })
    }

    fn stribeck(&mut self) -> Result<Option<Stribeck>> {
        Ok(match self.bytes.int_in_range(0..=3)? {
            0 => Some(Stribeck {
                friction: self.positive()?,
                velocity: Value::integer(1) + self.positive()?,
            }),
            _ => None,
        })
    }

    fn spring(&mut self) -> Result<Option<Spring>> {
        Ok(match self.bytes.int_in_range(0..=3)? {
            0 => Some(Spring {
                stiffness: self.positive()?,
                rest: self.cell()?,
            }),
            _ => None,
        })
    }

    /// None where the input ends before: the tables of older inputs stay what they are.
    fn base(&mut self) -> Result<Option<Base>> {
        Ok(match self.bytes.arbitrary()? {
            true => Some(Base::Standing(self.placement()?)),
            false => None,
        })
    }

    /// Likewise.
    fn tool(&mut self) -> Result<Option<Tool>> {
        Ok(match self.bytes.arbitrary()? {
            true => Some(Tool {
                placement: self.placement()?,
                body: Body {
                    mass: self.positive()?,
                    com: self.cells()?,
                    inertia: self.tensor()?,
                },
            }),
            false => None,
        })
    }

    fn placement(&mut self) -> Result<Placement> {
        Ok(Placement {
            xyz: self.cells()?,
            rpy: [self.angle()?, self.angle()?, self.angle()?],
        })
    }

    fn cells<const N: usize>(&mut self) -> Result<[Value; N]> {
        let cells: Vec<Value> = (0..N).map(|_| self.cell()).collect::<Result<_>>()?;
        Ok(cells.try_into().expect("as many"))
    }

    /// A number in hundredths, between -2.56 and 2.55.
    fn number(&mut self) -> Result<Value> {
        let hundredths = self.bytes.int_in_range(-256..=255)?;
        Ok(Value::Rational(
            Rational::from(hundredths) / Rational::from(100),
        ))
    }

    /// A cell that is not negative, whatever the fields are: they are positive.
    fn positive(&mut self) -> Result<Value> {
        Ok(match self.cell()? {
            Value::Rational(x) if x < Rational::ZERO => Value::Rational(-x),
            value @ (Value::Rational(_) | Value::Field(_)) => value,
            value => value.clone() * value,
        })
    }

    /// A tensor that a body can have: the sum of m (r.r 1 - r r^T) of up to three points. With any
    /// other M may vanish where V does not, and errors have nothing to be measured against.
    fn tensor(&mut self) -> Result<[Value; 6]> {
        let mut tensor = [(); 6].map(|()| Value::zero());
        for _ in 0..self.bytes.int_in_range(0..=3)? {
            let (mass, point) = (self.positive()?, self.cells::<3>()?);
            let product = |i: usize, j: usize| mass.clone() * point[i].clone() * point[j].clone();
            let [xx, yy, zz] = [0, 1, 2].map(|i| product(i, i));
            let of_point = [
                yy.clone() + zz.clone(),
                xx.clone() + zz,
                xx + yy,
                -product(0, 1),
                -product(1, 2),
                -product(0, 2),
            ];
            for (entry, more) in tensor.iter_mut().zip(of_point) {
                *entry = entry.clone() + more;
            }
        }
        Ok(tensor)
    }

    /// Mostly zero, small numbers, fields and expressions of them.
    fn cell(&mut self) -> Result<Value> {
        Ok(match self.bytes.int_in_range(0..=9)? {
            0..=3 => Value::zero(),
            4 | 5 => self.number()?,
            6 => Value::integer(1),
            7 => -Value::integer(1),
            8 => self.field()?,
            _ => self.expression(2)?,
        })
    }

    /// Mostly right angles.
    fn angle(&mut self) -> Result<Value> {
        let quarter_turn = Value::Pi * Value::Rational(Rational::ONE / Rational::from(2));
        Ok(match self.bytes.int_in_range(0..=9)? {
            0..=2 => Value::zero(),
            3..=6 => quarter_turn * Value::integer(self.bytes.int_in_range(-4..=4)?),
            7 => self.number()?,
            8 => self.field()?,
            _ => self.field()? + quarter_turn,
        })
    }

    /// One of up to four fields, whose values have no quarter turns in them.
    fn field(&mut self) -> Result<Value> {
        let index = self.bytes.int_in_range(0..=3)?;
        while self.fields.len() <= index {
            let sixteenths: i8 = self.bytes.int_in_range(4..=60)?;
            self.fields.push(f64::from(sixteenths) / 16.0);
        }
        Ok(Value::field(index))
    }

    fn expression(&mut self, depth: usize) -> Result<Value> {
        if depth == 0 {
            return self.field();
        }
        let a = self.expression(depth - 1)?;
        Ok(match self.bytes.int_in_range(0..=4)? {
            0 => a + self.number()?,
            1 => a * self.expression(depth - 1)?,
            2 => a - self.expression(depth - 1)?,
            3 => -a,
            // Fields are positive.
            _ => {
                let divisor = self.field()?;
                a.checked_div(divisor).expect("a field is not zero")
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::nalgebra::Matrix3;

    use super::robot;

    /// Half the trace less the tensor is the second moment of the body's mass, which has no negative
    /// eigenvalue.
    #[test]
    fn bodies_are_such_that_can_be() {
        let mut seed = 1_u64;
        for _ in 0..2_000 {
            let bytes: Vec<u8> = core::iter::repeat_with(|| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (seed >> 56) as u8
            })
            .take(300)
            .collect();
            let (robot, fields) = robot(&bytes).expect("more bytes than cells");
            for row in &robot.rows {
                let value = |x: &dynamics_symbolic::robot::Value| x.to_f64(&fields);
                assert!(value(&row.mass) >= 0.0 && value(&row.motor_inertia) >= 0.0);
                let [xx, yy, zz, xy, yz, xz] = row.inertia.each_ref().map(value);
                let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
                let moment = Matrix3::from_diagonal_element(tensor.trace() / 2.0) - tensor;
                let least = moment.symmetric_eigenvalues().min();
                assert!(least >= -1e-12 * tensor.amax(), "{least:e} of {tensor}");
            }
        }
    }
}
