//! Which robots are measured, and how.

/// Hands every robot to the macro `$then`: its name, its type, its number of joints,
/// and whether it is measured in lanes too: the longest programs take the compiler minutes there, once
/// for each instruction set.
macro_rules! for_each_measured_robot {
    ($then:ident) => {
        $then! {
            moving_mass: MovingMass, 1, in_lanes;
            vertical_mass: VerticalMass, 1, in_lanes;
            geared_link: GearedLink, 1, in_lanes;
            one_link: OneLink, 1, in_lanes;
            generic_chain_n1: GenericChain1, 1, in_lanes;
            two_link_saha: TwoLinkSaha, 2, in_lanes;
            two_link_craig: TwoLinkCraig, 2, in_lanes;
            generic_chain_n2: GenericChain2, 2, in_lanes;
            rrr_planar: RrrPlanar, 3, in_lanes;
            elbow_3r: Elbow3r, 3, in_lanes;
            gantry_ppp: GantryPpp, 3, in_lanes;
            cylindrical_rpp: CylindricalRpp, 3, in_lanes;
            spherical_wrist: SphericalWrist, 3, in_lanes;
            generic_chain_n3: GenericChain3, 3, in_lanes;
            scara: Scara, 4, in_lanes;
            generic_chain_n4: GenericChain4, 4, in_lanes;
            aristo: Aristo, 6, in_lanes;
            puma560: Puma560, 6, in_lanes;
            stanford: Stanford, 6, in_lanes;
            ur5: Ur5, 6, in_lanes;
            generic_chain_n6: GenericChain6, 6, in_lanes;
            generic_mixed_n6_standard: GenericMixed6, 6, in_lanes;
            panda: Panda, 7, in_lanes;
            generic_chain_n7: GenericChain7, 7, in_lanes;
            generic_chain_n10: GenericChain10, 10, alone;
            generic_chain_n12: GenericChain12, 12, alone;
        }
    };
}
pub(crate) use for_each_measured_robot;
