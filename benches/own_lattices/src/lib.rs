//! Lattices that a user wrote with only the README and the language reference.
//! `cargo run --release -p kahan-bench-own-lattices --bin check` in this folder compares their
//! steps with Kahan's map by dense elimination.
#![allow(missing_docs, reason = "parameters are named in the equations")]
use kahan_core::prelude::*;

kahan! {
    /// Predator and prey along a valley with open ends, each diffusing; the prey's growth rate
    /// differs from site to site.
    pub struct PredatorPrey { /// diffusion of the prey
        du, dv, grow, eat, die }
    for i in open {
        u[i]dot = u[i]*(grow[i] - u[i] - eat*v[i]) + du*(u[i-1] - 2*u[i] + u[i+1]);
        v[i]dot = v[i]*(eat*u[i] - die) + dv*(v[i-1] - 2*v[i] + v[i+1]);
    }
}

kahan! {
    /// Bogoyavlensky's quadratic lattice with three neighbours on each side.
    pub struct Bogoyavlensky;
    for i in periodic {
        x[i]dot = x[i]*(x[i+3] + x[i+2] + x[i+1] - x[i-1] - x[i-2] - x[i-3]);
    }
    integral S = sum(x[i]);
}

kahan! {
    /// A ring with diffusion and with a quadratic flux of strength c over offsets up to 3.
    pub struct Flux { c }
    for i in periodic {
        q[i]dot = c*(q[i+2]*q[i+3] - q[i-1]*q[i]) + (q[i+1] - 2*q[i] + q[i-1]);
    }
    integral total = sum(q[i]);
}

kahan! {
    /// The equation u_tt = u_xx + u u_x of first order in time. This form is not Hamiltonian.
    pub struct Wave { h }
    for i in periodic {
        u[i]dot = v[i];
        v[i]dot = (u[i+1] - 2*u[i] + u[i-1])/h^2 + (u[i+1]^2 - u[i-1]^2)/(4*h);
    }
    integral momentum = sum(v[i]);
}

kahan! {
    /// The α-chain of Fermi, Pasta, Ulam and Tsingou: u_tt = u_xx + α(u_x²)_x.
    pub struct Fput { alpha }
    for i in periodic {
        u[i]dot = p[i];
        p[i]dot = (u[i+1] - 2*u[i] + u[i-1]) + alpha*((u[i+1] - u[i])^2 - (u[i] - u[i-1])^2);
    }
    integral momentum = sum(p[i]);
    hamiltonian H = sum(p[i]^2/2 + (u[i+1] - u[i])^2/2 + alpha*(u[i+1] - u[i])^3/3);
}

kahan! {
    /// The α-chain of Fermi, Pasta, Ulam and Tsingou with fixed ends.
    pub struct FputOpen { alpha }
    for i in open {
        u[i]dot = p[i];
        p[i]dot = (u[i+1] - 2*u[i] + u[i-1]) + alpha*((u[i+1] - u[i])^2 - (u[i] - u[i-1])^2);
    }
    // The powers of u[i+1] - u[i] are multiplied out, since their sum lacks the left bond u[0] - 0.
    hamiltonian H = sum(p[i]^2/2 + u[i]^2 - u[i]*u[i+1] + alpha*(u[i]^2*u[i+1] - u[i]*u[i+1]^2));
}

kahan! {
    /// Predator and prey that cannot leave. The rates of exchange with the left and right neighbour
    /// are parameters of a site, and are 0 across the ends.
    pub struct NoFlux { left, right, grow }
    for i in open {
        u[i]dot = u[i]*(grow[i] - u[i] - v[i]) + right[i]*(u[i+1] - u[i]) + left[i]*(u[i-1] - u[i]);
        v[i]dot = v[i]*(u[i] - 1) + right[i]*(v[i+1] - v[i]) + left[i]*(v[i-1] - v[i]);
    }
}
