//! The systems by name.

use crate::entry::Entry;
use crate::{e1, e2, e3, e4, e5, e6, e7, e8, e9, euler, lotka_volterra};

/// The catalog, in the order in which it is listed.
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

/// The system with this command name or type name, in any case of letters.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    SYSTEMS
        .iter()
        .find(|entry| name.eq_ignore_ascii_case(entry.command) || name.eq_ignore_ascii_case(entry.type_name))
}
