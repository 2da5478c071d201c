//! Makes reports of fields, and checks what must hold for all of them.

use kahan_algebra::{lexer, read};
use kahan_discover::orbits::hilbert::default_degree;
use kahan_discover::{Options, Report, discover};

use super::{Recording, claims, system};

pub(crate) fn options() -> Options {
    Options { iterates: 8, iterate_degree: 100, seconds: 3600.0, ..Options::default() }
}

/// Searches up to the degree in `options`, or else up to the default degree.
pub(crate) fn report(text: &str, options: &Options) -> Report {
    let usual = default_degree(system(text).field.dimension());
    searched(text, &Options { degree: options.degree.or(Some(usual)), ..options.clone() })
}

/// Searches up to the degree in `options`. Without one, the search may continue to any degree.
pub(crate) fn searched(text: &str, options: &Options) -> Report {
    let watch = Recording::with_a_clock();
    let report = discover(&system(text), options, &watch).expect("there is a map");
    let told: Vec<String> = watch.findings().into_iter().map(|finding| finding.text).collect();
    assert!(claims(&report).iter().all(|claim| told.iter().any(|told| told == claim)), "{text}: {told:?}");
    assert_eq!(told.len(), claims(&report).len(), "{text}: {told:?}");
    report
}

pub(crate) fn check_lines(text: &str, report: &Report) {
    let block = format!("{text} {}", claims(report).join(" "));
    let reading = read(&lexer::lex(&block).tokens);
    assert!(reading.diagnostics().is_empty(), "{block}: {:?}", reading.diagnostics());
}

/// Reports on a field, and asserts the degrees of its integrals and of its density, if any.
pub(crate) fn check(text: &str, integrals: &[u32], density: Option<u32>) -> Report {
    check_with(text, &options(), integrals, density)
}

pub(crate) fn check_with(text: &str, options: &Options, integrals: &[u32], density: Option<u32>) -> Report {
    let report = report(text, options);
    assert_eq!(report.independent_integrals(), integrals.len(), "{text}");
    let mut degrees: Vec<u32> = report.integrals.iter().map(|formula| formula.degree).collect();
    degrees.sort_unstable();
    assert_eq!(degrees, integrals, "{text}");
    assert_eq!(report.densities.first().map(|formula| formula.degree), density, "{text}");
    check_lines(text, &report);
    report
}
