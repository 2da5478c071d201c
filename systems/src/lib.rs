//! A catalog of Kahan maps with what they preserve: the Euler top, Lotka–Volterra and the systems
//! E1 to E9 of Hone and Petrera, and further systems. In: a quadratic field a file, written as a
//! `kahan!` block with its claims. Out: the types that the macro makes of the blocks, the closed
//! solutions that are known, and an [`Entry`](entry::Entry) each, by [`registry`]. It must
//! not know the `kahan` command, nor the paper's claims.
//!
//! A block claims every rational formula that holds, and the macro proves it while it compiles the
//! block; the file's first lines name what no rational formula can say. The half step ε is written
//! `eps`. [`registry`] says how a system is added. [`lattices`] are systems of any number of sites.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[macro_use]
pub mod registry;
pub mod entry;
pub mod lattices;
pub mod solution;
pub mod special;

pub mod catalog {
    //! The systems, one module each, with all that belongs to it: its type, its entry, its closed
    //! solutions.

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
