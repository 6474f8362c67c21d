//! The matrices that a function of CasADi and those of its derivatives give.

use super::derivatives::second_derivative;
use super::interface::{Input, Output, Size};
use super::pose::OfPose;
use super::solved::Solved;
use super::{FIELDS, Of, name};
use crate::arguments::argument_sizes;
use crate::body::Body;
use dynamics_symbolic::function::{Argument, Shape, Sizes};
use dynamics_symbolic::robot::Robot;

/// The inputs and outputs of a function.
pub(super) struct Blocks {
    inputs: Vec<Variable>,
    outputs: Vec<(String, Size)>,
    /// The degrees of freedom.
    freedoms: usize,
    /// Derivatives by the pose of a base that moves, of a single function.
    of_pose: Option<OfPose>,
}

/// An input by which is differentiated.
struct Variable {
    name: String,
    entries: usize,
    /// The argument, if derivatives by it are known: they are not by symbolic parameters.
    argument: Option<Argument>,
}

impl Blocks {
    pub(super) fn new(robot: &Robot, (request, proven): Of<'_>, body: &Body<'_>) -> Self {
        let sizes = proven.sizes(request, robot.freedoms());
        let fields = (!robot.fields.is_empty()).then(|| Variable {
            name: FIELDS.to_owned(),
            entries: robot.fields.len(),
            argument: None,
        });
        let arguments = argument_sizes(request, sizes).map(|(argument, entries)| Variable {
            name: argument.name().to_owned(),
            entries,
            argument: Some(argument),
        });
        let outputs = request.parts().iter().flat_map(|part| {
            let named = if request.is_tuple() {
                robot.name_of(*part)
            } else {
                request.result().to_owned()
            };
            matrices(name(&named), part.function.shape(), sizes)
        });
        Blocks {
            inputs: fields.into_iter().chain(arguments).collect(),
            outputs: outputs.collect(),
            freedoms: robot.freedoms().all(),
            of_pose: request
                .function()
                .map(|function| OfPose::new(robot, function, body)),
        }
    }

    pub(super) fn inputs(&self) -> Vec<Input> {
        let inputs = self.inputs.iter();
        let inputs = inputs.map(|input| Input {
            name: input.name.clone(),
            size: (input.entries, 1),
            is_empty: false,
        });
        inputs.collect()
    }

    /// The same, and a place for each output.
    pub(super) fn inputs_of_first(&self) -> Vec<Input> {
        let mut inputs = self.inputs();
        let outputs = self.outputs.iter();
        inputs.extend(outputs.map(|(name, size)| place_of(name, *size)));
        inputs
    }

    /// The same, and a place for each block of first derivatives.
    pub(super) fn inputs_of_second(&self) -> Vec<Input> {
        let mut inputs = self.inputs_of_first();
        let blocks = self.blocks();
        inputs.extend(blocks.map(|(_, input, name, size)| {
            let columns = input.entries;
            place_of(&name, (size.0 * size.1, columns))
        }));
        inputs
    }

    /// The inputs of first derivatives, and a weight for each entry of an output.
    pub(super) fn inputs_of_adjoint(&self) -> Vec<Input> {
        let mut inputs = self.inputs_of_first();
        let weights = self.outputs.iter().map(|(name, size)| Input {
            name: weights_of(name),
            size: *size,
            is_empty: false,
        });
        inputs.extend(weights);
        inputs
    }

    /// The same, and a place for each of its outputs.
    pub(super) fn inputs_of_derived_adjoint(&self) -> Vec<Input> {
        let mut inputs = self.inputs_of_adjoint();
        let outputs = self.inputs.iter();
        inputs.extend(outputs.map(|of| place_of(&weights_of(&of.name), (of.entries, 1))));
        inputs
    }

    /// A block of first derivatives for each output and input: the place of the output, the input, the name, and the
    /// size of the output.
    fn blocks(&self) -> impl Iterator<Item = (usize, &Variable, String, Size)> {
        let outputs = self.outputs.iter().enumerate();
        outputs.flat_map(|(place, (output, size))| {
            let inputs = self.inputs.iter();
            inputs.map(move |input| (place, input, format!("jac_{output}_{}", input.name), *size))
        })
    }

    /// The outputs of the function.
    pub(super) fn outputs(&self, values: &[Option<String>]) -> Vec<Output> {
        let mut start = 0;
        let outputs = self.outputs.iter().map(|(name, (rows, columns))| {
            let value = |row: usize, column: usize| values[start + row * columns + column].clone();
            let output = Output::new(name.clone(), (*rows, *columns), value);
            start += rows * columns;
            output
        });
        outputs.collect()
    }

    /// The blocks of first derivatives. `values` has a matrix for each argument but the pose of a base, whose columns are
    /// degrees of freedom.
    pub(super) fn first(&self, values: &[Option<String>]) -> Vec<Output> {
        let mut start = 0;
        let blocks = self.blocks().map(|(_, input, name, (rows, columns))| {
            let size = (rows * columns, input.entries);
            match input.argument {
                None => return Output::unknown(name, size),
                Some(Argument::Base) => {
                    return Output::new(name, size, |row, column| {
                        self.of_pose.as_ref()?.first(values, row, column)
                    });
                }
                Some(_) => {}
            }
            let value = |row: usize, column: usize| {
                let freedom = self.freedom(input, column);
                values[start + row * self.freedoms + freedom].clone()
            };
            let block = Output::new(name, size, value);
            start += size.0 * self.freedoms;
            block
        });
        blocks.collect()
    }

    /// The blocks of second derivatives. `values` has the arrays of `second_derivative`.
    pub(super) fn second(&self, values: &[Option<String>]) -> Vec<Output> {
        let mut outputs = Vec::new();
        let matrix = self.freedoms * self.freedoms;
        for (_, one, block, (rows, columns)) in self.blocks() {
            let forces = rows * columns;
            let height = forces * one.entries;
            for other in &self.inputs {
                let name = format!("jac_{block}_{}", other.name);
                let size = (height, other.entries);
                let (Some(first), Some(second)) = (one.argument, other.argument) else {
                    outputs.push(Output::unknown(name, size));
                    continue;
                };
                outputs.push(Output::new(name, size, |row, column| {
                    let (force, row) = (row % forces, row / forces);
                    let of_pose = |number: usize, position: usize| {
                        let of_pose = self.of_pose.as_ref()?;
                        of_pose.second(values, force, number, position)
                    };
                    match (first, second) {
                        (Argument::Base, Argument::Position) => {
                            return of_pose(row, self.freedom(other, column));
                        }
                        (Argument::Position, Argument::Base) => {
                            return of_pose(column, self.freedom(one, row));
                        }
                        (Argument::Base, _) | (_, Argument::Base) => return None,
                        _ => {}
                    }
                    let (of_one, of_other) = (self.freedom(one, row), self.freedom(other, column));
                    let place = second_derivative((first, of_one), (second, of_other));
                    let (array, row, column) = place?;
                    let start = (array * self.freedoms + force) * matrix;
                    values[start + row * self.freedoms + column].clone()
                }));
            }
            // Nothing depends on the place of an output.
            for (output, (rows, columns)) in &self.outputs {
                let name = format!("jac_{block}_out_{output}");
                outputs.push(Output::new(name, (height, rows * columns), |_, _| None));
            }
        }
        outputs
    }

    /// The derivatives by each input, weighted: adj_x = (d tau / d x)^T adj_tau. CasADi expects them to have the pattern of the
    /// input, zeros too.
    pub(super) fn adjoint(&self, first: &[Output]) -> Vec<Output> {
        let inputs = self.inputs.iter().zip(first);
        let outputs = inputs.map(|(input, block)| {
            let (name, size) = (weights_of(&input.name), (input.entries, 1));
            if block.is_unknown() {
                return Output::unknown(name, size);
            }
            let weighted = self.weighted(block);
            Output::new(name, size, |entry, _| {
                weighted(entry).or_else(|| Some("0.0".to_owned()))
            })
        });
        outputs.collect()
    }

    /// The derivatives of these by each input y, the sums of adj_tau_i d^2 tau_i / (d x d y), by the places of outputs, and by the
    /// weights. `second` has the blocks of second derivatives.
    pub(super) fn derived_adjoint(&self, first: &[Output], second: &[Output]) -> Vec<Output> {
        let weighted: Vec<_> = second.iter().map(|block| self.weighted(block)).collect();
        let blocks = self.inputs.len() + self.outputs.len();
        self.derived_adjoint_of(first, |(one, other), (row, column)| {
            weighted[one * blocks + other](column * self.inputs[one].entries + row)
        })
    }

    /// The same of accelerations that solve the equation of inverse dynamics, and the statements behind which they stand.
    /// `second` has the values of its second derivatives.
    pub(super) fn solved(
        &self,
        first: &[Output],
        second: &[Option<String>],
    ) -> (Vec<String>, Vec<Output>) {
        let blocks = self.inputs.iter().zip(first);
        let blocks = blocks.filter_map(|(input, block)| {
            let (argument, start) = self.of_freedom(input, 0)?;
            Some((argument, start, block.places()))
        });
        let solved = Solved {
            freedoms: self.freedoms,
            first: blocks.collect(),
            second,
        };
        let outputs = self.derived_adjoint_of(first, |(one, other), (row, column)| {
            let one = self.of_freedom(&self.inputs[one], row)?;
            solved.second(one, self.of_freedom(&self.inputs[other], column)?)
        });
        let (name, _) = &self.outputs[0];
        (solved.statements(&weights_of(name)), outputs)
    }

    /// The derivatives of the reverse mode of which `second` gives an entry: that of two inputs, and of row and column.
    fn derived_adjoint_of(
        &self,
        first: &[Output],
        second: impl Fn((usize, usize), (usize, usize)) -> Option<String>,
    ) -> Vec<Output> {
        let mut outputs = Vec::new();
        for (one, (input, block)) in self.inputs.iter().zip(first).enumerate() {
            let derivative = |by: &str| format!("jac_{}_{by}", weights_of(&input.name));
            let height = input.entries;
            for (place, other) in self.inputs.iter().enumerate() {
                let (name, size) = (derivative(&other.name), (height, other.entries));
                outputs.push(if input.argument.and(other.argument).is_none() {
                    Output::unknown(name, size)
                } else {
                    let entry = |row, column| second((one, place), (row, column));
                    Output::new(name, size, entry)
                });
            }
            let places = block.places();
            for (output, (rows, columns)) in &self.outputs {
                let size = (height, rows * columns);
                outputs.push(Output::new(
                    derivative(&format!("out_{output}")),
                    size,
                    |_, _| None,
                ));
                let name = derivative(&weights_of(output));
                outputs.push(if block.is_unknown() {
                    Output::unknown(name, size)
                } else {
                    Output::new(name, size, |row, column| {
                        places[row * rows + column].clone()
                    })
                });
            }
        }
        outputs
    }

    /// The sums of products of weights and derivatives, each of so many that follow one another in a block.
    fn weighted(&self, block: &Output) -> impl Fn(usize) -> Option<String> {
        let (name, (forces, _)) = &self.outputs[0];
        let (weights, forces, places) = (weights_of(name), *forces, block.places());
        move |sum| {
            let terms = places[sum * forces..][..forces].iter().enumerate();
            let terms = terms.filter_map(|(force, place)| {
                let place = place.as_ref()?;
                Some(format!("{place} * {weights}[{force}]"))
            });
            let terms: Vec<_> = terms.collect();
            (!terms.is_empty()).then(|| terms.join(" + "))
        }
    }

    /// The degree of freedom of an entry: positions are those of the joints alone.
    fn freedom(&self, input: &Variable, entry: usize) -> usize {
        self.freedoms - input.entries + entry
    }

    /// The argument and the degree of freedom of an entry, if it belongs to one: the pose of a base does not.
    fn of_freedom(&self, input: &Variable, entry: usize) -> Option<(Argument, usize)> {
        let argument = input.argument.filter(|one| *one != Argument::Base)?;
        Some((argument, self.freedom(input, entry)))
    }
}

/// The name of the weights of an output, and of the weighted derivatives by an input.
fn weights_of(name: &str) -> String {
    format!("adj_{name}")
}

/// The input in place of an output, which is never read.
fn place_of(output: &str, size: Size) -> Input {
    Input {
        name: format!("out_{output}"),
        size,
        is_empty: true,
    }
}

/// The matrices of a value in order, those of lists by numbers.
fn matrices(name: String, shape: &Shape, sizes: Sizes) -> Vec<(String, Size)> {
    match shape {
        Shape::Number => vec![(name, (1, 1))],
        Shape::Matrix(rows, columns) => vec![(name, (rows.of(sizes), columns.of(sizes)))],
        Shape::Each(count, one) => {
            let all = 1..=count.of(sizes);
            all.flat_map(|number| matrices(format!("{name}_{number}"), one, sizes))
                .collect()
        }
        Shape::Tuple(parts) => {
            let parts = parts.iter();
            parts
                .flat_map(|(name, part)| matrices((*name).to_owned(), part, sizes))
                .collect()
        }
        // Never written: it is no program over numbers.
        Shape::Series => Vec::new(),
    }
}
