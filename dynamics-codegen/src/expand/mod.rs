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
use dynamics_symbolic::{
    Function, Method, Request, base_parameter_constants, stub, stub_of_function, stub_of_trait,
};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::call::Structure;
use crate::description::{Asked, Entry, Row};
use crate::validate::Model;
use crate::validate::functions::{RESERVED, fused};
use evaluate::Evaluation;
use target::Target;

/// The struct, its methods and the traits of the runtime.
pub(crate) fn robot(
    structure: &Structure,
    model: &Model,
    methods: &[Method],
    path: &TokenStream,
) -> TokenStream {
    let target = Target::new(structure, model.robot.dof(), path);
    let functions: Vec<Function> = methods
        .iter()
        .filter_map(|m| m.request.function())
        .collect();
    let requests: Vec<Request> = methods.iter().map(|m| m.request.clone()).collect();
    let names: Vec<String> = model.robot.joints().map(|row| row.name.clone()).collect();
    let table = table::table(structure, &model.robot, path);
    let evaluation = evaluate::evaluation(&target, &requests);
    let item = structure::as_written(structure, &scene::lines(model));
    let bodies = methods.iter().map(|method| &method.tokens);
    let base_parameters = base_parameter_constants(&requests, Some(&model.robot));
    let operations = operations(methods, path);
    let formulas = formulas(methods, path);
    let limits: Vec<TokenStream> = model.robot.joints().map(table::limits).collect();
    let constants = Constants {
        names: &names,
        limits: &limits,
        operations: &operations,
        formulas: &formulas,
        base_parameters: &base_parameters,
    };
    let inherent = target.inherent(&constants, &table, bodies);
    let provided = methods.iter().filter_map(|method| {
        let (function, mut item) = (method.request.function()?, method.provided.clone()?);
        if function == Function::ForwardDynamics {
            item.extend(traits::momenta(&target, &functions));
        }
        Some((function, item))
    });
    let mut provided = traits::provided(&target, provided);
    let items = methods
        .iter()
        .map(|method| (&method.request, method.function.clone()));
    provided.extend(traits::functions(&target, items));
    provided.extend(traits::fields(&target, &model.robot.fields));
    provided.extend(batch::fused(&target, &requests));
    let angles = angles(model.robot.dof(), methods);
    let traits = traits::traits(&target, &functions, &angles, &table, &evaluation);
    let test = model
        .tests
        .then(|| test::agrees_with_newton_euler(&target, structure));
    let implementations = quote!(#inherent #provided #traits);
    let implementations = match structure.is_alone {
        true => implementations,
        false => names::apart(&implementations),
    };
    quote!(#item #implementations #test)
}

/// After an error: the same items with methods that have no body, for the type check
/// of the code around the call.
pub(crate) fn stubs(structure: &Structure, entries: &[Entry], path: &TokenStream) -> TokenStream {
    let names = joint_names(entries);
    let target = Target::new(structure, names.len(), path);
    let requests = requests_to_stub(entries);
    let functions: Vec<Function> = requests.iter().filter_map(Request::function).collect();
    let unimplemented = quote!(::core::unimplemented!());
    let item = structure::repaired(structure);
    let bodies = requests.iter().map(|r| stub(r, target.dof, path));
    let base_parameters = base_parameter_constants(&requests, None);
    let constants = Constants {
        names: &names,
        limits: &vec![quote!(::core::option::Option::None); names.len()],
        operations: &[],
        formulas: &[],
        base_parameters: &base_parameters,
    };
    let inherent = target.inherent(&constants, &unimplemented, bodies);
    let provided = functions.iter().filter_map(|f| {
        let item = stub_of_trait(*f, target.dof, path)?;
        Some((*f, item))
    });
    let mut provided = traits::provided(&target, provided);
    let items = requests.iter().enumerate();
    let items = items.map(|(i, r)| (r, stub_of_function(r, i, target.dof, path)));
    provided.extend(traits::functions(&target, items));
    provided.extend(traits::fields_by(&target, &unimplemented));
    provided.extend(batch::fused(&target, &requests));
    let evaluation = Evaluation {
        functions: unimplemented.clone(),
        parts: None,
    };
    let traits = traits::traits(&target, &functions, &[], &unimplemented, &evaluation);
    let implementations = names::apart(&quote!(#inherent #provided #traits));
    quote!(#item #implementations)
}

/// Names of the joints; none where an error left their number unknown.
fn joint_names(entries: &[Entry]) -> Vec<String> {
    let joints = entries.iter().find_map(|entry| match entry {
        Entry::Joints(_, joints) => joints.as_ref(),
        _ => None,
    });
    let name = |row: &Row| {
        row.name
            .as_ref()
            .map_or(String::new(), |name| name.plain().to_owned())
    };
    let names = match joints {
        Some(joints) if joints.complete => joints.rows.iter().map(name).collect(),
        _ => Vec::new(),
    };
    without_others(names, entries).unwrap_or_default()
}

/// The names without those of joints that are locked or follow others, or `None` where it is not known
/// which these are.
fn without_others(mut names: Vec<String>, entries: &[Entry]) -> Option<Vec<String>> {
    let mut others = BTreeSet::new();
    for entry in entries {
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

/// The methods that the user's code may call: those asked for, all functions where that is not
/// known, the default set where nothing was asked for.
fn requests_to_stub(entries: &[Entry]) -> Vec<Request> {
    let asked = entries.iter().find_map(|entry| match entry {
        Entry::Functions(functions) => Some(functions),
        _ => None,
    });
    let default_set = || Function::default_set(true).into_iter().map(Request::One);
    let requests: Vec<Request> = match asked {
        None => default_set().collect(),
        Some(None) => Function::ALL.map(Request::One).to_vec(),
        Some(Some(asked)) => {
            let requests = asked.iter().map(|asked| match asked {
                Asked::Default(_) => default_set().collect(),
                Asked::One(function, _) => vec![Request::One(*function)],
                Asked::Fused(name, parts) => vec![fused(name, parts)],
                // It may be any of them.
                Asked::Unreadable => Function::ALL.map(Request::One).to_vec(),
            });
            requests.flatten().collect()
        }
    };
    // What has the name of something else has been reported.
    let mut names = BTreeSet::new();
    let is_method = |request: &Request| {
        let name = request.name();
        !RESERVED.contains(&name) && names.insert(name.to_owned())
    };
    requests.into_iter().filter(is_method).collect()
}

/// Of each joint, whether the sine and cosine of its position are read by one of the methods that can
/// also be called with sines that were evaluated before: those of the runtime's traits of single functions. One of
/// these traits, `ForwardDynamics`, may be by articulated bodies.
fn angles(dof: usize, methods: &[Method]) -> Vec<bool> {
    let by_bodies = Some(Function::ForwardDynamicsAba);
    let is_told =
        |method: &&Method| method.provided.is_some() || method.request.function() == by_bodies;
    let told = methods.iter().filter(is_told);
    let joints: Vec<usize> = told.flat_map(|method| method.angles.clone()).collect();
    (0..dof).map(|joint| joints.contains(&joint)).collect()
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

/// The entries of `formulas`, of functions that are methods of their own.
fn formulas(methods: &[Method], path: &TokenStream) -> Vec<TokenStream> {
    let of_method = |method: &Method| {
        let function = method.request.function()?.name();
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
        Some(method.equations.iter().map(entry).collect::<Vec<_>>())
    };
    methods.iter().filter_map(of_method).flatten().collect()
}

/// What the constants of a struct say.
struct Constants<'a> {
    /// Names of the joints.
    names: &'a [String],
    /// Their ranges.
    limits: &'a [TokenStream],
    /// Names of methods, with their operations.
    operations: &'a [TokenStream],
    /// Entries of the method `formulas`.
    formulas: &'a [TokenStream],
    /// The constants about the base parameters, where there are any.
    base_parameters: &'a TokenStream,
}

impl Target<'_> {
    /// The inherent impl. `table` is the body of the method of that name.
    fn inherent(
        &self,
        constants: &Constants,
        table: &TokenStream,
        methods: impl Iterator<Item = impl ToTokens>,
    ) -> TokenStream {
        let Constants {
            names,
            limits,
            operations,
            formulas,
            base_parameters,
        } = constants;
        let Target {
            name, cfgs, path, ..
        } = self;
        let n = self.n();
        let count = Literal::usize_unsuffixed(operations.len());
        quote! {
            #cfgs
            #[allow(dead_code, deprecated, unused_variables, unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
            impl #name {
                /// Number of joints.
                pub const DOF: usize = #n;

                /// Names of the joints, from the base outwards.
                pub const JOINT_NAMES: [&'static str; #n] = [#(#names),*];

                /// Ranges of the joints' positions, lower ends first, rad or m, where the table has them.
                pub const JOINT_LIMITS: [::core::option::Option<[f64; 2]>; #n] = [#(#limits),*];

                /// Operations of each generated method, by the method's name.
                pub const OPERATIONS: [(&'static str, #path::Operations); #count] =
                    [#(#operations),*];

                #base_parameters

                /// The table in numbers, as it was written: what the numeric checks read.
                pub fn table(&self) -> #path::Table<#n> {
                    #table
                }

                /// What the generated methods compute, value by value, where that is short enough to
                /// read: formulas of at most 24 terms of arms of up to three joints.
                pub fn formulas() -> &'static [#path::Formula] {
                    &[#(#formulas),*]
                }

                #(#methods)*
            }
        }
    }
}
