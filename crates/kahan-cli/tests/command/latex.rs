//! Tests `kahan show --latex`: names, fractions, lines that fit a page, and balanced groups.

use kahan_judge::random_fields::numbered;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_systems::registry::all;

use crate::running::answer;

fn latex(arguments: &[&str]) -> String {
    answer(&[&["show"], arguments, &["--latex"]].concat())
}

fn of_field(field: &str) -> String {
    latex(&["--field", field])
}

/// Panics unless braces, `\left … \right` and environments are balanced in each displayed formula.
fn assert_is_whole(page: &str) {
    let mut open: Vec<String> = Vec::new();
    for line in page.lines().filter(|line| !line.starts_with('%')) {
        let mut rest = line;
        while let Some(c) = rest.chars().next() {
            let word = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).map_or(rest.len(), |end| end + 1);
            let argument = || rest.split(['{', '}']).nth(1).unwrap_or_default().to_owned();
            let mut taken = c.len_utf8();
            let mut close = |expected: &str| {
                assert_eq!(open.pop().as_deref(), Some(expected), "in {line}");
            };
            match (c, &rest[..word.min(rest.len())]) {
                ('\\', "\\begin") => open.push(argument()),
                ('\\', "\\end") => close(&argument()),
                ('\\', "\\left") => open.push("left".to_owned()),
                ('\\', "\\right") => close("left"),
                ('\\', "\\") if rest.starts_with("\\[") => open.push("display".to_owned()),
                ('\\', "\\") if rest.starts_with("\\]") => close("display"),
                ('{', _) => open.push("brace".to_owned()),
                ('}', _) => close("brace"),
                _ => {}
            }
            if c == '\\' {
                taken = match &rest[..word] {
                    "\\begin" | "\\end" => rest.find('}').map_or(word, |end| end + 1),
                    "\\" => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
                    _ => word,
                };
            }
            rest = &rest[taken..];
        }
    }
    assert!(open.is_empty(), "{open:?} stay open");
}

/// Panics if a formula has a factor 1 or a denominator 1.
fn assert_has_no_ones(page: &str) {
    for (at, _) in page.match_indices("1 ") {
        let before = page[..at].chars().next_back().unwrap_or(' ');
        let after = page[at + 2..].chars().next().unwrap_or(' ');
        let begins = matches!(before, '{' | ' ' | '(' | '&' | '-') && !page[..at].ends_with("\\cdot ");
        let follows = after.is_ascii_alphabetic()
            || page[at + 2..].starts_with("\\left")
            || page[at + 2..].starts_with("\\frac");
        assert!(
            !(begins && follows),
            "a factor of 1 in {}",
            &page[at.saturating_sub(60)..page.len().min(at + 40)]
        );
    }
    assert!(!page.contains("}{1}"), "a fraction over 1: {page}");
}

/// Panics unless every row of every displayed formula fits the page, or is a single term.
fn assert_fits(page: &str) {
    let displays = page.split("\\[").skip(1).filter_map(|rest| rest.split("\\]").next());
    assert!(displays.clone().count() > 0, "no display: {page}");
    for row in displays.flat_map(|display| display.lines()) {
        if row.starts_with("\\begin") || row.starts_with("\\end") {
            continue;
        }
        assert!(breaking::width_of(row) <= PAGE_WIDTH + 8, "{} characters: {row}", breaking::width_of(row));
    }
}

#[test]
fn the_latex_of_the_catalog_is_whole_and_fits_a_page() {
    for entry in all() {
        let page = latex(&[entry.command]);
        assert_is_whole(&page);
        assert_has_no_ones(&page);
        assert_fits(&page);
    }
}

#[test]
fn the_latex_of_random_fields_is_whole_and_fits_a_page() {
    for number in 0..24 {
        let page = of_field(&numbered(7, number).block());
        assert!(!page.contains("\\frac{\\frac") && !page.contains("\\frac{-\\frac"), "{page}");
        assert_is_whole(&page);
        assert_has_no_ones(&page);
        assert_fits(&page);
    }
}

#[test]
fn names_become_letters_words_and_indices() {
    let page = of_field(
        "x_1dot = mu_1*y + al*x_1^2 - alpha12*y; ydot = a_1_2*x_1*y + Gamma*x_1 + k_max*y + eps0*x_1;",
    );
    for part in [
        "\\mu_{1} y",
        "\\mathit{al}\\, x_{1}^{2}",
        "\\alpha_{12}",
        "a_{1,2}",
        "\\Gamma x_{1}",
        "k_{\\mathrm{max}} y",
        "\\varepsilon_{0}",
    ] {
        assert!(page.contains(part), "{part} is missing: {page}");
    }
    assert!(page.contains("\\dot {x_{1}} &=") && page.contains("x_{1}'"), "{page}");
    assert_is_whole(&page);
}

#[test]
fn no_factor_of_one_is_written() {
    let circle = "xdot = y; ydot = -x; integral H = ";
    for (written, latex) in [
        ("1/2*(x^2 + y^2)", "\\frac{x^{2} + y^{2}}{2}"),
        ("-1/2*(x^2 + y^2)", "-\\frac{x^{2} + y^{2}}{2}"),
        ("1*(x^2 + y^2)", "x^{2} + y^{2}"),
        ("-1*(x^2 + y^2)", "-\\left(x^{2} + y^{2}\\right)"),
        ("1/(x^2 + y^2)", "\\frac{1}{x^{2} + y^{2}}"),
        ("0.5*(x^2 + y^2)", "\\frac{x^{2} + y^{2}}{2}"),
        ("(x^2 + y^2)*1*3", "3 \\left(x^{2} + y^{2}\\right)"),
        ("2*3*(x^2 + y^2)/4", "\\frac{3 \\left(x^{2} + y^{2}\\right)}{2}"),
        ("(x^2 + y^2)/(2*eps)", "\\frac{x^{2} + y^{2}}{2 \\varepsilon}"),
        ("1*x^2 + y^2/1", "x^{2} + y^{2}"),
        ("(x^2 + y^2)*2^3", "\\left(x^{2} + y^{2}\\right) \\cdot 2^{3}"),
    ] {
        let page = of_field(&format!("{circle}{written};"));
        assert!(page.contains(&format!("H &= {latex}\n")), "{written}: {page}");
        assert_is_whole(&page);
    }
    // Without quadratic terms the map is polynomial.
    let page = of_field("xdot = 1; ydot = x;");
    assert!(page.contains("\\widetilde {x} &= x + 2\\varepsilon \\\\\n"), "{page}");
    assert!(page.contains("\\widetilde {y} &= y + 2\\varepsilon\\left(x + \\varepsilon\\right)\n"), "{page}");
    let page = of_field("xdot = -3; ydot = -3; zdot = a; wdot = 2*a;");
    for part in ["2\\varepsilon\\left(-3\\right)", "2\\varepsilon\\,a ", "2\\varepsilon\\left(2 a\\right)"] {
        assert!(page.contains(part), "{part} is missing: {page}");
    }
}

#[test]
fn fractions_have_whole_numbers_and_their_sign_in_front() {
    let page = of_field("xdot = x*y/(2*a); ydot = -x/a + y/(3*b)*0; zdot = -z/(1/2*a) - 1/3*x/a;");
    for part in [
        "\\frac{x y}{2 a}",
        "&= -\\frac{x}{a}",
        "&= -\\frac{x + 6 z}{3 a}",
        "\\frac{2 a - \\varepsilon y}{2 a}",
    ] {
        assert!(page.contains(part), "{part} is missing: {page}");
    }
    assert!(!page.contains("\\frac{\\frac"), "{page}");
    assert_is_whole(&page);
}
