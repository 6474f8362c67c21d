//! A model to the items of its struct. Nothing in here can fail.

mod batch;
mod evaluate;
pub(crate) mod names;
mod scene;
mod structure;
mod table;
mod target;
mod test;
mod traits;

use std::collections::BTreeSet;

use dynamics_symbolic::formula::Equation;
use dynamics_symbolic::function::Freedoms;
use dynamics_symbolic::robot::{Base, Robot};
use dynamics_symbolic::{
    Function, Method, Request, base_parameter_constants, stub, stub_of_function, stub_of_inverse,
    stub_of_trait,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::call::Structure;
use crate::description::{Asked, Entry, Name, Table};
use crate::validate::Model;
use crate::validate::functions::{RESERVED, fused, one};
use evaluate::Evaluation;
use target::Target;

/// The struct, its methods and the traits of the runtime.
pub(crate) fn robot(
    structure: &Structure,
    model: &Model,
    methods: &[Method],
    inverses: &[TokenStream],
    path: &TokenStream,
) -> TokenStream {
    let robot = &model.robot;
    let target = Target::new(structure, robot.freedoms(), path);
    let requests: Vec<Request> = methods.iter().map(|m| m.request.clone()).collect();
    let functions: Vec<Function> = requests.iter().filter_map(Request::function).collect();
    let provided = methods.iter().filter_map(|method| {
        let (function, mut item) = (method.request.function()?, method.provided.clone()?);
        if function == Function::ForwardDynamics {
            item.extend(traits::momenta(&target, &functions));
        }
        Some((function, item))
    });
    let items = Items {
        names: robot.joints().map(|row| row.name.clone()).collect(),
        limits: robot.joints().map(table::limits).collect(),
        greatest: table::greatest(robot),
        operations: operations(methods, path),
        rounding: methods.iter().map(rounding).collect(),
        formulas: formulas(methods, path),
        base_parameters: base_parameter_constants(&requests, Some(robot)),
        table: table::table(structure, robot, path),
        bodies: {
            let methods = methods.iter().map(|method| &method.tokens);
            methods.chain(inverses).cloned().collect()
        },
        provided: provided.collect(),
        functions: methods
            .iter()
            .map(|method| method.function.clone())
            .collect(),
        field: traits::field_by_index(&robot.fields),
        angles: angles(robot, methods),
        evaluation: evaluate::evaluation(&target, robot, &requests),
    };
    let implementations = items.implementations(&target, &requests);
    let implementations = if structure.is_alone {
        implementations
    } else {
        names::apart(&implementations)
    };
    let item = structure::as_written(structure, &scene::lines(model));
    let tests = model.tests;
    let test = tests.then(|| test::agrees_with_newton_euler(&target, structure));
    quote!(#item #implementations #test)
}

/// After an error: the same items with methods that have no body, for the type check
/// of the code around the call.
pub(crate) fn stubs(structure: &Structure, table: &Table, path: &TokenStream) -> TokenStream {
    let names = joint_names(table);
    let is_known = names.is_some();
    let names = names.unwrap_or_default();
    let joints = names.len();
    let base_moves = table.floating().is_some();
    let base = if base_moves { Base::FREEDOMS } else { 0 };
    let target = Target {
        is_known: is_known && base + joints > 0,
        ..Target::new(structure, Freedoms { base, joints }, path)
    };
    let mut requests = requests_to_stub(table);
    if base_moves {
        requests = requests.into_iter().map(Request::on_moving_base).collect();
    }
    let unimplemented = quote!(::core::unimplemented!());
    let provided = requests.iter().filter_map(|request| {
        let function = request.function().filter(|_| !base_moves)?;
        Some((
            function,
            stub_of_trait(function, target.freedoms.joints, path)?,
        ))
    });
    let functions = requests.iter().enumerate();
    let items = Items {
        limits: vec![quote!(::core::option::Option::None); names.len()],
        greatest: [(); 2].map(|()| vec![quote!(::core::option::Option::None); names.len()]),
        names,
        operations: Vec::new(),
        rounding: Vec::new(),
        formulas: Vec::new(),
        base_parameters: base_parameter_constants(&requests, None),
        table: unimplemented.clone(),
        bodies: {
            let methods = requests.iter().map(|r| stub(r, target.stubbed(), path));
            methods.chain(stubs_of_inverses(table, &target)).collect()
        },
        provided: provided.collect(),
        functions: functions
            .map(|(i, r)| stub_of_function(r, i, target.stubbed(), path))
            .collect(),
        field: Some(unimplemented.clone()),
        angles: Vec::new(),
        evaluation: Evaluation {
            functions: unimplemented,
            parts: None,
        },
    };
    let item = structure::repaired(structure);
    let implementations = names::apart(&items.implementations(&target, &requests));
    quote!(#item #implementations)
}

/// Names of the joints that move by themselves; `None` where an error left their number unknown.
fn joint_names(table: &Table) -> Option<Vec<String>> {
    let joints = table.joints().filter(|joints| joints.complete)?;
    let mut names: Vec<_> = joints
        .rows
        .iter()
        .map(|row| row.word().to_owned())
        .collect();
    // Joints that are locked or follow others are none.
    let mut others = BTreeSet::new();
    for entry in &table.entries {
        match entry {
            Entry::Lock(joints) | Entry::Couple(joints) => {
                others.extend(joints.as_ref()?.iter().map(|joint| joint.name.plain()));
            }
            _ => {}
        }
    }
    for other in others {
        let index = names.iter().position(|name| name == other)?;
        names.remove(index);
    }
    Some(names)
}

/// The methods that the user's code may call: those requested, or all functions where that is not known. Where nothing
/// was requested it is the default set.
fn requests_to_stub(table: &Table) -> Vec<Request> {
    let default_set = || Function::default_set(true).into_iter().map(Request::from);
    let requests: Vec<Request> = match table.functions() {
        None => default_set().collect(),
        Some(None) => Function::ALL.map(Request::from).to_vec(),
        Some(Some(asked)) => {
            let requests = asked.iter().map(|asked| match asked {
                Asked::Default(_) => default_set().collect(),
                Asked::One(wanted) if wanted.is_inverse => Vec::new(),
                Asked::One(wanted) => vec![one(wanted, &[])],
                Asked::Fused(name, parts) => vec![fused(name, parts, &[])],
                // It may be any of them.
                Asked::Unreadable => Function::ALL.map(Request::from).to_vec(),
            });
            requests.flatten().collect()
        }
    };
    // A method with the name of something else has been reported.
    let mut names = BTreeSet::new();
    let is_method = |request: &Request| {
        let name = request.name();
        !RESERVED.contains(&name) && names.insert(name.to_owned())
    };
    requests.into_iter().filter(is_method).collect()
}

/// Inverse kinematics that are requested, each once.
fn stubs_of_inverses(table: &Table, target: &Target) -> Vec<TokenStream> {
    let asked = table.functions().flatten().unwrap_or_default();
    let frames = asked.iter().filter_map(|asked| match asked {
        Asked::One(wanted) if wanted.is_inverse => Some(wanted.frame.as_ref().map(Name::plain)),
        _ => None,
    });
    let frames: BTreeSet<Option<&str>> = frames.collect();
    let stub = |frame| stub_of_inverse(frame, target.freedoms.joints, target.path);
    frames.into_iter().map(stub).collect()
}

/// Whether a method of the runtime's traits of single functions reads the sine and cosine of each joint's position. Such
/// a method can be called with sines that were evaluated before. One of these traits, `ForwardDynamics`, may be by
/// articulated bodies.
fn angles(robot: &Robot, methods: &[Method]) -> Vec<bool> {
    let by_bodies = Some(Function::ForwardDynamicsAba);
    let reads_sines =
        |method: &&Method| method.provided.is_some() || method.request.function() == by_bodies;
    let reading = methods.iter().filter(reads_sines);
    let joints: Vec<usize> = reading.flat_map(|method| method.angles.clone()).collect();
    let Freedoms { base, joints: n } = robot.freedoms();
    (base..base + n)
        .map(|joint| joints.contains(&joint))
        .collect()
}

/// An entry of the constant `ROUNDING`.
fn rounding(method: &Method) -> TokenStream {
    let name = method.request.name();
    let [double, single] = method.rounding.map(|bound| match bound.is_finite() {
        true => {
            let bound = Literal::f64_unsuffixed(bound);
            quote!(#bound)
        }
        false => quote!(f64::INFINITY),
    });
    quote!((#name, #double, #single))
}

/// The entries of the constant `OPERATIONS`.
fn operations(methods: &[Method], path: &TokenStream) -> Vec<TokenStream> {
    let entry = |method: &Method| {
        let name = method.request.name();
        let [multiplications, additions, divisions, sin_cos, exponentials] = [
            method.operations.multiplications,
            method.operations.additions,
            method.operations.divisions,
            method.operations.sin_cos,
            method.operations.exponentials,
        ]
        .map(Literal::u32_unsuffixed);
        quote! {
            (#name, #path::Operations {
                multiplications: #multiplications,
                additions: #additions,
                divisions: #divisions,
                sin_cos: #sin_cos,
                exponentials: #exponentials,
            })
        }
    };
    methods.iter().map(entry).collect()
}

/// The entries of `formulas`, of methods of one function.
fn formulas(methods: &[Method], path: &TokenStream) -> Vec<TokenStream> {
    let of_method = |method: &Method| {
        let function = method.request.name();
        let entry = move |equation: &Equation| {
            let Equation {
                name,
                text,
                latex,
                mathml,
            } = equation;
            quote! {
                #path::Formula {
                    function: #function,
                    value: #name,
                    text: #text,
                    latex: #latex,
                    mathml: #mathml,
                }
            }
        };
        method.equations.iter().map(entry).collect::<Vec<_>>()
    };
    let of_one = methods.iter().filter(|method| !method.request.is_tuple());
    of_one.flat_map(of_method).collect()
}

/// The parts of a struct's implementations.
struct Items {
    /// Names of the joints.
    names: Vec<String>,
    /// Their ranges.
    limits: Vec<TokenStream>,
    /// Their greatest torques, and their greatest velocities.
    greatest: [Vec<TokenStream>; 2],
    /// Names of methods, with their operations.
    operations: Vec<TokenStream>,
    /// The same with the bounds of their rounding errors.
    rounding: Vec<TokenStream>,
    /// Entries of the method `formulas`.
    formulas: Vec<TokenStream>,
    /// The constants about the base parameters, where there are any.
    base_parameters: TokenStream,
    /// The body of the method `table`.
    table: TokenStream,
    /// The methods of the struct.
    bodies: Vec<TokenStream>,
    /// The items of the traits of single functions.
    provided: Vec<(Function, TokenStream)>,
    /// For each method the items of the trait `Function`, unless it has a trait of its own.
    functions: Vec<Option<TokenStream>>,
    /// The value of the field of the number `index`, where there are some.
    field: Option<TokenStream>,
    /// Whether a function of a trait of its own reads the sine of each joint.
    angles: Vec<bool>,
    evaluation: Evaluation,
}

impl Items {
    fn implementations(self, target: &Target, requests: &[Request]) -> TokenStream {
        let functions: Vec<Function> = requests.iter().filter_map(Request::function).collect();
        let inherent = self.inherent(target);
        let traits = traits::traits(
            target,
            &functions,
            &self.angles,
            &self.table,
            &self.evaluation,
        );
        let provided = traits::provided(target, self.provided.into_iter());
        let of_function = traits::functions(target, requests.iter().zip(self.functions));
        let field = self.field.as_ref();
        let fields = field.map(|value| traits::fields(target, value, requests));
        let batches = batch::of_one(target, requests);
        quote!(#inherent #provided #of_function #fields #batches #traits)
    }

    /// The inherent impl.
    fn inherent(&self, target: &Target) -> TokenStream {
        let Items {
            names,
            limits,
            greatest: [torques, velocities],
            operations,
            rounding,
            formulas,
            base_parameters,
            table,
            bodies,
            ..
        } = self;
        let Target {
            name, cfgs, path, ..
        } = target;
        let (n, v) = (target.n(), target.v());
        let counted = if target.freedoms.has_base() {
            " Number of degrees of freedom: six of the base, then the joints."
        } else {
            " Number of joints."
        };
        let count = Literal::usize_unsuffixed(operations.len());
        quote! {
            #cfgs
            #[allow(dead_code, deprecated, unused_variables, unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
            impl #name {
                #[doc = #counted]
                pub const DOF: usize = #v;

                /// Names of the joints, from the base outwards.
                pub const JOINT_NAMES: [&'static str; #n] = [#(#names),*];

                /// Ranges of the joints' positions, lower ends first, rad or m, where the table has them.
                pub const JOINT_LIMITS: [::core::option::Option<[f64; 2]>; #n] = [#(#limits),*];

                /// Greatest torques or forces of the joints in either direction, N m or N, where the table has them.
                pub const TORQUE_LIMITS: [::core::option::Option<f64>; #n] = [#(#torques),*];

                /// Greatest velocities of the joints in either direction, rad/s or m/s, where the table has them.
                pub const VELOCITY_LIMITS: [::core::option::Option<f64>; #n] = [#(#velocities),*];

                /// Operations of each generated method, by the method's name.
                pub const OPERATIONS: [(&'static str, #path::Operations); #count] =
                    [#(#operations),*];

                /// The largest rounding error of each generated method's values in double and in single precision, SI units: proven
                /// for all positions within the limits, all other arguments up to 1, and any rotation of a moving base. Infinite if
                /// there is no bound: without limits, with fields, or if a divisor may vanish.
                pub const ROUNDING: [(&'static str, f64, f64); #count] = [#(#rounding),*];

                #base_parameters

                /// The table in numbers, as it was written: what the numeric checks read.
                pub fn table(&self) -> #path::Table<#n> {
                    #table
                }

                /// The formulas of the generated methods, value by value, where they are short enough to
                /// read: at most 24 terms, of arms of up to three joints.
                pub fn formulas() -> &'static [#path::Formula] {
                    &[#(#formulas),*]
                }

                #(#bodies)*
            }
        }
    }
}
