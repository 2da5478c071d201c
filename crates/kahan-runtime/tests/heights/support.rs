//! Systems and numbers read from text.

use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::read;
use kahan_algebra::system::System;
use kahan_runtime::heights::HeightsOrbit;
use kahan_systems::registry::find;

pub(crate) fn number(text: &str) -> Rational {
    Rational::parse(text).unwrap_or_else(|| panic!("{text} is no number"))
}

pub(crate) fn numbers(text: &str) -> Vec<Rational> {
    text.split(',').filter(|part| !part.is_empty()).map(number).collect()
}

pub(crate) fn field(text: &str) -> System {
    let reading = read(&lex(text).tokens);
    assert!(reading.diagnostics().is_empty(), "{text}: {:?}", reading.diagnostics());
    reading.system().expect("a system")
}

pub(crate) fn catalog(name: &str) -> System {
    field(find(name).unwrap_or_else(|| panic!("no system {name}")).text())
}

pub(crate) fn orbit(system: &System, parameters: &str, eps: &str, start: &str) -> HeightsOrbit {
    HeightsOrbit::new(system, &numbers(parameters), &number(eps), &numbers(start)).expect("a defined field")
}
