//! The inverse dynamics over Taylor series: each line is the coefficient of one order.
//!
//! Sums and multiples by constants are written as for numbers. A product of two series goes to a slot of the runtime's
//! table of products, which knows the coefficients of lower orders; a constant that is added counts at order 0 alone.
//! Quantities that depend on the accelerations are written twice: with accelerations of zero for the forces that they
//! have to make up, and with the accelerations for the products of later orders.

use super::body::{MOST_LETS, declared_in_groups};
use super::inputs;
use super::names::{ident, number_of_joints, punct, variable};
use crate::function::Argument;
use crate::program::{Instruction, Operand, Program, Proven, Readers};
use crate::robot::{Robot, Symbol};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

/// Products in one block of the runtime's table.
const LANES: usize = 8;

/// So many products with a common factor make a block.
const FEWEST_COMMON: usize = 5;

/// The method for a product whose factors are final, and the one for factors that are not.
const STORED: &str = "product";
const TRIAL: &str = "trial";

/// The dependence of a quantity on the motion.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// A number: constants, and what is made of the struct's fields.
    Constant,
    /// A series that positions and velocities determine.
    Known,
    /// A series that depends on the accelerations.
    Moved,
}

/// A program over series.
struct Series<'p> {
    robot: &'p Robot,
    program: &'p Program,
    constants: &'p [f64],
    /// The path of the runtime.
    path: &'p TokenStream,
    kinds: Vec<Kind>,
    /// The slot of each product of two series.
    slots: Vec<Option<usize>>,
    /// Whether the second factor of a product is the left one.
    swapped: Vec<bool>,
    /// Whether a product, directly or through others, reads the result.
    feeds_products: Vec<bool>,
    /// Multiples of a series that are written into the one sum that reads them.
    inlined: Vec<bool>,
    /// Joints whose sine or cosine is read, and followers that have one of their own: two more slots each.
    turns: Vec<usize>,
    /// The first slot of the turns.
    turning: usize,
    /// Blocks of products with a common factor, and of others.
    blocks: [usize; 2],
    inputs: Vec<Ident>,
}

/// The items of `TaylorDynamics` except for the mass matrix: the type of the table of products, and
/// the equations of motion at one order.
pub(super) fn items(robot: &Robot, proven: &Proven, path: &TokenStream) -> TokenStream {
    let series = Series::new(robot, proven, path);
    let body = series.body();
    let multiples = series.multiples().count();
    declarations(series.blocks, multiples, robot.dof(), path, &body)
}

/// The items with a given body, which reads so many sines of followers' own angles; with `dof` zero for any
/// number of joints.
pub(super) fn declarations(
    [common, single]: [usize; 2],
    multiples: usize,
    dof: usize,
    path: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let [common, single, multiples] = [common, single, multiples].map(Literal::usize_unsuffixed);
    let n = number_of_joints(dof);
    let term = ident("term");
    quote! {
        type Products<T: #path::Scalar> = #path::ProductTable<T, #common, #single, #multiples>;

        #[inline(always)]
        fn series_term<T: #path::Scalar>(&self, #term: &mut impl #path::SeriesTerm<T, #n>) {
            #body
        }
    }
}

impl<'p> Series<'p> {
    fn new(robot: &'p Robot, proven: &'p Proven, path: &'p TokenStream) -> Self {
        let Proven { program, constants } = proven;
        let count = program.instructions.len();
        let mut turns = program.joint_angles();
        turns.sort_unstable();
        let inputs = inputs::input_names(robot, program).into_iter();
        let mut series = Series {
            robot,
            program,
            constants,
            path,
            kinds: Vec::with_capacity(count),
            slots: Vec::with_capacity(count),
            swapped: vec![false; count],
            feeds_products: vec![false; count],
            inlined: vec![false; count],
            turns,
            turning: 0,
            blocks: [0; 2],
            inputs: inputs.map(|name| variable(&name)).collect(),
        };
        for instruction in &program.instructions {
            let [a, b] = instruction.operands();
            let (a, b) = (series.kind(a), series.kind(b));
            let is_product =
                matches!(instruction, Instruction::Mul(..)) && a.min(b) != Kind::Constant;
            assert!(
                !matches!(instruction, Instruction::Div(..)) || b == Kind::Constant,
                "inverse dynamics is a polynomial in the motion"
            );
            series.kinds.push(a.max(b));
            series.slots.push(is_product.then_some(0));
        }
        series.assign_slots();
        series.find_what_feeds_products();
        series.find_inlined();
        series
    }

    fn kind(&self, operand: Operand) -> Kind {
        match operand {
            Operand::Constant(_) => Kind::Constant,
            Operand::Result(index) => self.kinds[index as usize],
            Operand::Input(index) => match &self.program.inputs[index as usize] {
                Symbol::Stribeck(_) => unreachable!("has no series: see `Failure::NoSeries`"),
                symbol => match symbol.argument() {
                    Some((Argument::Position | Argument::Velocity, _)) => Kind::Known,
                    Some((Argument::Acceleration, _)) => Kind::Moved,
                    _ => Kind::Constant,
                },
            },
        }
    }

    /// Products with a common factor to blocks of their own as long as enough of them are left, the
    /// most frequent factor first; then the others.
    fn assign_slots(&mut self) {
        let products = (0..self.slots.len()).filter(|&i| self.slots[i].is_some());
        let mut left: Vec<usize> = products.collect();
        let factors = |index: usize| self.program.instructions[index].operands();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        loop {
            let candidates = left.iter().flat_map(|&i| factors(i));
            let count = |x: Operand| left.iter().filter(|&&i| factors(i).contains(&x)).count();
            let most = candidates.map(|x| (count(x), core::cmp::Reverse(x))).max();
            let Some((_, core::cmp::Reverse(common))) = most.filter(|(n, _)| *n >= FEWEST_COMMON)
            else {
                break;
            };
            let has_common = |i: &usize| factors(*i).contains(&common);
            let members = left.iter().copied().filter(has_common);
            let group: Vec<usize> = members.take(LANES).collect();
            left.retain(|i| !group.contains(i));
            for &index in &group {
                self.swapped[index] = factors(index)[0] != common;
            }
            groups.push(group);
        }
        let common = groups.len();
        for (block, group) in groups.iter().enumerate() {
            for (lane, &index) in group.iter().enumerate() {
                self.slots[index] = Some(block * LANES + lane);
            }
        }
        for (count, &index) in left.iter().enumerate() {
            // The factor that no acceleration changes comes first: its part of the sum is the same before and
            // after the accelerations are solved for.
            let [a, b] = factors(index).map(|x| self.kind(x));
            self.swapped[index] = a > b;
            self.slots[index] = Some(common * LANES + count);
        }
        self.turning = common * LANES + left.len();
        let single = left.len() + 2 * self.turns.len();
        self.blocks = [common, single.div_ceil(LANES)];
    }

    fn find_what_feeds_products(&mut self) {
        for (index, instruction) in self.program.instructions.iter().enumerate().rev() {
            if self.slots[index].is_none() && !self.feeds_products[index] {
                continue;
            }
            for operand in instruction.operands() {
                if let Operand::Result(index) = operand {
                    self.feeds_products[index as usize] = true;
                }
            }
        }
    }

    /// The multiples of a series that one sum alone reads.
    fn find_inlined(&mut self) {
        let results = self.program.instructions.iter().zip(self.program.readers());
        for (index, (instruction, readers)) in results.enumerate() {
            self.inlined[index] = matches!(instruction, Instruction::Mul(..))
                && self.slots[index].is_none()
                && self.kinds[index] != Kind::Constant
                && readers == Readers::OneSum;
        }
    }

    fn body(&self) -> TokenStream {
        let path = self.path;
        let [real, x, number] = ["real", "x", "a_number"].map(ident);
        let constants = inputs::constant_inputs(self.robot, self.program, path);
        let (known, moved): (Vec<_>, Vec<_>) =
            (0..self.program.instructions.len()).partition(|&i| self.kinds[i] != Kind::Moved);
        let mut feeding = moved.clone();
        feeding.retain(|&i| self.feeds_products[i] || self.slots[i].is_some());
        let known_inputs = self.inputs_of(Kind::Known);
        let moved_inputs = self.inputs_of(Kind::Moved);
        let multiples = self.read_multiples();
        let known = self.lines(&known, STORED);
        let trial = self.lines(&moved, TRIAL);
        let stored = self.lines(&feeding, STORED);
        let forces = ident("forces");
        let turns = self.turns.iter().enumerate().map(|(count, &joint)| {
            let slot = Literal::usize_unsuffixed(self.turning + 2 * count);
            match self.followed(joint) {
                Some((leader, factor)) => {
                    let index = self.index_of_multiple(joint);
                    self.term_call("turn_multiple", quote!(#index, #leader, #factor, #slot))
                }
                None => {
                    let joint = Literal::usize_unsuffixed(joint);
                    self.term_call("turn", quote!(#joint, #slot))
                }
            }
        });
        let values = self.program.outputs.iter().map(|output| {
            let sign = output.negative.then(|| punct('-'));
            let value = self.series(output.operand);
            quote!(#sign #value)
        });
        let like = self.term_call("like", quote!());
        let solve = self.term_call("solve", quote!(#forces));
        quote! {
            let #real = {
                let #number = #like;
                move |#x: f64| #path::Scalar::constant(#number, #x)
            };
            #constants
            #known_inputs
            #multiples
            #(#turns;)*
            #known
            let #forces = {
                #moved_inputs
                #trial
                [#(#values),*]
            };
            #solve;
            #moved_inputs
            #stored
        }
    }

    /// The followers that have a sine of their own, by the indices of their symbols.
    fn multiples(&self) -> impl Iterator<Item = usize> {
        let turns = self.turns.iter().copied();
        turns.filter(|&index| self.robot.followed(index).is_some())
    }

    fn index_of_multiple(&self, index: usize) -> Literal {
        let before = self.multiples().take_while(|&other| other != index);
        Literal::usize_unsuffixed(before.count())
    }

    /// The joint and the factor behind the index of a follower's symbol.
    fn followed(&self, index: usize) -> Option<(Literal, TokenStream)> {
        let (leader, factor) = self.robot.followed(index)?;
        let factor = inputs::constant_cell(self.robot, factor, self.path);
        Some((Literal::usize_unsuffixed(leader), factor))
    }

    /// Sines and cosines of followers' own angles.
    fn read_multiples(&self) -> TokenStream {
        let lines = self.multiples().filter_map(|index| {
            let (leader, factor) = self.followed(index)?;
            let number = self.index_of_multiple(index);
            let name = |symbol: Symbol| variable(&inputs::input_name(self.robot, &symbol, &[]));
            let (sine, cosine) = (name(Symbol::Sine(index)), name(Symbol::Cosine(index)));
            let pair = self.term_call("multiple", quote!(#number, #leader, #factor));
            Some(quote!(let (#sine, #cosine) = #pair;))
        });
        lines.collect()
    }

    fn inputs_of(&self, kind: Kind) -> TokenStream {
        let inputs = inputs::in_order(self.program).into_iter();
        let lines = inputs.filter_map(|(index, symbol)| {
            if self.kind(Operand::Input(index as u32)) != kind {
                return None;
            }
            if self.robot.follower_of(symbol).is_some() {
                return self.sign_of_follower(index, symbol);
            }
            let (method, joint) = match *symbol {
                Symbol::Sine(i) => ("sine", i),
                Symbol::Cosine(i) => ("cosine", i),
                Symbol::Position(i) => ("position", i),
                Symbol::Velocity(i) => ("velocity", i),
                Symbol::VelocitySign(i) => ("velocity_sign", i),
                Symbol::Acceleration(i) => ("acceleration", i),
                _ => return None,
            };
            let (name, joint) = (&self.inputs[index], Literal::usize_unsuffixed(joint));
            let value = self.term_call(method, quote!(#joint));
            Some(quote!(let #name = #value;))
        });
        lines.collect()
    }

    /// The sign of a follower's velocity, where that is no function of its leader's alone.
    fn sign_of_follower(&self, input: usize, symbol: &Symbol) -> Option<TokenStream> {
        let Symbol::VelocitySign(index) = symbol else {
            return None;
        };
        let (leader, factor) = self.followed(*index)?;
        let (name, path) = (&self.inputs[input], self.path);
        let sign = self.term_call("velocity_sign", quote!(#leader));
        Some(quote!(let #name = #path::Scalar::sign(#factor) * #sign;))
    }

    /// The assignments of some instructions.
    fn lines(&self, section: &[usize], product: &str) -> TokenStream {
        let mut named = section.to_vec();
        named.retain(|&index| !self.inlined[index]);
        let names: Vec<_> = named.iter().map(|&index| name(index)).collect();
        let declares_each = names.len() <= MOST_LETS;
        let declarations = (!declares_each).then(|| declared_in_groups(&names));
        let declaration = declares_each.then(|| quote!(let));
        let values = named.iter().map(|&index| self.value(index, product));
        quote!(#declarations #(#declaration #names = #values;)*)
    }

    /// The right-hand side of an instruction; `product` is the method for products of series.
    fn value(&self, index: usize, product: &str) -> TokenStream {
        let instruction = &self.program.instructions[index];
        let [a, b] = instruction.operands();
        if let Some(slot) = self.slots[index] {
            let slot = Literal::usize_unsuffixed(slot);
            let (a, b) = if self.swapped[index] { (b, a) } else { (a, b) };
            let (a, b) = (self.argument(a), self.argument(b));
            return self.term_call(product, quote!(#slot, #a, #b));
        }
        // The operands of a sum of series are series, of any other operation numbers.
        let read = |operand| match (instruction, self.kinds[index]) {
            (Instruction::Mul(..) | Instruction::Div(..), _) | (_, Kind::Constant) => {
                self.number(operand)
            }
            _ => self.series(operand),
        };
        if let Some(fused) = self.fused(instruction) {
            return fused;
        }
        let (a, operator, b) = (read(a), punct(instruction.operator()), read(b));
        quote!(#a #operator #b)
    }

    /// A sum in which a multiple of a series stands: a x + b as `a.mul_add(x, b)`.
    fn fused(&self, instruction: &Instruction) -> Option<TokenStream> {
        let (a, b, is_difference) = match *instruction {
            Instruction::Add(a, b) => (a, b, false),
            Instruction::Sub(a, b) => (a, b, true),
            _ => return None,
        };
        if let Some((x, y)) = self.inlined_product(b) {
            let (x, y, a) = (self.number(x), self.argument(y), self.addend(a));
            let x = if is_difference { quote!((-#x)) } else { x };
            return Some(quote!(#x.mul_add(#y, #a)));
        }
        let (x, y) = self.inlined_product(a)?;
        let (x, y) = (self.number(x), self.argument(y));
        let b = if is_difference {
            let b = self.series(b);
            quote!(-#b)
        } else {
            self.addend(b)
        };
        Some(quote!(#x.mul_add(#y, #b)))
    }

    fn inlined_product(&self, operand: Operand) -> Option<(Operand, Operand)> {
        let product = self.program.product(operand)?;
        matches!(operand, Operand::Result(i) if self.inlined[i as usize]).then_some(product)
    }

    /// A call of a method of `SeriesTerm`, by its path: behind a point, a method of that name of any trait that is
    /// implemented for all types and in scope around the table would come first.
    fn term_call(&self, method: &str, arguments: TokenStream) -> TokenStream {
        let (path, method, term) = (self.path, ident(method), ident("term"));
        let comma = (!arguments.is_empty()).then(|| quote!(,));
        quote!(#path::SeriesTerm::#method(#term #comma #arguments))
    }

    /// An operand as it is, in parentheses where it is a product.
    fn number(&self, operand: Operand) -> TokenStream {
        let number = self.argument(operand);
        match operand {
            Operand::Result(index) if self.inlined[index as usize] => quote!((#number)),
            _ => number,
        }
    }

    /// An operand as an argument of a call.
    fn argument(&self, operand: Operand) -> TokenStream {
        match operand {
            Operand::Constant(id) => inputs::real(self.constants[id.index()]),
            Operand::Input(index) => self.inputs[index as usize].to_token_stream(),
            Operand::Result(index) if self.inlined[index as usize] => {
                self.value(index as usize, STORED)
            }
            Operand::Result(index) => name(index as usize).to_token_stream(),
        }
    }

    /// An operand as a coefficient: constants have them at order 0 alone.
    fn series(&self, operand: Operand) -> TokenStream {
        match self.kind(operand) {
            Kind::Constant => self.addend(operand),
            _ => self.number(operand),
        }
    }

    /// The same as an argument of a call.
    fn addend(&self, operand: Operand) -> TokenStream {
        let number = self.argument(operand);
        match self.kind(operand) {
            Kind::Constant => self.term_call("constant", number),
            _ => number,
        }
    }
}

fn name(index: usize) -> Ident {
    variable(&format!("t_{}", index + 1))
}
