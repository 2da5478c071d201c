//! Tests that the front end never panics on random tokens, mutated blocks and large inputs.

use std::ops::Range;

use kahan_algebra::check::Checked;
use kahan_algebra::diagnostics::Kind;
use kahan_algebra::lexer::lex;
use kahan_algebra::parse::{parse_formula, parse_formulas};
use kahan_algebra::read;
use kahan_algebra::render::report;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed};

fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(0x_4b61_6861_6e20_2131),
        ..Config::default()
    }
}

fn read_text(text: &str) -> Checked {
    let lexed = lex(text);
    let reading = read(&lexed.tokens);
    let of_formulas = [parse_formula(&lexed.tokens).err(), parse_formulas(&lexed.tokens).err()];
    for diagnostic in reading.diagnostics().iter().chain(of_formulas.iter().flatten()) {
        assert!(!diagnostic.message.is_empty() && !diagnostic.help.is_empty(), "{diagnostic:?}");
        assert!(report(diagnostic, text, &lexed.ranges, "--field").contains(&diagnostic.message));
    }
    reading
}

/// Tokens of the language, and tokens that resemble them.
const WORDS: [&str; 68] = [
    "xdot",
    "ydot",
    "x",
    "y",
    "z",
    "mu",
    "eps",
    "ε",
    "ϵ",
    "dot",
    "in",
    "_",
    "pub",
    "struct",
    "enum",
    "E",
    "T",
    "const",
    "integral",
    "density",
    "bracket",
    "drift",
    "by",
    "when",
    "H",
    "rho",
    "0",
    "1",
    "2",
    "1/2",
    "0.1",
    "1.5e-3",
    "1e5000",
    "2x",
    "1f64",
    "0x1F",
    "64",
    "1000000000",
    "sin",
    "self",
    "if",
    "r#type",
    "+",
    "-",
    "*",
    "/",
    "^",
    "=",
    ";",
    ";",
    ",",
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    "<",
    ">",
    ".",
    "::",
    "**",
    "#",
    "'",
    "²",
    "3ε",
    "½",
    "\"text\"",
];

const VALID: [&str; 4] = [
    "pub struct E1; xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; integral H = y/x; \
     density rho = 1/(x*y*(x*z + y^2)); bracket P { {y,z} = y*(1 - eps^2*x^2); {z,x} = -x*(1 - eps^2*x^2); }",
    "struct E7 { xi } xdot = -x^2; ydot = -xi*x*y; zdot = 2*xi*y^2 + x*z; integral H = y/x when xi = 1;",
    "const c = 1/2; xdot = 1.5e-3*c*y/(1 + mu); ydot = -1.5e-3*c*x/(1 + mu); \
     integral H = (x^2 + y^2)^-1 when eps = 1, mu = c;",
    "#[derive(Debug)] pub(crate) struct Linear { a, b, } xdot = a*y + 1; ydot = -(b*x); bracket P { {x,y} = 1; };",
];

fn soup(length: Range<usize>) -> impl Strategy<Value = String> {
    proptest::collection::vec((0..WORDS.len(), any::<bool>()), length).prop_map(|words| {
        words.into_iter().map(|(word, apart)| WORDS[word].to_owned() + if apart { " " } else { "" }).collect()
    })
}

/// Generates a valid block in which some tokens are replaced, removed, doubled or swapped.
fn mutated() -> impl Strategy<Value = String> {
    let changes = proptest::collection::vec((any::<prop::sample::Index>(), 0..4u8, 0..WORDS.len()), 1..5);
    (0..VALID.len(), changes).prop_map(|(block, changes)| {
        let mut words: Vec<String> =
            lex(VALID[block]).tokens.into_iter().map(|token| token.text.into_owned()).collect();
        for (place, change, word) in changes {
            let length = words.len();
            let place = place.index(length);
            match change {
                0 => words[place] = WORDS[word].to_owned(),
                1 if length > 1 => drop(words.remove(place)),
                2 => words.insert(place, words[place].clone()),
                _ => words.swap(place, (place + 1) % length),
            }
        }
        words.join(" ")
    })
}

proptest! {
    #![proptest_config(config(3_000))]

    #[test]
    fn no_soup_of_tokens_makes_the_front_end_panic(text in soup(0..60)) {
        read_text(&text);
    }

    #[test]
    fn no_text_makes_the_front_end_panic(text in "\\PC{0,80}") {
        read_text(&text);
    }
}

proptest! {
    #![proptest_config(config(1_500))]

    #[test]
    fn no_mutation_of_a_block_makes_the_front_end_panic(text in mutated()) {
        read_text(&text);
    }
}

fn listed(count: usize, one: impl Fn(usize) -> String, between: &str) -> String {
    (0..count).map(one).collect::<Vec<_>>().join(between)
}

/// Generates blocks with independent sizes at, below and beyond the limits of the language.
fn large() -> impl Strategy<Value = String> {
    let size = |sizes: &'static [usize]| proptest::sample::select(sizes);
    (
        size(&[1, 9, 1_000, 10_000, 10_001]),
        size(&[0, 1, 9_000, 70_000]),
        size(&[0, 1, 500, 501]),
        size(&[1, 256, 257, 5_000]),
        size(&[1, 2, 64, 65, 1_000_000]),
        size(&[1, 2_000, 20_000]),
    )
        .prop_map(|(equations, parameters, claims, nesting, exponent, terms)| {
            let names = listed(parameters, |k| format!(" + a{k}"), "");
            let sum = listed(terms, |k| format!("{k}*x0*x{}", k % equations), " + ");
            let nested = format!("{}x0{}", "(".repeat(nesting), ")".repeat(nesting));
            let others = listed(equations, |k| format!("x{k}dot = x{};", (k + 1) % equations), " ");
            let claims = listed(claims, |k| format!("integral I{k} = x0^{exponent};"), " ");
            format!("ydot = {sum}{names} + {nested} + b^{exponent}; {others} {claims}")
        })
}

fn far() -> impl Strategy<Value = String> {
    let reach = proptest::sample::select(&[1_usize, 2, 16, 63, 64, 65][..]);
    let boundary = proptest::sample::select(&["open", "periodic"][..]);
    let force = proptest::sample::select(&["x", "c[i]*x", "k*x", "x[i]*x"][..]);
    (reach, boundary, force, 1..4_usize).prop_map(|(reach, boundary, force, terms)| {
        let pull =
            listed(terms, |k| format!("{force}[i+{0}] - {force}[i-{0}]", reach - k.min(reach - 1)), " + ");
        format!(
            "for i in {boundary} {{ x[i]dot = y[i]; y[i]dot = {pull}; }} integral S = sum(x[i] + y[i]); \
             hamiltonian H = sum(y[i]^2/2 - x[i]*x[i+{reach}]);"
        )
    })
}

proptest! {
    #![proptest_config(config(20))]

    #[test]
    fn no_long_soup_of_tokens_makes_the_front_end_panic(text in soup(2_000..20_000)) {
        read_text(&text);
    }

    #[test]
    fn no_block_at_a_limit_makes_the_front_end_panic(text in large()) {
        read_text(&text);
    }

    #[test]
    fn no_family_of_any_reach_makes_the_front_end_panic(text in far()) {
        read_text(&text);
    }
}

#[test]
fn the_blocks_that_are_mutated_are_valid() {
    for text in VALID {
        let reading = read_text(text);
        let diagnostics = reading.diagnostics();
        assert!(diagnostics.is_empty(), "{text}: {diagnostics:?}");
    }
}

fn only_mistake(text: &str) -> Kind {
    let reading = read_text(text);
    let diagnostics = reading.diagnostics();
    assert_eq!(diagnostics.len(), 1, "{:?}", diagnostics.iter().map(|d| &d.message).collect::<Vec<_>>());
    diagnostics[0].kind
}

#[test]
fn enormous_powers_are_refused_before_they_are_expanded() {
    assert_eq!(only_mistake("xdot = x^1000000000;"), Kind::Degree);
    assert_eq!(only_mistake("xdot = (x + y + z)^5000; ydot = x; zdot = y;"), Kind::Degree);
    assert_eq!(only_mistake("xdot = (1 + a + b + c)^64*x + 2^65536;"), Kind::TooLarge);
    assert_eq!(only_mistake("xdot = 9^1000000000*x;"), Kind::TooLarge);
    assert_eq!(only_mistake("xdot = x; integral H = x^1000000000;"), Kind::Exponent);
    assert_eq!(only_mistake("xdot = 1e4097*x;"), Kind::TooLarge);
    assert_eq!(only_mistake("xdot = x^99999999999999999999999999;"), Kind::Degree);
}

#[test]
fn deep_nesting_is_refused_before_it_overflows_the_stack() {
    for depth in [257, 5_000, 200_000] {
        let parentheses = format!("xdot = {}x{};", "(".repeat(depth), ")".repeat(depth));
        assert_eq!(only_mistake(&parentheses), Kind::TooLarge);
        assert_eq!(only_mistake(&format!("xdot = {}x;", "-".repeat(depth))), Kind::TooLarge);
        let claim = format!("xdot = x; integral H = {}x{};", "(".repeat(depth), ")".repeat(depth));
        assert_eq!(only_mistake(&claim), Kind::TooLarge);
    }
    let allowed = format!("xdot = {}x{};", "(".repeat(256), ")".repeat(256));
    assert!(read_text(&allowed).diagnostics().is_empty());
}

fn long_sum() -> String {
    let states: Vec<String> = (0..40).map(|i| format!("x{i}")).collect();
    let terms = (0..20_000).map(|k| {
        let pair = k % 1_600;
        format!("{}*{}*a^{}", states[pair / 40], states[pair % 40], k / 1_600)
    });
    terms.collect::<Vec<_>>().join(" + ")
}

#[test]
fn a_sum_of_twenty_thousand_terms_is_read() {
    let others: String = (1..40).map(|i| format!("x{i}dot = 0;")).collect();
    let reading = read_text(&format!("x0dot = {}; {others}", long_sum()));
    assert!(reading.diagnostics().is_empty());
    // Of the products xᵢxⱼ of 40 variables, 820 are different, because xᵢxⱼ = xⱼxᵢ.
    let terms = reading.system().expect("a system").field.components[0].numerator().len();
    assert!((10_000..=20_000).contains(&terms), "{terms}");
}

#[test]
fn a_claim_of_twenty_thousand_terms_is_proved() {
    // Every function is an integral of ẋ = 0, ẏ = 0, so the long claim is true.
    let terms: Vec<String> = (1..=20_000).map(|k| format!("{k}*x^{}*y^{}", k % 50, k / 50 % 50)).collect();
    let text = format!("xdot = 0; ydot = 0; integral H = {};", terms.join(" + "));
    assert!(read_text(&text).diagnostics().is_empty());
    let text = format!("xdot = y; ydot = 0; integral H = {};", terms.join(" + "));
    assert_eq!(only_mistake(&text), Kind::FalseClaim);
}
