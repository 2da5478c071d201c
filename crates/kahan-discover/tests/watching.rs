//! Tests that a watch is told all claims, can end a search, and needs no clock.

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_discover::orbits::hilbert::default_degree;
use kahan_discover::{Options, Report, ScannedQuantity, Unwatched, Watch, discover, poles, scan};

mod support;
use support::*;

fn report(text: &str, watch: &dyn Watch) -> Report {
    let degree = Some(default_degree(system(text).field.dimension()));
    let options = Options { degree, iterates: 6, iterate_degree: 50, seconds: 3600.0, ..Options::default() };
    discover(&system(text), &options, watch).expect("there is a map")
}

#[test]
fn a_watch_hears_of_each_claim_of_the_report_once_and_of_each_stage() {
    for text in [E4, EULER, LAGRANGE, VOLTERRA, LOTKA_VOLTERRA] {
        let watch = Recording::default();
        let report = report(text, &watch);
        let findings = watch.findings();
        let mut told: Vec<&str> = findings.iter().map(|finding| finding.text.as_str()).collect();
        let mut said = claims(&report);
        told.sort_unstable();
        said.sort_unstable();
        assert_eq!(told, said, "{text}");
        for finding in &findings {
            let begins = format!("{} {} ", finding.kind.keyword(), finding.name);
            assert!(finding.text.starts_with(&begins), "{finding:?}");
        }
        let mut stages = watch.looks();
        stages.dedup();
        let all = [
            "linear and quadratic integrals of the flow",
            "degrees of iterates",
            "relations on orbits",
            "structure of the field",
            "formulas of integrals",
            "invariant Poisson brackets",
            "invariant densities",
            "what survives composition",
            "functions whose next value follows from their value",
        ];
        assert_eq!(stages, all, "{text}");
        assert_eq!(watch.looks().len(), all.len() + findings.len(), "{text}");
    }
}

#[test]
fn a_watch_that_ends_a_search_at_its_first_finding_finds_that_in_the_report() {
    for watch in [Recording::default(), Recording::with_a_clock()] {
        let watch = watch.ending_after(1);
        let (all, first) = (report(E4, &Unwatched), report(E4, &watch));
        let findings = watch.findings();
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].kind, ClaimKind::Integral);
        assert_eq!(claims(&first)[0], findings[0].text);
        assert!(first.out_of_time && claims(&first).len() < claims(&all).len());
        assert_eq!(watch.looks().last().map(String::as_str), Some("formulas of integrals"));
    }
}

#[test]
fn to_end_work_is_to_take_its_time_away() {
    let found = |seconds: f64, watch: &dyn Fn() -> Recording| {
        let options = &Options { seconds, ..Options::default() };
        let values = vec![Rational::zero(), Rational::one()];
        let axis = ScannedQuantity { name: "xi".to_owned(), values };
        [
            format!("{:?}", discover(&system(E4), options, &watch())),
            format!("{:?}", poles(&system(WEIERSTRASS), options, 8, &watch())),
            format!("{:?}", scan(&system(E7), &[axis], options, &watch())),
        ]
    };
    let ended = found(3600.0, &|| Recording::default().ending_after(0));
    let without = found(0.0, &Recording::with_a_clock);
    assert_eq!(ended, without);
    assert!(ended[0].contains("out_of_time: true") && ended[2].contains("points: []"));
}

#[test]
fn without_a_clock_a_report_is_that_of_enough_time() {
    for text in [E4, LOTKA_VOLTERRA, LAGRANGE] {
        let [without, with] = [&Recording::default(), &Recording::with_a_clock()]
            .map(|watch| format!("{:?}", report(text, watch)));
        assert_eq!(without, with, "{text}");
    }
    let found = poles(&system(WEIERSTRASS), &Options { seconds: 0.0, ..Options::default() }, 8, &Unwatched);
    assert!(found.expect("there is a map").implied_degrees.is_some());
}
