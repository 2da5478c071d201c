//! The Korteweg-de Vries equation u_t = −6 u u_x − u_xxx on a ring of sites at distance h. Central
//! differences of H = Σ (½u_x² − u³) give the Hamiltonian form u_t = D ∇H with D = (S − S⁻¹)/2h and
//! the shift S. D is constant and antisymmetric; therefore the map preserves a modified energy.

use kahan_core::prelude::*;

kahan! {
    /// The equation of Korteweg and de Vries by central differences.
    pub struct Kdv {
        /// The distance of two sites.
        h
    }
    for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
    integral mass = sum(u[i]);
    hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3);
}
