//! Draws chains and fields of many variables that `kahan extremes` does not draw.

use crate::random_fields::odd::{Draw, OddField, plain};

pub(super) struct Drawn {
    /// The field or chain. Parameters of a whole chain come before those of its sites.
    pub(super) field: OddField,
    pub(super) of_sites: usize,
    /// The number of variables of a field, or of variables at each site of a chain.
    pub(super) variables: usize,
    pub(super) sites: Option<usize>,
}

pub(super) fn odd(seed: u64, number: usize) -> Drawn {
    let field = crate::random_fields::odd::odd(seed, number);
    Drawn { field, of_sites: 0, variables: 1 + number % 8, sites: None }
}

pub(super) fn odd_of_many(seed: u64, number: usize) -> Drawn {
    let variables = 9 + number * 5 % 32;
    Drawn { field: plain(seed, number, "Many", variables), of_sites: 0, variables, sites: None }
}

/// Draws the chain with this number, periodic or open, with one to three variables at each site.
pub(super) fn odd_chain(seed: u64, number: usize) -> Drawn {
    let mut draw = Draw::new(seed, "Chain", number);
    let (arrays, reach) = (1 + number % 3, 1 + draw.below(2) as i64);
    // Every 25th chain has more than five hundred sites.
    let sites = if number % 25 == 24 { 520 + draw.below(300) } else { 1 + draw.below(36 / arrays) };
    draw.states = (0..arrays).map(|k| ["x", "y", "z"][k].to_owned()).collect();
    draw.offsets = reach;
    draw.take_parameters();
    let parameters = draw.parameters.clone();
    // The first parameter has a single value, and the others have a value for each site.
    draw.parameters.iter_mut().skip(1).for_each(|name| name.push_str("[i]"));
    let names = draw.states.clone();
    let equations: Vec<String> = names.iter().map(|name| format!("{name}[i]dot = {};", draw.sum())).collect();
    let boundary = if (number / 3).is_multiple_of(2) { "periodic" } else { "open" };
    let equations = format!("for i in {boundary} {{ {} }}", equations.join(" "));
    let words: Vec<&str> = equations.split(|c: char| !c.is_ascii_alphanumeric()).collect();
    let used = |names: &[String]| -> Vec<String> {
        names.iter().filter(|name| words.contains(&&***name)).cloned().collect()
    };
    let (of_sites, parameters) = (used(&parameters[parameters.len().min(1)..]).len(), used(&parameters));
    let field = OddField { name: format!("Chain{number}"), equations, parameters };
    Drawn { field, of_sites, variables: arrays, sites: Some(sites) }
}
