//! A robot from any bytes.

use arbitrary::{Result, Unstructured};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};

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
    let robot = Robot {
        name: "random".to_owned(),
        fields: (0..cells.fields.len()).map(|i| format!("p{i}")).collect(),
        convention,
        gravity,
        rows,
        neglected: None,
    };
    Ok((robot, cells.fields))
}

impl Cells<'_> {
    fn row(&mut self, i: usize) -> Result<Row> {
        let joint_type = match self.bytes.arbitrary()? {
            true => JointType::Revolute,
            false => JointType::Prismatic,
        };
        Ok(Row {
            name: format!("joint{i}"),
            joint_type,
            a: self.cell()?,
            alpha: self.angle()?,
            d: self.cell()?,
            theta: self.angle()?,
            mass: self.positive()?,
            com: self.cells()?,
            inertia: self.cells()?,
            motor_inertia: self.positive()?,
            gear_ratio: self.cell()?,
            viscous: self.positive()?,
            coulomb: self.positive()?,
            limits: None,
            locked: None,
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

    fn positive(&mut self) -> Result<Value> {
        match self.cell()? {
            Value::Rational(x) if x < Rational::ZERO => Ok(Value::Rational(-x)),
            value => Ok(value),
        }
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
