//! A catalog of quadratic fields with the structures that their Kahan maps preserve: the Euler top,
//! Lotka–Volterra, E1 to E9 of Hone and Petrera, and further systems. Each file holds a field as a
//! `kahan!` block with its claims, which the macro proves; ε, half the time step, is written `eps`.
//! The crate exports the macro's types, closed solutions, and an [`Entry`](entry::Entry) for each
//! system in [`registry`], which explains how to add one. [`lattices`] are systems with any number
//! of sites. The crate must not know the `kahan` command or the claims of the paper.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[macro_use]
pub mod registry;
pub mod entry;
pub mod lattices;
pub mod solution;
pub mod special;

pub mod catalog {
    //! The systems: one module each, with its type, entry and closed solutions.

    macro_rules! modules {
        ($($group:ident {
            $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)*
        })*) => {
            $($(
                pub mod $module;
                pub use $module::$type;
            )*)*
        };
    }

    with_catalog!(modules);
}

pub use catalog::*;
