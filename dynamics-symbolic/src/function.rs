//! The functions that can be generated for a robot.

/// A function of the generated model, by its contract name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// M(q), kg m^2 (revolute) or kg (prismatic).
    MassMatrix,
    /// V(q, qd), Coriolis and centrifugal terms.
    CoriolisVector,
    /// G(q) = dU/dq.
    GravityVector,
    /// F(qd), viscous and Coulomb friction.
    FrictionVector,
    /// tau = M qdd + V + G + F.
    InverseDynamics,
    /// qdd from tau.
    ForwardDynamics,
    /// T(q, qd), with reflected inertias.
    KineticEnergy,
    /// U(q), zero at the base origin.
    PotentialEnergy,
    /// V + G + F.
    BiasForce,
    /// C(q, qd) from the Christoffel symbols of the first kind.
    CoriolisMatrix,
    /// B(q) of the configuration-space form.
    CoriolisCoefficients,
    /// C(q) of the configuration-space form.
    CentrifugalCoefficients,
    /// Homogeneous transform of the last link frame in the base.
    ForwardKinematics,
    /// Homogeneous transforms of every link frame in the base.
    LinkPoses,
    /// Geometric Jacobian of the last frame's origin.
    Jacobian,
    /// d tau/dq and d tau/dqd.
    InverseDynamicsDerivatives,
    /// d qdd/dq, d qdd/dqd and M^-1.
    ForwardDynamicsDerivatives,
    /// Y(q, qd, qdd), the coefficients of the base inertial parameters in tau - F.
    Regressor,
    /// The base inertial parameters.
    BaseParameters,
    /// qdd from tau by articulated bodies, without M: accurate where M is nearly singular.
    ForwardDynamicsAba,
    /// The Taylor coefficients of a motion q(t), from the inverse dynamics over series.
    TaylorSeries,
}

impl Function {
    /// Every function, in the order in which they are generated and documented.
    pub const ALL: [Function; 21] = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::GravityVector,
        Function::FrictionVector,
        Function::InverseDynamics,
        Function::ForwardDynamics,
        Function::KineticEnergy,
        Function::PotentialEnergy,
        Function::BiasForce,
        Function::CoriolisMatrix,
        Function::CoriolisCoefficients,
        Function::CentrifugalCoefficients,
        Function::ForwardKinematics,
        Function::LinkPoses,
        Function::Jacobian,
        Function::InverseDynamicsDerivatives,
        Function::ForwardDynamicsDerivatives,
        Function::Regressor,
        Function::BaseParameters,
        Function::ForwardDynamicsAba,
        Function::TaylorSeries,
    ];

    /// The name of the generated method.
    pub fn name(self) -> &'static str {
        match self {
            Function::MassMatrix => "mass_matrix",
            Function::CoriolisVector => "coriolis_vector",
            Function::GravityVector => "gravity_vector",
            Function::FrictionVector => "friction_vector",
            Function::InverseDynamics => "inverse_dynamics",
            Function::ForwardDynamics => "forward_dynamics",
            Function::KineticEnergy => "kinetic_energy",
            Function::PotentialEnergy => "potential_energy",
            Function::BiasForce => "bias_force",
            Function::CoriolisMatrix => "coriolis_matrix",
            Function::CoriolisCoefficients => "coriolis_coefficients",
            Function::CentrifugalCoefficients => "centrifugal_coefficients",
            Function::ForwardKinematics => "forward_kinematics",
            Function::LinkPoses => "link_poses",
            Function::Jacobian => "jacobian",
            Function::InverseDynamicsDerivatives => "inverse_dynamics_derivatives",
            Function::ForwardDynamicsDerivatives => "forward_dynamics_derivatives",
            Function::Regressor => "regressor",
            Function::BaseParameters => "base_parameters",
            Function::ForwardDynamicsAba => "forward_dynamics_aba",
            Function::TaylorSeries => "taylor_series",
        }
    }

    /// The name of the runtime's trait for the function, where there is one: those functions
    /// that are also evaluated at many states at once, and Taylor series.
    pub fn trait_name(self) -> Option<&'static str> {
        match self {
            Function::MassMatrix => Some("MassMatrix"),
            Function::CoriolisVector => Some("CoriolisVector"),
            Function::GravityVector => Some("GravityVector"),
            Function::InverseDynamics => Some("InverseDynamics"),
            Function::ForwardDynamics => Some("ForwardDynamics"),
            Function::TaylorSeries => Some("TaylorDynamics"),
            _ => None,
        }
    }

    /// The function of that name.
    pub fn from_name(name: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|f| f.name() == name)
    }

    /// The set that is generated where a table asks for no functions by name:
    /// `friction_vector` belongs to it where a row has friction.
    pub fn default_set(has_friction: bool) -> Vec<Function> {
        Function::ALL
            .into_iter()
            .filter(|f| *f <= Function::PotentialEnergy)
            .filter(|f| has_friction || *f != Function::FrictionVector)
            .collect()
    }
}
