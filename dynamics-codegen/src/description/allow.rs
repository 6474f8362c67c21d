//! Odd numbers that are accepted.

/// Makes the description of `allow` out of its words, each with its meaning.
macro_rules! allowances {
    ($($(#[$meaning:meta])* $word:ident,)*) => {
        /// `allow: [unphysical_inertia]`: numbers that are accepted, odd as they are.
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Allow {
            $($(#[$meaning])* pub $word: bool,)*
        }

        impl Allow {
            /// The words that `allow` of the whole table may hold.
            pub const WORDS: [&'static str; [$(stringify!($word)),*].len()] =
                [$(stringify!($word)),*];

            /// All of it: what is meant to be allowed is not known.
            pub const EVERYTHING: Allow = Allow { $($word: true,)* };

            /// The allowances of this or the other one.
            pub fn or(self, other: Allow) -> Allow {
                Allow { $($word: self.$word || other.$word,)* }
            }

            /// Allows one of the words.
            pub(crate) fn note(&mut self, word: &str) {
                $(self.$word |= word == stringify!($word);)*
            }
        }
    };
}

allowances! {
    /// Links of a URDF file whose inertia is not given, and arms without any: they are massless.
    no_inertia,
    /// An angle of more than a turn or of four whole radians or more, or nearly a right one.
    odd_angle,
    /// A centre of mass far from everything.
    odd_com,
    /// A motor that turns more slowly than its joint.
    odd_gear_ratio,
    /// Gravity as it is nowhere, or the same along all axes.
    odd_gravity,
    /// Lengths in mm.
    odd_length,
    /// Limits whose lower one is above the upper one: the joint has none then.
    odd_limits,
    /// A centre of mass or a tensor without a mass, or a mass in g; an arm without any inertia, too.
    odd_mass,
    /// A tensor that no body has.
    unphysical_inertia,
}
