//! Tests that blocks printed by `discover` compile unchanged, and that the library finds exactly
//! the claims in them.

use kahan_algebra::rational::Rational;
use kahan_algebra::{lexer, read};
use kahan_core::Named;
use kahan_discover::orbits::hilbert::default_degree;
use kahan_discover::{Options, Unwatched, discover};
use kahan_systems::entry::block_range;

mod dressing_chain;
mod euler;
mod lotka_volterra;
mod many_digits;
mod octahedral;
mod skew;
mod suslov;
mod toda;
mod triangular;
mod volterra;

fn parts(file: &str) -> (Vec<&str>, String) {
    let block = &file[block_range(file).expect("a block begins a line")];
    let is_claim =
        |line: &&str| ["integral ", "density ", "bracket "].iter().any(|word| line.starts_with(word));
    let lines = block.lines().map(str::trim);
    (
        lines.clone().filter(is_claim).collect(),
        lines.filter(|line| !is_claim(line)).collect::<Vec<_>>().join("\n"),
    )
}

/// Asserts that the claims found for a map are the claims written in the file.
fn check(map: &impl Named, file: &str, eps: Option<Rational>) {
    let (lines, equations) = parts(file);
    let system = read(&lexer::lex(&equations).tokens).system().expect("a system");
    assert_eq!(system.field.symbols.states, map.variables());
    // Fix the degree and use no clock, so that slow machines find the same claims.
    let degree = Some(default_degree(map.variables().len()));
    let options = Options { eps, degree, iterates: 6, iterate_degree: 50, ..Options::default() };
    let report = discover(&system, &options, &Unwatched).expect("there is a map");
    assert_eq!(report.integrals.len(), report.independent_integrals(), "{equations}");
    let formulas = report.integrals.iter().chain(&report.densities).map(|formula| formula.text.as_str());
    let brackets = report.brackets.iter().map(|bracket| bracket.text.as_str());
    let found: Vec<&str> = formulas.chain(brackets).collect();
    assert_eq!(found, lines, "{equations}");
}

#[test]
fn lines_found_today_are_those_that_compile() {
    check(
        &dressing_chain::DressingChain { a: 1.0, b: 1.0 },
        include_str!("discovered/dressing_chain.rs"),
        None,
    );
    check(&euler::Euler { a1: 1.0, a2: 1.0, a3: 1.0 }, include_str!("discovered/euler.rs"), None);
    check(&many_digits::ManyDigits, include_str!("discovered/many_digits.rs"), None);
    check(&octahedral::Octahedral, include_str!("discovered/octahedral.rs"), None);
    check(&skew::Skew, include_str!("discovered/skew.rs"), None);
    check(&suslov::Suslov { a: 1.0, b: 1.0 }, include_str!("discovered/suslov.rs"), None);
    check(&toda::Toda, include_str!("discovered/toda.rs"), None);
    check(&triangular::Triangular, include_str!("discovered/triangular.rs"), None);
    check(&volterra::Volterra, include_str!("discovered/volterra.rs"), None);
}

#[test]
fn lines_found_at_one_step_are_those_that_compile() {
    let file = include_str!("discovered/lotka_volterra.rs");
    check(&lotka_volterra::LotkaVolterra, file, Some(Rational::one()));
}
