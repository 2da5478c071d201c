//! Compares limits in the language reference with the code.

use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::elimination::{too_many_couplings, too_many_parameters};
use kahan_algebra::lenient;
use kahan_algebra::lexer::lex;
use kahan_algebra::token::Span;
use kahan_algebra::{read, read_unproved};

const REFERENCE: &str = include_str!("../../../kahan-core/docs/language.md");

fn table(heading: &str) -> Vec<(&'static str, usize)> {
    let (_, section) = REFERENCE.split_once(heading).expect("the section");
    let rows = section.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
    let rows = rows.take_while(|line| line.starts_with('|')).map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [what, limit] = cells[..] else { panic!("two cells: {row}") };
        (what, limit.replace(' ', "").parse().expect("a number"))
    });
    rows.collect()
}

fn mistakes(text: &str) -> Vec<Diagnostic> {
    read(&lenient::read(text).lexed.tokens).diagnostics().to_vec()
}

fn listed(count: usize, one: impl Fn(usize) -> String, between: &str) -> String {
    (0..count).map(one).collect::<Vec<_>>().join(between)
}

enum Tied {
    /// Makes a block of size n. At the limit, the block must be accepted, and for the next larger n
    /// it must be refused.
    AtTheLimit(fn(usize) -> String),
    /// A block far beyond the limit. The error message must state the limit.
    InWords(String),
}
use Tied::{AtTheLimit, InWords};

fn coupled(variables: usize, couplings: usize) -> String {
    let row = |k: usize| {
        let own = couplings.saturating_sub(k * variables).min(variables);
        format!("x{k}dot = 0{};", listed(own, |j| format!(" + x{j}"), ""))
    };
    listed(variables, row, " ")
}

fn compiles(text: &str) -> bool {
    let system = read_unproved(&lex(text).tokens).system().expect("a system");
    too_many_couplings(&system.field, Span::token(0)).is_none()
}

#[test]
fn every_limit_of_the_language_is_that_of_its_table() {
    let neighbours = |sign: &str| listed(64, |k| format!("x[i{sign}{}]", k + 1), " + ");
    let wide = format!("({} + {})", neighbours("+"), neighbours("-"));
    let limits: [(&str, Tied); 15] = [
        ("equations of a block", AtTheLimit(|n| listed(n, |k| format!("x{k}dot = 0;"), " "))),
        ("names", AtTheLimit(|n| format!("xdot = 0{};", listed(n - 1, |k| format!(" + a{k}"), "")))),
        (
            "claims",
            AtTheLimit(|n| format!("xdot = 0; {}", listed(n, |k| format!("integral I{k} = x;"), " "))),
        ),
        (
            "tokens that quantities add to a text",
            AtTheLimit(|n| {
                let (thousands, ones) = (vec!["q"; n / 1000].join(" + "), " + s".repeat(n % 1000));
                let single = if ones.is_empty() { "" } else { "s = x\n" };
                format!("q = -x{}\n{single}x' = {thousands}{ones}", " + x".repeat(499))
            }),
        ),
        ("offsets of neighbours", AtTheLimit(|n| format!("for i in open {{ x[i]dot = x[i+{n}]; }}"))),
        ("levels of parentheses", AtTheLimit(|n| format!("xdot = {}x{};", "(".repeat(n), ")".repeat(n)))),
        (
            "exponents of parameters, expanded",
            AtTheLimit(|n| format!("xdot = a^{n}; ydot = a^{n}; integral I = (x - y)^{n};")),
        ),
        ("decimal exponents", AtTheLimit(|n| format!("xdot = 1e{n}*x;"))),
        ("digits of a number", AtTheLimit(|n| format!("xdot = {}*x;", "1".repeat(n)))),
        // The limit counts 2n bits for the n-th power of 3, because 3 has two bits.
        ("bits of the power of a number", AtTheLimit(|n| format!("xdot = 3^{}*x;", n.div_ceil(2)))),
        (
            "terms of an expansion",
            AtTheLimit(|n| format!("xdot = {};", listed(n, |k| format!("a{}*b{}", k % 317, k / 317), " + "))),
        ),
        (
            "products of terms in an expansion",
            AtTheLimit(|n| format!("xdot = {};", vec!["a*a"; n].join(" + "))),
        ),
        (
            "products of terms in all expansions of a block",
            InWords(listed(500, |k| format!("x{k}dot = (1 + a + b + c)^30*x{k};"), " ")),
        ),
        (
            "products of terms to prove a claim of a family",
            InWords(format!("for i in periodic {{ x[i]dot = {wide}^2; }} hamiltonian H = sum({wide}^2);")),
        ),
        (
            "operations at a point to prove the claims of a block",
            InWords(format!(
                "{} {}",
                listed(200, |k| format!("x{k}dot = 0;"), " "),
                listed(4, |k| format!("integral I{k} = x0;"), " ")
            )),
        ),
    ];
    let mut rows = table("\n## Limits\n");
    let mut limit = |what: &str| {
        let is_it = |row: &(&str, usize)| row.0.split([':', ',']).next() == what.split([':', ',']).next();
        rows.remove(rows.iter().position(is_it).unwrap_or_else(|| panic!("no row `{what}`"))).1
    };
    for (what, tied) in limits {
        let limit = limit(what);
        match tied {
            AtTheLimit(block) => {
                assert_eq!(mistakes(&block(limit)), [], "{what}: {limit}");
                let beyond = mistakes(&block(limit + 1));
                assert!(!beyond.is_empty(), "{what}: {limit}");
                let kinds = [Kind::TooLarge, Kind::Exponent, Kind::Syntax];
                assert!(beyond.iter().all(|mistake| kinds.contains(&mistake.kind)), "{what}: {beyond:?}");
            }
            InWords(block) => {
                let [mistake] = &mistakes(&block)[..] else { panic!("{what}: one mistake") };
                assert_eq!(mistake.kind, Kind::TooLarge, "{what}");
                assert!(mistake.message.contains(&format!(" {limit} ")), "{what}: {}", mistake.message);
            }
        }
    }

    let variables = limit("variables of a block that is compiled");
    assert!(compiles(&coupled(variables, variables)) && !compiles(&coupled(variables + 1, variables)));
    let parameters = limit("parameters of a block that is compiled");
    let has_too_many = |count| too_many_parameters(count, Span::token(0)).is_some();
    assert!(!has_too_many(parameters) && has_too_many(parameters + 1));
    let couplings = limit("couplings of a block that is compiled");
    assert!(compiles(&coupled(100, couplings)) && !compiles(&coupled(100, couplings + 1)));
    let degree = limit("degree of a claim with its map put in");
    let beyond = mistakes("xdot = x^2; integral I = (((x^64)^64)^64)^64;");
    assert!(beyond[0].message.ends_with(&format!(" {degree}")), "{beyond:?}");
    let told = limit("mistakes that are told");
    assert_eq!(mistakes(&listed(told + 50, |k| format!("x{k}dot = ;"), " ")).len(), told);
    assert_eq!(rows, [], "these rows have no test");
}

/// All expressions of a block share one budget of work. Long numbers use more of it.
#[test]
fn many_large_expansions_are_one_mistake() {
    let only = |text: &str| {
        let mistakes = mistakes(text);
        assert_eq!(mistakes.len(), 1, "{mistakes:?}");
        mistakes[0].kind
    };
    let constants = listed(3_000, |k| format!("const c{} = 3/7*c{k} + 1/{};", k + 1, k + 2), " ");
    assert_eq!(only(&format!("const c0 = 5; {constants} xdot = c3000*x;")), Kind::TooLarge);
    // The least common multiple of 1 to 20 000 has 28 860 bits.
    let sum = |count: usize| listed(count, |k| format!("x/{}", k + 1), " + ");
    assert_eq!(mistakes(&format!("xdot = {};", sum(500))), []);
    assert_eq!(only(&format!("xdot = {};", sum(20_000))), Kind::TooLarge);
    let numbers = listed(20_000, |k| format!("1/{}", k + 1), " + ");
    assert_eq!(only(&format!("xdot = x*({numbers});")), Kind::TooLarge);
}

#[test]
fn a_claim_that_the_budget_of_the_block_does_not_reach_says_so() {
    // The 11 equations need 11 · 170 000 multiplications of terms. The budget is 2 000 000.
    let power = "(1 + a + b + c)^30";
    let equations = |array: &str| listed(11, |k| format!("x{k}{array}dot = {power}*x{k}{array};"), " ");
    let system = |claims: &str| format!("{} ydot = d*x0; {claims}", equations(""));
    let family = |claims: &str| format!("for i in periodic {{ {} }} {claims}", equations("[i]"));
    let condition = format!("integral I = x0 when d = {power}; integral J = x1 when d = {power};");
    let sums = format!("integral S = sum({power}*x0[i]); hamiltonian H = sum({power}*x1[i]);");
    assert_eq!(mistakes(&system("")), []);
    assert_eq!(mistakes(&family("")), []);
    for block in [system(&condition), family(&sums)] {
        let [mistake] = &mistakes(&block)[..] else { panic!("one mistake: {block}") };
        assert!(mistake.message.contains(" 2000000 products "), "{mistake:?}");
    }
}

/// The limit applies to exponents after expansion.
#[test]
fn exponents_of_parameters_count_after_expansion() {
    for equation in ["a^40*a^24*x", "(a^8)^8*x", "a^64*a^36/a^40*x"] {
        assert_eq!(mistakes(&format!("xdot = {equation}; ydot = x;")), [], "{equation}");
    }
    for equation in ["a^40*a^25*x", "(a^8)^9*x", "(a*b)^64*b*x", "x/(a^64*a)", "(x*a)*a^64"] {
        let [mistake] = &mistakes(&format!("xdot = {equation}; ydot = x;"))[..] else { panic!("{equation}") };
        assert_eq!(mistake.kind, Kind::TooLarge, "{equation}");
        assert!(mistake.message.starts_with("exponents of parameters go to 64"), "{mistake:?}");
    }
}
