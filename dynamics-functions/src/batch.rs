//! Functions at many states at once: the methods of the runtime's trait `Batch`, and one of several functions that
//! belong to a robot.
//!
//! All that there is to say about a method follows from the function's row: its arguments, whether it may
//! refuse, its description.

use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};

use crate::items::{description, settings};
use crate::{Argument, Function, Request, Shape, Size};

/// Whose methods they are.
#[derive(Clone, Copy, PartialEq)]
enum Receiver {
    /// One arm for all states, `Self`.
    Arm,
    /// An arm for each state.
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
    let place = tokens
        .iter()
        .rev()
        .find(|token| matches!(token, TokenTree::Ident(_)));
    let place = place.map_or_else(Span::call_site, TokenTree::span);
    if let Some(TokenTree::Group(items)) = tokens.pop() {
        let mut items = items.stream();
        for parallel in [false, true] {
            items.extend(Function::ALL.into_iter().map(|function| {
                let batch = Batch::of_table(function, receiver);
                at(batch.method(parallel), place)
            }));
        }
        tokens.push(Group::new(Delimiter::Brace, items).into());
    }
    tokens.into_iter().collect()
}

/// Tokens at that place, which the compiler shows in place of all items.
fn at(tokens: TokenStream, place: Span) -> TokenStream {
    let at_place = |mut token: TokenTree| {
        if let TokenTree::Group(group) = &token {
            token = Group::new(group.delimiter(), at(group.stream(), place)).into();
        }
        token.set_span(place);
        token
    };
    tokens.into_iter().map(at_place).collect()
}

/// A function at many states.
#[derive(Clone)]
pub struct Batch {
    /// The name of the function.
    name: String,
    description: String,
    arguments: Vec<Argument>,
    /// The name of the results.
    result: Ident,
    refuses: bool,
    receiver: Receiver,
    /// The type of an arm.
    arm: TokenStream,
    /// The type of the function for the trait `Function`, and its value.
    function: [TokenStream; 2],
    /// The numbers of joints and of degrees of freedom, of one robot.
    sizes: Option<[TokenStream; 2]>,
    /// The declaration of constants in these numbers, and what is true of them.
    generics: [TokenStream; 2],
    /// Where the methods' types are.
    path: TokenStream,
}

impl Batch {
    /// The methods for many states of a function of the runtime.
    fn of_table(function: Function, receiver: Receiver) -> Batch {
        let request = Request::from(function);
        let (name, value) = (format_ident!("{function:?}"), value(function));
        Batch {
            name: function.name().to_owned(),
            description: description(function),
            arguments: function.arguments().to_vec(),
            result: format_ident!("{}", request.result()),
            refuses: request.refuses(),
            receiver,
            arm: match receiver {
                Receiver::Arm => quote!(Self),
                Receiver::Each => quote!(R),
            },
            function: [quote!(functions::#name), quote!(functions::#value)],
            sizes: None,
            generics: [quote!(const N: usize), TokenStream::new()],
            path: quote!(crate),
        }
    }

    /// The methods for many states of a robot's request of this index: several functions as one, a function of a
    /// frame, or, if its base moves, any function. `path` is that of the runtime.
    pub fn of_robot(
        request: &Request,
        index: usize,
        method: &Ident,
        (sizes, generics): ([TokenStream; 2], [TokenStream; 2]),
        path: &TokenStream,
    ) -> Batch {
        let function = match request.function() {
            Some(function) => {
                let value = value(function);
                let name = format_ident!("{function:?}");
                [
                    quote!(#path::functions::#name),
                    quote!(#path::functions::#value),
                ]
            }
            None => {
                let index = Literal::usize_unsuffixed(index);
                let fused = quote!(#path::functions::Fused);
                [quote!(#fused<#index>), quote!(#fused::<#index>)]
            }
        };
        Batch {
            name: request.name().to_owned(),
            description: format!("The values that `{method}` returns."),
            arguments: request.arguments(),
            result: Ident::new("all_values", Span::call_site()),
            refuses: request.refuses(),
            receiver: Receiver::Arm,
            arm: quote!(Self),
            function,
            sizes: Some(sizes),
            generics,
            path: path.clone(),
        }
    }

    /// The same with an arm of this type for each state.
    #[must_use]
    pub fn of_each(&self, arm: &Ident) -> Batch {
        Batch {
            receiver: Receiver::Each,
            arm: arm.to_token_stream(),
            ..self.clone()
        }
    }

    /// The method, on one core or on all.
    pub fn method(&self, parallel: bool) -> TokenStream {
        let Batch {
            path, result, arm, ..
        } = self;
        let [function, value] = &self.function;
        let is_of_table = self.sizes.is_none();
        let (prefix, run) = if parallel {
            ("par_", quote!(on_all_cores))
        } else {
            ("", quote!(on_one_core))
        };
        let name = format_ident!("{prefix}{}_batch", self.name);
        let visibility = (self.receiver == Receiver::Each || !is_of_table).then(|| quote!(pub));
        let [n, v] = match &self.sizes {
            Some(sizes) => sizes.clone(),
            None => [quote!(N), quote!(N)],
        };
        let [generics, where_clause] = &self.generics;
        let generics = (!generics.is_empty()).then(|| quote!(, #generics));
        let arms = match self.receiver {
            Receiver::Arm => quote!(self),
            Receiver::Each => quote!(self.0),
        };
        let arguments = self.arguments.iter().map(|argument| {
            let name = format_ident!("{}", argument.name());
            match argument.shape().map(|shape| length(shape, [&n, &v])) {
                Some(length) => quote!(#name: impl #path::States<#length, T>),
                None => quote!(#name: usize),
            }
        });
        let vectors = self.arguments.iter().filter(|a| a.shape().is_some());
        let names = vectors.map(|argument| format_ident!("{}", argument.name()));
        let bounds = self.bounds(parallel, &n);
        let done = quote! {
            #path::#run::<_, #arm, T, _, _, _, #n>(
                #value,
                #arms,
                (#(#path::States::source(#names),)*),
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
            #visibility fn #name<T: #path::Precision #generics>(
                &self,
                #(#arguments,)*
                #result: impl #path::StatesMut<<#arm as #path::Function<#function, #n>>::Values, T>,
            ) -> ::core::result::Result<(), #path::#error>
            #bounds #where_clause
            {
                #body
            }
        }
    }

    /// The bounds of the arm's type, where that is not known.
    fn bounds(&self, parallel: bool, n: &TokenStream) -> Option<TokenStream> {
        if self.sizes.is_some() {
            return None;
        }
        let (path, arm, [function, _]) = (&self.path, &self.arm, &self.function);
        let sync = parallel.then(|| quote!(+ Sync));
        let shapes = self.arguments.iter().filter_map(|a| a.shape());
        let lengths = shapes.map(|shape| length(shape, [n, n]));
        let function =
            quote!(#path::Function<#function, #n, Arguments = (#(#path::Entries<#lengths, 1>,)*)>);
        Some(match self.receiver {
            Receiver::Arm => quote!(where #arm: #function + Sized #sync),
            Receiver::Each => quote!(where #arm: #function + #path::Fields #sync),
        })
    }

    fn documentation(&self, parallel: bool) -> Vec<String> {
        let name = &self.name;
        let errors = if self.refuses {
            [
                " [`BatchError::Length`] where an argument or the results have another number of states than the",
                " first argument: nothing is written then; [`BatchError::Singular`] where a mass matrix is not positive",
                " definite: the first such state with what a single call says of it. The values of all states are",
                " written then too; they are NaN where there are none.",
            ]
            .as_slice()
        } else {
            [
                " [`LengthMismatch`] where an argument or the results have another number of states than the first",
                " argument; nothing is written then.",
            ]
            .as_slice()
        };
        let mut lines = match (parallel, self.receiver) {
            (true, _) => vec![
                format!(" `{name}_batch` on all cores, by rayon's global thread pool."),
                String::new(),
                " Work of less than about twenty microseconds stays on this core.".to_owned(),
            ],
            (false, Receiver::Each) => {
                vec![format!(
                    " `{name}_batch` with an arm for each state: see [`Batch`]."
                )]
            }
            (false, Receiver::Arm) => self.in_full(),
        };
        lines.extend([String::new(), " # Errors".to_owned(), String::new()]);
        lines.extend(errors.iter().map(|line| (*line).to_owned()));
        if self.sizes.is_some() {
            // The types are not in the reach of the user's documentation.
            lines = lines
                .iter()
                .map(|line| line.replace("[`", "`").replace("`]", "`"))
                .collect();
        }
        lines
    }

    /// The documentation's text: what the method is, and its arguments.
    fn in_full(&self) -> Vec<String> {
        let mut lines = vec![
            format!(" At every state: {}", self.description),
            String::new(),
        ];
        for argument in &self.arguments {
            if let Some(meaning) = argument.meaning("rad or m", "N m or N") {
                lines.push(format!(" - `{}`: {meaning};", argument.name()));
            }
        }
        lines.push(format!(
            " - `{}`: room for what `{}` returns.",
            self.result, self.name
        ));
        lines
    }
}

/// The value of a function's type, with the settings among its arguments.
fn value(function: Function) -> TokenStream {
    let (name, settings) = (
        format_ident!("{function:?}"),
        settings(function.arguments()),
    );
    if settings.is_empty() {
        quote!(#name)
    } else {
        quote!(#name { #(#settings),* })
    }
}

/// The number of entries of an argument.
fn length(shape: Shape, [joints, freedoms]: [&TokenStream; 2]) -> TokenStream {
    match shape {
        Shape::Matrix(Size::Freedoms, _) => freedoms.clone(),
        Shape::Matrix(Size::Fixed(length), _) => {
            Literal::usize_unsuffixed(length).into_token_stream()
        }
        _ => joints.clone(),
    }
}
