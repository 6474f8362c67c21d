//! Functions at many states at once: the methods of the runtime's trait `Batch`, and those of several
//! functions as one, which belong to a robot.
//!
//! All that there is to say about a method follows from the function's row: its arguments, whether it may
//! refuse, its description.

use dynamics_symbolic::function::{Argument, Shape, Size};
use dynamics_symbolic::{Function, Request, function_type, method_name};
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};

use super::functions::{description, settings};
use super::target::Target;

/// Whose methods they are.
#[derive(Clone, Copy, PartialEq)]
enum Receiver {
    /// One arm for all states, `Self`.
    Arm,
    /// An arm for each state, of type `R`.
    Each,
}

/// A trait or an implementation with the batches of all functions among its items. In a trait they are those of
/// `Self`, in an implementation those of many arms of the type `R`.
pub fn batch_methods(item: TokenStream) -> TokenStream {
    let mut tokens: Vec<TokenTree> = item.into_iter().collect();
    let is_trait = |token: &TokenTree| token.to_string() == "trait";
    let receiver = if tokens.iter().any(is_trait) {
        Receiver::Arm
    } else {
        Receiver::Each
    };
    if let Some(TokenTree::Group(items)) = tokens.pop() {
        let mut items = items.stream();
        for parallel in [false, true] {
            let batches = Function::ALL.map(|function| Batch::of_table(function, receiver));
            items.extend(batches.iter().map(|batch| batch.method(parallel)));
        }
        tokens.push(Group::new(Delimiter::Brace, items).into());
    }
    tokens.into_iter().collect()
}

/// The batches of several functions as one, which stand beside the methods.
pub(super) fn fused(target: &Target, requests: &[Request]) -> TokenStream {
    let Target {
        name, cfgs, path, ..
    } = target;
    let is_taken = |name: &str| requests.iter().any(|request| request.name() == name);
    let fused = requests.iter().enumerate().filter(|(_, request)| {
        let name = request.name();
        let names = [format!("{name}_batch"), format!("par_{name}_batch")];
        request.function().is_none() && !names.iter().any(|name| is_taken(name))
    });
    let fused: Vec<Batch> = fused.map(|(i, r)| Batch::of_robot(target, r, i)).collect();
    if fused.is_empty() {
        return TokenStream::new();
    }
    let [one, all] = [false, true].map(|parallel| {
        let methods = fused.iter().map(|batch| batch.method(parallel));
        quote! {
            #cfgs
            #[allow(dead_code, deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
            impl #name { #(#methods)* }
        }
    });
    quote! {
        #path::__with_std! { #one }
        #path::__with_rayon! { #all }
    }
}

/// A function at many states.
struct Batch {
    /// The name of the function.
    name: String,
    description: String,
    arguments: Vec<Argument>,
    /// The name of the results.
    result: Ident,
    refuses: bool,
    receiver: Receiver,
    /// The type of the function for the trait `Function`, and its value.
    function: [TokenStream; 2],
    /// The number of joints, where it is known.
    joints: Option<Literal>,
    /// Where the methods' types are.
    path: TokenStream,
}

impl Batch {
    /// A batch of the runtime's own.
    fn of_table(function: Function, receiver: Receiver) -> Batch {
        let request = Request::One(function);
        let settings = settings(function.arguments());
        let name = format_ident!("{function:?}");
        let fields = (!settings.is_empty()).then(|| quote!({ #(#settings),* }));
        Batch {
            name: function.name().to_owned(),
            description: description(function),
            arguments: function.arguments().to_vec(),
            result: format_ident!("{}", request.result()),
            refuses: request.refuses(),
            receiver,
            function: [quote!(functions::#name), quote!(functions::#name #fields)],
            joints: None,
            path: quote!(crate),
        }
    }

    /// The batch of several functions of a robot as one.
    fn of_robot(target: &Target, request: &Request, index: usize) -> Batch {
        let path = target.path;
        let name = method_name(request);
        let index_literal = Literal::usize_unsuffixed(index);
        Batch {
            name: request.name().to_owned(),
            description: format!("What `{name}` returns."),
            arguments: request.arguments(),
            result: Ident::new("all_values", Span::call_site()),
            refuses: request.refuses(),
            receiver: Receiver::Arm,
            function: [
                function_type(request, index, path),
                quote!(#path::functions::Fused::<#index_literal>),
            ],
            joints: (target.dof > 0).then(|| target.n()),
            path: path.clone(),
        }
    }

    fn method(&self, parallel: bool) -> TokenStream {
        let Batch { path, result, .. } = self;
        let [function, value] = &self.function;
        let is_of_table = self.joints.is_none();
        let (name, run) = if parallel {
            (
                format_ident!("par_{}_batch", self.name),
                quote!(on_all_cores),
            )
        } else {
            (format_ident!("{}_batch", self.name), quote!(on_one_core))
        };
        let visibility = (self.receiver == Receiver::Each || !is_of_table).then(|| quote!(pub));
        let n = self
            .joints
            .as_ref()
            .map_or(quote!(N), ToTokens::to_token_stream);
        let generic = is_of_table.then(|| quote!(, const N: usize));
        let (arm, arms) = match self.receiver {
            Receiver::Arm => (quote!(Self), quote!(self)),
            Receiver::Each => (quote!(R), quote!(self.0)),
        };
        let sizes = self.arguments.iter().map(|argument| size(*argument, &n));
        let names = self
            .arguments
            .iter()
            .map(|argument| format_ident!("{}", argument.name()));
        let named: Vec<_> = names.zip(sizes).collect();
        let arguments = named.iter().map(|(name, size)| match size {
            Some(size) => quote!(#name: impl #path::States<#size, T>),
            None => quote!(#name: usize),
        });
        let vectors = named.iter().filter(|(_, size)| size.is_some());
        let vectors = vectors.map(|(name, _)| name);
        let bounds = self.bounds(parallel, &n);
        let done = quote! {
            #path::#run::<_, #arm, T, _, _, _, #n>(
                #value,
                #arms,
                (#(#path::States::source(#vectors),)*),
                #path::StatesMut::sink(#result),
            )
        };
        let (error, body) = if self.refuses {
            (quote!(BatchError), quote!(#path::failing(#done)))
        } else {
            (quote!(LengthMismatch), quote!(#done.map(|_| ())))
        };
        let cfg = (parallel && is_of_table).then(|| quote!(#[cfg(feature = "rayon")]));
        let documentation = self.documentation(parallel);
        quote! {
            #cfg
            #(#[doc = #documentation])*
            #[allow(clippy::too_many_arguments)]
            #visibility fn #name<T: #path::Precision #generic>(
                &self,
                #(#arguments,)*
                #result: impl #path::StatesMut<<#arm as #path::Function<#function, #n>>::Values, T>,
            ) -> ::core::result::Result<(), #path::#error>
            #bounds
            {
                #body
            }
        }
    }

    /// The bounds on the arm, where its type is not known.
    fn bounds(&self, parallel: bool, n: &TokenStream) -> Option<TokenStream> {
        if self.joints.is_some() {
            return None;
        }
        let (path, [function, _]) = (&self.path, &self.function);
        let sync = parallel.then(|| quote!(+ Sync));
        let sizes = self
            .arguments
            .iter()
            .filter_map(|argument| size(*argument, n));
        let vectors = sizes.map(|size| quote!(#path::Entries<#size, 1>));
        let function = quote!(#path::Function<#function, #n, Arguments = (#(#vectors,)*)>);
        Some(match self.receiver {
            Receiver::Arm => quote!(where Self: #function + Sized #sync),
            Receiver::Each => quote!(where R: #function + #path::Fields #sync),
        })
    }

    fn documentation(&self, parallel: bool) -> Vec<String> {
        let name = &self.name;
        let errors: &[&str] = if self.refuses {
            &[
                " [`BatchError::Length`] where an argument or the results have another number of states than the",
                " first argument: nothing is written then; [`BatchError::Singular`] where a mass matrix is not positive",
                " definite: the first such state with what a single call says of it. The values of all states are",
                " written then too; they are NaN where there are none.",
            ]
        } else {
            &[
                " [`LengthMismatch`] where an argument or the results have another number of states than the first",
                " argument; nothing is written then.",
            ]
        };
        let mut lines = match (parallel, self.receiver) {
            (true, _) => vec![
                format!(" `{name}_batch` on all cores, by rayon's global thread pool."),
                String::new(),
                " What takes less than some twenty microseconds stays on this core.".to_owned(),
            ],
            (false, Receiver::Each) => {
                vec![format!(
                    " `{name}_batch` with an arm for each state: see [`Batch`]."
                )]
            }
            (false, Receiver::Arm) => self.in_full(),
        };
        lines.extend(
            ["", " # Errors", ""]
                .iter()
                .chain(errors)
                .map(|line| (*line).to_owned()),
        );
        if self.joints.is_some() {
            // The types are not in the reach of the user's documentation.
            for line in &mut lines {
                *line = line.replace("[`", "`").replace("`]", "`");
            }
        }
        lines
    }

    /// The description, the arguments and the results.
    fn in_full(&self) -> Vec<String> {
        let mut lines = vec![
            format!(" At every state: {}", self.description),
            String::new(),
        ];
        lines.extend(self.arguments.iter().filter_map(|argument| {
            let meaning = argument.meaning("rad or m", "N m or N")?;
            Some(format!(" - `{}`: {meaning};", argument.name()))
        }));
        lines.push(format!(
            " - `{}`: room for what `{}` returns.",
            self.result, self.name
        ));
        lines
    }
}

/// The number of values of an argument at a state; none of one that is the same for all states.
fn size(argument: Argument, n: &TokenStream) -> Option<TokenStream> {
    Some(match argument.shape()? {
        Shape::Matrix(Size::Fixed(size), _) => Literal::usize_unsuffixed(size).to_token_stream(),
        _ => n.clone(),
    })
}
