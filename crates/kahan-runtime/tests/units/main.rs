//! If the units of length and time change by powers of two, results change by exact powers of two.
//!
//! Twenty fields run in units of length from 2⁻³⁰⁰ to 2³⁰⁰ (for `f32` from 2⁻⁴⁰ to 2⁴⁰). Units of
//! time are such that ε stays between 2⁻⁶³ and 2⁶³.

mod answers;
mod chains;
mod cycles;
mod fields;
mod points;
mod slices;

use fields::Unit;

const fn units<const K: usize>(lengths_and_times: [[i32; 2]; K]) -> [Unit; K] {
    let mut units = [fields::ORDINARY; K];
    let mut k = 0;
    while k < K {
        let [length, time] = lengths_and_times[k];
        units[k] = Unit { length, time };
        k += 1;
    }
    units
}

const UNITS: [Unit; 5] = units([[300, 0], [-300, 0], [0, 56], [0, -59], [-111, 17]]);
const SHORT_UNITS: [Unit; 5] = units([[40, 0], [-40, 0], [0, 8], [0, -8], [-11, 5]]);
