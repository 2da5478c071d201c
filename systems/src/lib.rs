//! A catalog of quadratic fields with the structures that their Kahan maps preserve: the Euler top,
//! Lotka–Volterra, E1 to E9 of Hone and Petrera, and further systems. Each system has a `kahan!`
//! block with a field. Its claims, if any, are proved by the macro. In blocks, ε (half the time
//! step) is written `eps`. [`registry`] lists the systems and explains how to add a system.
//! [`lattices`] has systems with any number of sites.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[macro_use]
pub mod registry;
pub mod entry;
pub mod lattices;
pub mod solution;
pub mod special;

pub mod catalog {
    //! The systems of the catalog, each with its type, its entry and its closed solutions.

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
