//! Compares families with chains that are written out by hand, and tests true and false claims.

use std::fmt::Write as _;

use kahan_syntax::lexer::lex;
use kahan_syntax::syntax::Reference;

use crate::check::Checked;
use crate::prime_field::SplitMix64;
use crate::read;

use super::conserved::cancels;
use super::everywhere::{MiddleSite, budget};
use super::hamiltonian::find_unmatched_term;

/// A coefficient and factors. A factor is an array name with an offset.
type Term = (i64, Vec<(&'static str, i64)>);

struct Random {
    is_open: bool,
    arrays: Vec<(&'static str, Vec<Term>)>,
}

impl Random {
    fn new(random: &mut SplitMix64) -> Self {
        let mut below = |n: u64| (random.next_u64() % n) as i64;
        let names = &["x", "y", "z"][..1 + below(3) as usize];
        let mut term = |is_open: bool| {
            let mut factors = Vec::new();
            for _ in 0..=below(2) {
                factors.push((names[below(names.len() as u64) as usize], below(7) - 3));
            }
            match below(3) {
                0 => factors.push(("c", if is_open { 0 } else { below(5) - 2 })),
                1 => factors.push(("mu", i64::MAX)),
                _ => {}
            }
            (below(9) - 4, factors)
        };
        let is_open = term(false).0 > 0;
        let arrays = names.iter().map(|name| (*name, (0..4).map(|_| term(is_open)).collect())).collect();
        Random { is_open, arrays }
    }

    fn text(&self) -> String {
        let boundary = if self.is_open { "open" } else { "periodic" };
        let equations: String = self
            .arrays
            .iter()
            .map(|(array, terms)| {
                let name = |name: &str, offset: i64| {
                    if offset == i64::MAX {
                        name.to_owned()
                    } else {
                        Reference::Site { array: name, offset }.to_string()
                    }
                };
                format!(
                    "{array}[i]dot = {};",
                    sum(terms.iter().map(|(coefficient, factors)| {
                        (*coefficient, factors.iter().map(|(base, offset)| name(base, *offset)).collect())
                    }))
                )
            })
            .collect();
        format!("for i in {boundary} {{ {equations} }}")
    }

    fn chain(&self, sites: i64) -> String {
        let mut text = String::new();
        for site in 0..sites {
            for (array, terms) in &self.arrays {
                let terms = terms.iter().filter_map(|(coefficient, factors)| {
                    let mut names = Vec::new();
                    for (base, offset) in factors {
                        if *offset == i64::MAX {
                            names.push((*base).to_owned());
                            continue;
                        }
                        let place = site + offset;
                        if self.is_open && !(0..sites).contains(&place) {
                            return None;
                        }
                        names.push(format!("{base}{}", place.rem_euclid(sites)));
                    }
                    Some((*coefficient, names))
                });
                let _ = write!(text, "{array}{site}dot = {};", sum(terms));
            }
        }
        text
    }
}

fn sum(terms: impl Iterator<Item = (i64, Vec<String>)>) -> String {
    let terms = terms.map(|(coefficient, names)| format!("({coefficient})*{}", names.join("*")));
    let text = terms.collect::<Vec<_>>().join(" + ");
    if text.is_empty() { "0".to_owned() } else { text }
}

fn reading(text: &str) -> Checked {
    read(&lex(text).tokens)
}

#[test]
fn a_chain_too_short_for_its_divisors_is_none() {
    let text = "struct F { c } for i in periodic { x[i]dot = x[i]*x[i+1]/(c[i] - c[i+1]); }";
    let family = reading(text).family().expect("no mistake").expect("a family");
    assert!(family.at_sites(1).is_none());
    assert!(family.at_sites(2).is_some());
}

#[test]
fn random_families_are_the_chains_that_one_writes_out() {
    let mut random = SplitMix64::new(18);
    for _ in 0..60 {
        let family = Random::new(&mut random);
        let checked = reading(&family.text()).family();
        let checked = checked.unwrap_or_else(|mistakes| panic!("{}: {mistakes:?}", family.text()));
        let checked = checked.expect("a family");
        for sites in 1..=8 {
            let system = checked.at_sites(sites as usize).expect("no site divides by zero");
            let plain = reading(&family.chain(sites)).system().expect("a system");
            let names = |system: &crate::system::System| {
                let symbols = system.field.symbols.clone();
                let component = |component: &crate::rational_function::RationalFunction| {
                    let mut terms: Vec<String> = component
                        .numerator()
                        .terms()
                        .map(|(monomial, coefficient)| {
                            let mut factors: Vec<String> = monomial
                                .powers()
                                .iter()
                                .map(|(variable, power)| format!("{}^{power}", symbols.name(*variable)))
                                .collect();
                            factors.sort();
                            format!("{coefficient} {}", factors.join(" "))
                        })
                        .collect();
                    terms.sort();
                    terms
                };
                (symbols.states.clone(), system.field.components.iter().map(component).collect::<Vec<_>>())
            };
            assert_eq!(names(&system), names(&plain), "{} at {sites}", family.text());
        }
    }
}

fn holds(text: &str) -> bool {
    let reading = reading(text);
    let false_claims = reading.diagnostics().len();
    assert!(
        reading
            .diagnostics()
            .iter()
            .all(|mistake| mistake.kind == kahan_syntax::diagnostics::Kind::FalseClaim),
        "{text}: {:?}",
        reading.diagnostics()
    );
    false_claims == 0
}

#[test]
fn sums_that_telescope_are_kept_and_others_are_not() {
    for (flux, before, ends) in [
        ("x[i]*x[i+1]", "x[i-1]*x[i]", true),
        ("x[i]^2", "x[i-1]^2", false),
        ("3*x[i]*x[i+2] + x[i]", "3*x[i-1]*x[i+1] + x[i-1]", false),
        ("c[i]*x[i]*x[i+1]", "c[i-1]*x[i-1]*x[i]", true),
    ] {
        let family = |boundary: &str, more: &str| {
            format!("for i in {boundary} {{ x[i]dot = {flux} - ({before}){more}; }} integral S = sum(x[i]);")
        };
        assert!(holds(&family("periodic", "")), "{flux}");
        assert_eq!(holds(&family("open", "")), ends, "{flux}");
        for boundary in ["periodic", "open"] {
            assert!(!holds(&family(boundary, " + 1/7*x[i]*x[i+1]")), "{flux}");
            assert!(!holds(&family(boundary, " - 1/1000")), "{flux}");
        }
    }
    assert!(holds(
        "for i in periodic { a[i]dot = b[i+1] - a[i]*b[i]; b[i]dot = a[i]*b[i] - b[i]; } integral S = sum(a[i] + b[i]);"
    ));
    assert!(!holds(
        "for i in open { a[i]dot = b[i+1] - a[i]*b[i]; b[i]dot = a[i]*b[i] - b[i]; } integral S = sum(a[i] + b[i]);"
    ));
    assert!(holds("for i in periodic { x[i]dot = x[i+1]/c[i+1] - x[i]/c[i]; } integral S = sum(x[i]);"));
}

#[test]
fn constant_stencils_are_found_where_they_are() {
    let periodic = |gradient: fn(&str) -> String, density: &str, more: &str| {
        let [before, after] = ["-1", "+1"].map(gradient);
        format!(
            "for i in periodic {{ x[i]dot = k*(({after}) - ({before})){more}; }} hamiltonian H = sum({density});"
        )
    };
    let gradient = |s: &str| {
        let at = |more: i64| {
            let offset: i64 = s.parse::<i64>().unwrap() + more;
            Reference::Site { array: "x", offset }.to_string()
        };
        format!("2*{0}*{1} + {2}^2", at(0), at(1), at(-1))
    };
    assert!(holds(&periodic(gradient, "x[i]^2*x[i+1]", "")));
    assert!(!holds(&periodic(gradient, "x[i]^2*x[i+1]", " + x[i]")));
    assert!(!holds(&periodic(gradient, "x[i]^2*x[i+1] + x[i]", " + x[i]*x[i+1]")));
    assert!(holds("for i in open { x[i]dot = x[i+1]^2 - x[i-1]^2; } hamiltonian H = sum(x[i]^3);"));
    assert!(!holds(
        "for i in open { x[i]dot = x[i+1]^2 - x[i-1]^2 + 1; } hamiltonian H = sum(x[i]^3 + x[i]);"
    ));
    let oscillators = |boundary: &str, force: &str| {
        format!(
            "for i in {boundary} {{ q[i]dot = p[i]/m; p[i]dot = {force}; }} \
             hamiltonian H = sum(p[i]^2/(2*m) + k/2*(q[i+1] - q[i])^2 + (q[i+1] - q[i])^3/3);"
        )
    };
    let force = "k*(q[i+1] - 2*q[i] + q[i-1]) + (q[i+1] - q[i])^2 - (q[i] - q[i-1])^2";
    assert!(holds(&oscillators("periodic", force)));
    // Here H lacks the energy of the spring from the first site to the left wall.
    assert!(!holds(&oscillators("open", force)));
    assert!(!holds(&oscillators("periodic", &force.replace("2*q[i]", "3*q[i]"))));
}

fn work(text: &str) -> u64 {
    let tokens = lex(text).tokens;
    let family = crate::read_unproved(&tokens).family().unwrap_or_else(|why| panic!("{text}: {why:?}"));
    let family = family.expect("a family");
    let mut budget = budget();
    let before = budget.work_left();
    let middle = MiddleSite::of(&family);
    match (&family.hamiltonian, &*family.integrals) {
        (Some(energy), []) => {
            assert!(find_unmatched_term(&middle, energy, &mut budget).expect("within").is_none(), "{text}");
        }
        (None, [sum]) => assert!(cancels(&middle, sum, &mut budget).expect("within"), "{text}"),
        _ => panic!("one claim"),
    }
    before - budget.work_left()
}

#[test]
fn proofs_grow_with_the_terms_that_meet_and_not_with_the_chains() {
    for boundary in ["open", "periodic"] {
        let energy = |reach: usize| {
            work(&format!(
                "for i in {boundary} {{ x[i]dot = y[i+{reach}]; y[i]dot = -x[i-{reach}]; }} \
                 hamiltonian H = sum(x[i]^2/2 + y[i]^2/2);"
            ))
        };
        let sum = |reach: usize| {
            work(&format!(
                "for i in {boundary} {{ x[i]dot = x[i]*(x[i+{reach}] - x[i-{reach}]); }} integral S = sum(x[i]);"
            ))
        };
        assert!(energy(64) < 16 * energy(4), "{} {}", energy(4), energy(64));
        assert_eq!(sum(1), sum(64));
    }
}

#[test]
fn claims_beyond_the_budget_are_refused() {
    let states = |sign: &str| (1..=64).map(|k| format!("x[i{sign}{k}]")).collect::<Vec<_>>().join(" + ");
    let all = format!("({} + {})", states("+"), states("-"));
    for claim in [format!("hamiltonian H = sum({all}^2);"), format!("integral S = sum({all});")] {
        let text = format!("for i in periodic {{ x[i]dot = {all}^2; }} {claim}");
        let reading = reading(&text);
        let kinds: Vec<_> = reading.diagnostics().iter().map(|mistake| mistake.kind).collect();
        assert_eq!(kinds, [kahan_syntax::diagnostics::Kind::TooLarge], "{claim}");
    }
}

#[test]
fn what_holds_far_from_the_ends_may_fail_near_them_at_any_reach() {
    for reach in [1, 3, 16] {
        let family = |x: &str, y: &str| {
            format!(
                "for i in open {{ x[i]dot = {x}; y[i]dot = {y}; }} \
                 hamiltonian H = sum((x[i+{reach}] - x[i])^2/2 + y[i]^2/2);"
            )
        };
        let middle = format!("x[i+{reach}] - 2*x[i] + x[i-{reach}]");
        assert!(!holds(&family("y[i]", &middle)));
        assert!(!holds(&family("y[i]", &format!("{middle} + x[i]"))));
    }
    for reach in [1, 3, 16] {
        assert!(holds(&format!(
            "for i in open {{ x[i]dot = y[i]; y[i]dot = x[i+{reach}] + x[i-{reach}]; }} \
             hamiltonian H = sum(y[i]^2/2 - x[i]*x[i+{reach}]);"
        )));
        assert!(holds(&format!(
            "for i in open {{ x[i]dot = c[i]*x[i+{reach}]; y[i]dot = -c[i]*x[i+{reach}]; }} integral S = sum(x[i] + y[i]);"
        )));
        assert!(!holds(&format!(
            "for i in open {{ x[i]dot = x[i+{reach}] - x[i]; }} integral S = sum(x[i]);"
        )));
    }
}
