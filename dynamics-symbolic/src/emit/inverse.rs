//! Inverse kinematics as a method: a loop over the solutions of each step inside that of the step before, with the lines between
//! them that read no later joint.

use super::body::Writer;
use super::inputs::{constants_like, input_name};
use super::names::{ident, number_of_joints, shown, variable};
use crate::function::{Argument, ELBOW_METHODS, elbow_method, inverse_method};
use crate::inverse::{ELBOW, Plan, Rule, Step, Target};
use crate::program::Proven;
use crate::robot::{JointType, Robot, Symbol};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The method for a frame of this name, or for the tip.
pub fn inverse_kinematics(
    robot: &Robot,
    frame: Option<&str>,
    plan: &Plan,
    path: &TokenStream,
) -> TokenStream {
    let proven = plan.proven();
    let method = |searches| Method {
        robot,
        plan,
        writer: Writer::new(robot, &proven),
        stages: plan.stages(),
        path,
        searches,
    };
    let [pose, solutions] = ["pose", "solutions"].map(ident);
    // For each joint whether it turns.
    let joints = robot.joints();
    let turns = joints.map(|row| row.joint_type == JointType::Revolute);
    let reads_rotation = plan.target != Target::Position;
    let joints = plan
        .branches
        .joints
        .iter()
        .map(|joint| Literal::usize_unsuffixed(*joint));
    let names = &plan.branches.names;
    let elbow = (plan.target == Target::PoseAndElbow).then(|| ident("elbow"));
    let is_angle = elbow
        .as_ref()
        .map(|elbow| quote!(.filter(|_| #path::closed_form::Real::is_finite(#elbow))));
    let [nearest, place] = ["nearest_pose", "pose_place"].map(ident);
    let (steps, hidden) = (method(false).body(), hidden_method(frame));
    let search = plan.has_families().then(|| {
        quote! {
            if #solutions.is_loose() {
                #solutions = self.#hidden(#pose, #elbow);
            }
        }
    });
    let body = quote! {
        let mut #solutions = #path::closed_form::Branches::default();
        let mut #place = ::core::option::Option::None;
        let #nearest = #path::closed_form::nearest_pose(#pose, &mut #place, #reads_rotation)#is_angle;
        if let ::core::option::Option::Some(#pose) = #nearest {
            #steps
            #search
        }
        #solutions.solutions([#(#turns),*], #nearest.is_some(), (&[#(#joints),*], &[#(#names),*]))
    };
    let searched = plan.has_families().then(|| {
        let (steps, elbow) = (method(true).body(), elbow.map(|elbow| quote!(#elbow: T,)));
        let n = number_of_joints(plan.joints);
        quote! {
            #[doc(hidden)]
            #[cold]
            #[inline(never)]
            #[allow(unused_variables, clippy::all)]
            fn #hidden<T: #path::closed_form::Real>(
                &self,
                #pose: &#path::nalgebra::Matrix4<T>,
                #elbow
            ) -> #path::closed_form::Branches<T, #n> {
                let mut #solutions = #path::closed_form::Branches::default();
                #steps
                #solutions
            }
        }
    });
    let documentation = documentation(frame, plan);
    let method = method_of(
        frame,
        plan.joints,
        plan.target == Target::PoseAndElbow,
        &documentation,
        &body,
        path,
    );
    let of_elbow = plan.proven_elbow().map(|proven| {
        let body = elbow_angle(robot, &proven, plan.joints, path);
        elbow_methods(frame, &body, path)
    });
    quote!(#method #searched #of_elbow)
}

/// The body of `elbow_angle`.
fn elbow_angle(robot: &Robot, proven: &Proven, joints: usize, path: &TokenStream) -> TokenStream {
    let program = &proven.program;
    let (writer, q) = (Writer::new(robot, proven), ident("q"));
    let constants = constants_like(&quote!(#q.data.0[0][0]), path);
    let fields = super::inputs::constant_inputs(robot, program, path);
    let name = |symbol: Symbol| {
        let place = program.inputs.iter().position(|input| *input == symbol);
        place.map(|place| writer.inputs[place].clone())
    };
    let sines = (0..joints).filter_map(|joint| {
        let both = [Symbol::Sine(joint), Symbol::Cosine(joint)].map(name);
        let is_read = both.iter().any(Option::is_some);
        let [sine, cosine] = both.map(|name| name.map_or(quote!(_), |name| quote!(#name)));
        let joint = Literal::usize_unsuffixed(joint);
        is_read
            .then(|| quote!(let (#sine, #cosine) = #path::Scalar::sin_cos(#q.data.0[0][#joint]);))
    });
    let named = (0..writer.names.len()).filter(|&line| writer.names[line].is_some());
    let lines = writer.lets(&named.collect::<Vec<_>>());
    let outputs = program.outputs.iter();
    let outputs: Vec<_> = outputs.map(|output| writer.output(*output)).collect();
    let vectors = outputs[..9].chunks(3);
    let vectors = vectors.map(|entries| quote!(#path::nalgebra::Vector3::new(#(#entries),*)));
    let size = &outputs[9];
    quote! {
        #constants
        #fields
        #(#sines)*
        #lines
        #path::closed_form::elbow_angle(#(#vectors,)* #size)
    }
}

/// The methods `elbow_angle`, with this body, and `elbow_ranges` of seven joints.
fn elbow_methods(frame: Option<&str>, body: &TokenStream, path: &TokenStream) -> TokenStream {
    let [q, pose, elbow] = ["q", "pose", "elbow"].map(ident);
    let limits = variable("limits");
    let method = inverse_method(frame);
    let named = |name: &str| Ident::new(name, proc_macro2::Span::call_site());
    let [angle, ranges] = ELBOW_METHODS.map(|name| named(&elbow_method(name, frame)));
    let inverse = named(&method);
    let about_angle =
        format!(" The angle of the elbow, rad, by which `{method}` finds these joint positions.");
    let about_ranges = format!(
        " The angles of the elbow, rad, at which `{method}` has a solution within the limits. About 300 poses are solved for it."
    );
    quote! {
        #[doc = #about_angle]
        #[allow(unused_variables, clippy::all)]
        pub fn #angle<T: #path::closed_form::Real>(&self, #q: &#path::nalgebra::SVector<T, 7>) -> T {
            #body
        }

        #[doc = #about_ranges]
        pub fn #ranges<T: #path::closed_form::Real>(
            &self,
            #pose: &#path::nalgebra::Matrix4<T>,
            #limits: &[::core::option::Option<[f64; 2]>; 7],
        ) -> #path::closed_form::ElbowRanges<T> {
            #path::closed_form::elbow_ranges(|#elbow| self.#inverse(#pose, #elbow), #limits)
        }
    }
}

/// The method that searches through families, if the one that does not has found an equation without a solution which one of
/// these might solve.
fn hidden_method(frame: Option<&str>) -> Ident {
    let name = format!("__{}_searched", inverse_method(frame));
    Ident::new(&name, proc_macro2::Span::call_site())
}

/// A method without a body.
pub fn stub_of_inverse(frame: Option<&str>, joints: usize, path: &TokenStream) -> TokenStream {
    let body = quote!(::core::unimplemented!());
    let has_elbow = joints == 7;
    let method = method_of(frame, joints, has_elbow, &[], &body, path);
    let of_elbow = has_elbow.then(|| elbow_methods(frame, &body, path));
    quote!(#method #of_elbow)
}

fn method_of(
    frame: Option<&str>,
    joints: usize,
    has_elbow: bool,
    documentation: &[String],
    body: &TokenStream,
    path: &TokenStream,
) -> TokenStream {
    let (pose, elbow, n) = (ident("pose"), ident("elbow"), number_of_joints(joints));
    let generic = (joints == 0).then(|| quote!(, const N: usize));
    let method = inverse_method(frame);
    let documentation = documentation.iter().map(|line| shown(line));
    let named = |name: &str| Ident::new(name, proc_macro2::Span::call_site());
    let (name, batch) = (named(&method), named(&format!("{method}_batch")));
    let [of_one, of_many] =
        [quote!(T), quote!(&[T])].map(|numbers| has_elbow.then(|| quote!(#elbow: #numbers,)));
    let solutions = quote!(#path::closed_form::Solutions<T, #n>);
    let about_many = format!(
        " [`{method}`](Self::{method}) of many poses. The error says which argument has another number of states than `pose`."
    );
    let [all, index, place] = ["solutions", "index", "of_pose"].map(ident);
    let lengths = has_elbow.then(|| quote!(("elbow", #elbow.len()),));
    let argument = has_elbow.then(|| quote!(#elbow[#index]));
    quote! {
        #(#[doc = #documentation])*
        #[inline(never)]
        #[allow(unused_variables, clippy::all)]
        pub fn #name<T: #path::closed_form::Real #generic>(
            &self,
            #pose: &#path::nalgebra::Matrix4<T>,
            #of_one
        ) -> #solutions {
            #body
        }

        #path::__with_std! {
            #[doc = #about_many]
            pub fn #batch<T: #path::closed_form::Real #generic>(
                &self,
                #pose: &[#path::nalgebra::Matrix4<T>],
                #of_many
                #all: &mut [#solutions],
            ) -> ::core::result::Result<(), #path::LengthMismatch> {
                #path::LengthMismatch::test(#pose.len(), &[#lengths ("solutions", #all.len())])?;
                for (#index, #place) in #all.iter_mut().enumerate() {
                    *#place = self.#name(&#pose[#index], #argument);
                }
                ::core::result::Result::Ok(())
            }
        }
    }
}

/// The joint positions that inverse kinematics gives, and what it reads of the pose: a line behind a space.
pub fn description_of_inverse(frame: Option<&str>, plan: &Plan) -> String {
    let frame = frame.map_or("tip".to_owned(), |frame| format!("frame `{frame}`"));
    let read = match plan.target {
        Target::Pose => "",
        Target::PoseAndElbow => {
            " `elbow` is the angle, rad, of the half plane that begins at the line from the shoulder to the wrist and holds the \
             elbow, about this line, from the one that holds the direction of the first axis; if axis and line are parallel, \
             from any."
        }
        Target::Position => " Only the pose's position is read.",
        Target::PositionAndAngle => {
            " Only the pose's position and its angle in the plane of the arm are read."
        }
    };
    let most = plan.most();
    let none = match plan.target {
        Target::Position => "none if it is out of reach",
        _ => "none if it is out of reach, or no rigid transform",
    };
    format!(
        " Inverse kinematics in closed form: all joint positions that lead the {frame} to `pose`, a homogeneous transform as \
         `forward_kinematics` gives it, at most {most}; {none}.{read}"
    )
}

fn documentation(frame: Option<&str>, plan: &Plan) -> Vec<String> {
    let operations = plan.program.operations();
    let count = operations.multiplications + operations.additions + operations.divisions;
    vec![
        description_of_inverse(frame, plan),
        String::new(),
        format!(
            " Each solution has been proven to lead to the pose. Equations of one joint each, whose coefficients take {count} \
             multiplications and additions. How many a call takes depends on the branches in reach, so that `OPERATIONS` has no \
             entry for it. An angle that the pose leaves free is the one nearest to zero with which the arm reaches it. A rotation \
             that is one to 1e-3 is taken as the nearest one. There is no solution if a number is not finite that is read of the \
             pose. Never panics, never allocates."
        ),
    ]
}

struct Method<'a> {
    robot: &'a Robot,
    plan: &'a Plan,
    writer: Writer<'a>,
    /// For each line the number of steps that must be done before it.
    stages: Vec<usize>,
    path: &'a TokenStream,
    /// Whether the positions that a pose leaves free are searched, or it is only noted that they should be.
    searches: bool,
}

impl Method<'_> {
    /// Everything between the pose that is taken and the solutions.
    fn body(&self) -> TokenStream {
        let is_singular = ident("is_singular");
        let pose = ident("pose");
        let constants = constants_like(&quote!(#pose.data.0[0][0]), self.path);
        let (inputs, steps) = (self.inputs(), self.from(0));
        quote! {
            let #is_singular = false;
            #constants
            #inputs
            #steps
        }
    }

    /// Fields, and the entries of the pose that are read.
    fn inputs(&self) -> TokenStream {
        let (program, pose) = (&self.plan.program, ident("pose"));
        let fields = super::inputs::constant_inputs(self.robot, program, self.path);
        let elbow = (self.plan.target == Target::PoseAndElbow).then(|| {
            let path = self.path;
            let [sine, cosine] = [ELBOW, ELBOW + 1].map(|place| self.number(place));
            let elbow = ident("elbow");
            quote!(let (#sine, #cosine) = #path::Scalar::sin_cos(#elbow);)
        });
        let entries = program.inputs.iter().filter_map(|symbol| match symbol {
            Symbol::Entry(Argument::Pose, k) if *k < ELBOW => {
                let name = variable(&input_name(self.robot, symbol, &[]));
                let (row, column) = Plan::place_in_pose(*k);
                let [row, column] = [row, column].map(Literal::usize_unsuffixed);
                Some(quote!(let #name = #pose.data.0[#column][#row];))
            }
            _ => None,
        });
        quote!(#fields #elbow #(#entries)*)
    }

    /// The lines of a stage.
    fn lines(&self, stage: usize) -> TokenStream {
        let lines = (0..self.stages.len())
            .filter(|&line| self.stages[line] == stage && self.writer.names[line].is_some());
        self.writer.lets(&lines.collect::<Vec<_>>())
    }

    /// A step and all behind it, where those before it are done.
    fn from(&self, step: usize) -> TokenStream {
        let lines = self.lines(step);
        let Some(&current) = self.plan.steps.get(step) else {
            let solution = self.solution();
            return quote!(#lines #solution);
        };
        let path = self.path;
        let outputs = &self.plan.program.outputs[self.plan.outputs_of(step)];
        let coefficients = outputs.iter().map(|output| self.writer.output(*output));
        let solve = Ident::new(current.name(), proc_macro2::Span::call_site());
        let value = quote!(#path::closed_form::#solve(#(#coefficients),*));
        let rest = self.from(step + 1);
        match current {
            Step::Condition => quote!(#lines if #value { #rest }),
            Step::Direction(_) => {
                let [direction, one, any] = ["found_direction", "is_singular", "is_any"].map(ident);
                let bound = self.bound(current, &direction);
                quote!(#lines let (#direction, #any) = #value; #bound let #one = #one || #any; #rest)
            }
            Step::Joint(joint, rule) => {
                let (found, on_circle) = (self.found(joint), ident("on_circle"));
                let bound = |of| self.bound(current, of);
                let [of_found, of_circle] = [&found, &on_circle].map(bound);
                let solutions = ident("solutions");
                let has_family = self.searches && self.plan.has_family(step);
                let family = |first: TokenStream, rest: TokenStream| {
                    let family = variable(&format!("family_{}", joint + 1));
                    quote! {
                        let mut #family = #path::closed_form::Family::new(#first);
                        while let ::core::option::Option::Some([#found, #on_circle]) = #family.next(&mut #solutions) {
                            #of_circle #rest
                        }
                    }
                };
                match rule {
                    Rule::Turn if has_family => {
                        let all = family(value, rest);
                        quote!(#lines #all)
                    }
                    Rule::Turn => {
                        quote!(#lines let [#found, #on_circle] = #value; #of_circle #rest)
                    }
                    Rule::Slide => quote!(#lines let #found = #value; #of_found #rest),
                    Rule::Turns | Rule::TurnsOfLine | Rule::Slides => {
                        let before = self.plan.families_before(step);
                        let before = before.iter().map(|joint| self.found(*joint));
                        let value = match (before.len(), self.searches) {
                            (0, _) => value,
                            (_, true) => quote!(#solutions.noted(#value)),
                            (_, false) => quote!(#solutions.asked(#value, &[#(&#before),*])),
                        };
                        let each = match has_family {
                            true => family(quote!([#found; 2]), rest),
                            false => quote!(#of_found #rest),
                        };
                        quote!(#lines for #found in #value { #each })
                    }
                }
            }
        }
    }

    /// The variable of a number behind the entries of the pose.
    fn number(&self, place: usize) -> Ident {
        let symbol = Symbol::Entry(Argument::Pose, place);
        variable(&input_name(self.robot, &symbol, &[]))
    }

    fn found(&self, joint: usize) -> Ident {
        variable(&format!("joint_{}", joint + 1))
    }

    /// Parts of the solution of a step, where they are read.
    fn bound(&self, step: Step, of: &Ident) -> TokenStream {
        let bound = self.plan.inputs_of(step).map(|(index, part)| {
            let name = &self.writer.inputs[index];
            let part = Ident::new(part, proc_macro2::Span::call_site());
            quote!(let #name = #of.#part;)
        });
        bound.collect()
    }

    /// All joints, in their order.
    fn solution(&self) -> TokenStream {
        let (solutions, is_singular) = (ident("solutions"), ident("is_singular"));
        let joints = (0..self.plan.joints).map(|joint| self.found(joint));
        quote!(#solutions.push([#(#joints),*], #is_singular);)
    }
}
