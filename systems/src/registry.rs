//! Finds the systems of the catalog by name.
//!
//! # Adding a system
//!
//! 1. Write a file in `systems/src/catalog/`, for example `toda.rs`, with the `kahan!` block and,
//!    below it, an [`Entry`] with the name `ENTRY`. `weierstrass.rs` is a short example.
//! 2. Add a line to [`with_catalog!`](crate::with_catalog), for example `toda::Toda { a } in 4;`
//!    for a system with four variables.
//!
//! The `kahan` command, its shell completions, the atlas (the crate `kahan-atlas`) and the tests
//! read the registry. `cargo fmt` skips the catalog; `rustfmt systems/src/catalog/*.rs` formats it.

use crate::catalog::*;
use crate::entry::Entry;

/// Calls a macro with the catalog: `paper { … } further { … }`, where `paper` has the systems of
/// Hone and Petrera. Each system has one line with the module, the type with its parameters, if
/// any, and the number of variables.
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
        /// The systems of the paper, in order of display.
        pub static SYSTEMS: &[Entry] = &[$($paper::ENTRY),*];

        /// The other systems, in order of display. `kahan discover` found their claims.
        pub static FURTHER: &[Entry] = &[$($further::ENTRY),*];
    };
}

with_catalog!(entries);

/// Returns all systems: first those of the paper, then the others.
pub fn all() -> impl Iterator<Item = &'static Entry> {
    SYSTEMS.iter().chain(FURTHER)
}

/// Finds a system by its command name or type name, in upper or lower case.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    all().find(|entry| name.eq_ignore_ascii_case(entry.command) || name.eq_ignore_ascii_case(entry.type_name))
}
