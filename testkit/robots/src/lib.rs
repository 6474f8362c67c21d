//! The robots of `tests/data/robots`, each as a user would write it, with every function: those of more than seven
//! joints by the feature `long_arms`.

// Generated code allows all of clippy's lints for each of its items, but clippy looks for what they find unless the
// whole crate allows them: a quarter of its time here. The examples have generated code that it looks at.
#![allow(clippy::all)]

#[macro_use]
mod functions;
#[macro_use]
mod every_function;

mod arguments;
mod arm;
mod coupled;
mod fields;
mod frames;
mod generic;
mod industrial;
mod joint_forces;
mod textbook;
mod three_axis;

pub use arguments::Arguments;
pub use arm::Arm;
pub use coupled::*;
pub use fields::*;
pub use frames::*;
pub use generic::*;
pub use industrial::*;
pub use joint_forces::*;
pub use textbook::*;
pub use three_axis::*;

/// Hands every robot to the macro `$then`: the name of its files in `tests/data`, its type,
/// its number of joints N, and the number of pairs of joints N(N-1)/2.
#[macro_export]
macro_rules! for_each_robot {
    ($then:ident) => {
        $crate::__and_long_arms! {
            $then
            moving_mass: MovingMass, 1, 0;
            vertical_mass: VerticalMass, 1, 0;
            geared_link: GearedLink, 1, 0;
            one_link: OneLink, 1, 0;
            generic_chain_n1: GenericChain1, 1, 0;
            two_link_saha: TwoLinkSaha, 2, 1;
            two_link_craig: TwoLinkCraig, 2, 1;
            generic_chain_n2: GenericChain2, 2, 1;
            rrr_planar: RrrPlanar, 3, 3;
            elbow_3r: Elbow3r, 3, 3;
            gantry_ppp: GantryPpp, 3, 3;
            cylindrical_rpp: CylindricalRpp, 3, 3;
            spherical_wrist: SphericalWrist, 3, 3;
            generic_chain_n3: GenericChain3, 3, 3;
            scara: Scara, 4, 6;
            generic_chain_n4: GenericChain4, 4, 6;
            aristo: Aristo, 6, 15;
            puma560: Puma560, 6, 15;
            stanford: Stanford, 6, 15;
            ur5: Ur5, 6, 15;
            generic_chain_n6: GenericChain6, 6, 15;
            generic_mixed_n6_standard: GenericMixed6, 6, 15;
            panda: Panda, 7, 21;
            generic_chain_n7: GenericChain7, 7, 21;
        }
    };
}

/// Hands the rows of robots to the macro `$then`, and those of the long arms where they are compiled.
#[cfg(feature = "long_arms")]
#[doc(hidden)]
#[macro_export]
macro_rules! __and_long_arms {
    ($then:ident $($rows:tt)*) => {
        $then! {
            $($rows)*
            generic_chain_n10: GenericChain10, 10, 45;
            generic_chain_n12: GenericChain12, 12, 66;
        }
    };
}

/// Hands the rows of robots to the macro `$then`: the feature `long_arms` adds two.
#[cfg(not(feature = "long_arms"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __and_long_arms {
    ($then:ident $($rows:tt)*) => {
        $then! { $($rows)* }
    };
}
