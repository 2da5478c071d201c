//! The catalog by name: which systems there are, and everything that is told of all of them at
//! once.
//!
//! # Adding a system
//!
//! 1. A file in `systems/src/catalog/`, say `toda.rs`: the `kahan!` block, and an [`Entry`] called
//!    `ENTRY` below it. `weierstrass.rs` is a short one to copy.
//! 2. A line in [`with_catalog!`](crate::with_catalog): `toda::Toda { a } in 4;`, four being the
//!    number of variables.
//!
//! The command, the atlas, the completions and the tests read the registry. The modules are
//! declared by a macro, which `cargo fmt` does not look into: `rustfmt systems/src/catalog/*.rs`
//! formats them, and `.ci/run` checks that it was done.

use crate::catalog::*;
use crate::entry::Entry;

/// Hands the catalog to a macro: `paper { … } further { … }`, a line a system, in the order in
/// which they are listed.
///
/// A line is the module, the type with its parameters, if it has any, and the number of variables.
/// In `paper` are the systems of Hone and Petrera, in `further` all others.
///
/// ```
/// use kahan_systems::with_catalog;
///
/// macro_rules! dimensions {
///     ($($group:ident { $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)* })*) => {
///         [$($((stringify!($type), $n)),*),*]
///     };
/// }
/// assert!(with_catalog!(dimensions).contains(&("LotkaVolterra", 2)));
/// ```
#[macro_export]
macro_rules! with_catalog {
    ($callback:ident) => {
        $callback! {
            paper {
                euler::EulerTop { a1, a2, a3 } in 3;
                lotka_volterra::LotkaVolterra in 2;
                e1::E1 in 3;
                e2::E2 in 3;
                e3::E3 in 3;
                e4::E4 in 3;
                e5::E5 in 3;
                e6::E6 in 3;
                e7::E7 { xi } in 3;
                e8::E8 in 3;
                e9::E9 { xi } in 3;
            }
            further {
                weierstrass::Weierstrass { a } in 2;
                volterra::VolterraLattice in 3;
                volterra4::VolterraFour in 4;
                lagrange::LagrangeTop { al, g } in 6;
                henon_heiles::HenonHeiles { a, b, c } in 4;
                zhukovsky::ZhukovskyVolterra { a1, a2, a3, b1, b2, b3 } in 3;
                clebsch::Clebsch { w1, w2, w3 } in 6;
                maxwell_bloch::MaxwellBloch in 3;
                nahm::OctahedralNahm in 2;
                lorenz::Lorenz { s, r, b } in 3;
            }
        }
    };
}

macro_rules! entries {
    (
        paper { $($paper:ident::$of_paper:ident $({ $($p:ident),* })? in $n:literal;)* }
        further { $($further:ident::$of_further:ident $({ $($q:ident),* })? in $m:literal;)* }
    ) => {
        /// The systems of the paper, in the order in which they are listed.
        pub static SYSTEMS: &[Entry] = &[$($paper::ENTRY),*];

        /// The systems that are not in the paper: what is claimed of them was found by `kahan
        /// discover`.
        pub static FURTHER: &[Entry] = &[$($further::ENTRY),*];
    };
}

with_catalog!(entries);

/// The whole catalog: the systems of the paper, then the others.
pub fn all() -> impl Iterator<Item = &'static Entry> {
    SYSTEMS.iter().chain(FURTHER)
}

/// The system with this command name or type name, in any case of letters.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    all().find(|entry| name.eq_ignore_ascii_case(entry.command) || name.eq_ignore_ascii_case(entry.type_name))
}
