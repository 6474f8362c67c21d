//! Torque laws.

use nalgebra::SVector;

/// A torque law: the joint torques in N m or N as a function of t in s, q in rad or m, and qd.
///
/// Every such function is one.
pub(super) trait TorqueLaw<const N: usize>:
    Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>
{
}

impl<L, const N: usize> TorqueLaw<N> for L where
    L: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>
{
}

/// The torque law of free motion: no torque.
pub type NoTorque<const N: usize> = fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>;
