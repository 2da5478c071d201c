//! The systems by name.

use crate::entry::Entry;
use crate::{e1, e2, e3, e4, e5, e6, e7, e8, e9, euler, lotka_volterra};
use crate::{henon_heiles, lagrange, lorenz, volterra, volterra4, weierstrass, zhukovsky};

/// The systems of the paper, in the order in which they are listed.
pub static SYSTEMS: [Entry; 11] = [
    euler::ENTRY,
    lotka_volterra::ENTRY,
    e1::ENTRY,
    e2::ENTRY,
    e3::ENTRY,
    e4::ENTRY,
    e5::ENTRY,
    e6::ENTRY,
    e7::ENTRY,
    e8::ENTRY,
    e9::ENTRY,
];

/// The systems that are not in the paper: what is claimed of them was found by `kahan discover`.
pub static FURTHER: [Entry; 7] = [
    weierstrass::ENTRY,
    volterra::ENTRY,
    volterra4::ENTRY,
    lagrange::ENTRY,
    henon_heiles::ENTRY,
    zhukovsky::ENTRY,
    lorenz::ENTRY,
];

/// The whole catalog: the systems of the paper, then the others.
pub fn all() -> impl Iterator<Item = &'static Entry> {
    SYSTEMS.iter().chain(&FURTHER)
}

/// The system with this command name or type name, in any case of letters.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    all().find(|entry| name.eq_ignore_ascii_case(entry.command) || name.eq_ignore_ascii_case(entry.type_name))
}
