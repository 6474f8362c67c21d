//! Values as tables.

use dynamics_evaluation::Value;
use dynamics_runtime::nalgebra::{DMatrix, Matrix3, Rotation3};
use dynamics_symbolic::function::{Shape, Size};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use super::labels::{Labels, units};
use crate::columns::{aligned, significant};
use crate::state::State;

/// How values are printed.
pub(super) struct Tables<'a> {
    pub(super) labels: &'a Labels,
    /// Significant digits.
    pub(super) digits: usize,
}

/// The state, a row for each degree of freedom, and where a base that moves is.
pub(super) fn state_table(robot: &Robot, state: &State, tables: &Tables) -> String {
    let joints = match robot.freedoms().joints {
        1 => "1 joint that moves".to_owned(),
        joints => format!("{joints} joints that move"),
    };
    let mut text = format!("{}: {joints}\n\n", robot.name);
    if let Some(base) = &state.base {
        let place = tables.place(&base.rotation, base.position.as_slice());
        text.push_str(&format!("base at {place}\n\n"));
    }
    let of_base = robot.freedoms().base;
    let mut rows = vec![["joint", "q", "qd", "qdd", "tau"].map(str::to_owned)];
    let names = tables.labels.freedoms().iter().zip(units(robot));
    for (k, (name, units)) in names.enumerate() {
        let position = k.checked_sub(of_base).map(|joint| state.q[joint]);
        let others = [state.qd[k], state.qdd[k], state.tau[k]].map(Some);
        let mut cells = [position].into_iter().chain(others).zip(units);
        let mut cell = || match cells.next() {
            Some((Some(x), unit)) => format!("{} {unit}", tables.number(x)),
            _ => String::new(),
        };
        rows.push([name.clone(), cell(), cell(), cell(), cell()]);
    }
    let rows: Vec<Vec<String>> = rows.into_iter().map(Vec::from).collect();
    text + &aligned(&rows, true).join("\n") + "\n"
}

impl Tables<'_> {
    /// The value of a function, or those of several behind their names.
    pub(super) fn request_lines(
        &self,
        robot: &Robot,
        request: &Request,
        value: &Value,
    ) -> Vec<String> {
        let parts = request.parts();
        if let (true, Value::Tuple(values)) = (request.is_tuple(), value) {
            let parts = parts.iter().zip(values);
            let parts = parts.flat_map(|(part, value)| {
                let lines = self.function_lines(part.function, value);
                [robot.name_of(*part)].into_iter().chain(lines)
            });
            return parts.collect();
        }
        self.function_lines(parts[0].function, value)
    }

    fn function_lines(&self, function: Function, value: &Value) -> Vec<String> {
        let mut lines = self.value(value, function.shape());
        if let (Function::ForwardKinematics, Value::Matrix(pose)) = (function, value) {
            let rotation: Matrix3<f64> = pose.fixed_view::<3, 3>(0, 0).into();
            let position = [pose[(0, 3)], pose[(1, 3)], pose[(2, 3)]];
            lines.push(self.place(&rotation, &position));
        }
        lines
    }

    /// A position and the roll, pitch and yaw of a rotation.
    fn place(&self, rotation: &Matrix3<f64>, position: &[f64]) -> String {
        let (roll, pitch, yaw) = Rotation3::from_matrix_unchecked(*rotation).euler_angles();
        let list = |numbers: &[f64]| {
            let numbers = numbers.iter().map(|x| self.number(*x));
            numbers.collect::<Vec<_>>().join(", ")
        };
        format!(
            "xyz [{}] m  rpy [{}] rad",
            list(position),
            list(&[roll, pitch, yaw])
        )
    }

    fn value(&self, value: &Value, shape: &Shape) -> Vec<String> {
        match (value, shape) {
            (Value::Number(x), _) => vec![self.number(*x)],
            (Value::Matrix(matrix), Shape::Matrix(rows, columns)) => {
                self.matrix(matrix, *rows, *columns)
            }
            (Value::Each(values), Shape::Each(count, one)) => {
                let names = self.labels.names(*count, values.len());
                let numbers = (1..=values.len()).map(|k| k.to_string());
                let names = names.unwrap_or_else(|| numbers.collect());
                let values = names.into_iter().zip(values);
                let lines = values.flat_map(|(name, value)| {
                    [format!("{name}:")]
                        .into_iter()
                        .chain(self.value(value, one))
                });
                lines.collect()
            }
            (Value::Tuple(values), Shape::Tuple(shapes)) => {
                let values = values.iter().zip(*shapes);
                let lines = values.flat_map(|(value, (name, shape))| {
                    let title = format!("{name}:");
                    [title].into_iter().chain(self.value(value, shape))
                });
                lines.collect()
            }
            _ => Vec::new(),
        }
    }

    /// A matrix with the names of its rows and columns, where they have some.
    fn matrix(&self, matrix: &DMatrix<f64>, rows: Size, columns: Size) -> Vec<String> {
        let of_rows = self.labels.names(rows, matrix.nrows());
        let of_columns = self.labels.names(columns, matrix.ncols());
        let mut table = Vec::new();
        if let Some(names) = of_columns {
            let corner = of_rows.iter().map(|_| String::new());
            table.push(corner.chain(names).collect());
        }
        for (i, row) in matrix.row_iter().enumerate() {
            let name = of_rows.as_ref().map(|names| names[i].clone());
            let numbers = row.iter().map(|x| self.number(*x)).collect::<Vec<_>>();
            table.push(name.into_iter().chain(numbers).collect());
        }
        aligned(&table, of_rows.is_some())
    }

    /// A number with so many significant digits.
    fn number(&self, x: f64) -> String {
        significant(x, self.digits)
    }
}
