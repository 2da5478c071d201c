//! Tests that each hint gives a correct text, or names a page of the documentation.
//!
//! Each row has a text with one mistake, and the corrected text. Text that the hint quotes must
//! occur in the corrected text.

use std::path::Path;

use kahan_algebra::check::Checked;
use kahan_algebra::diagnostics::Diagnostic;

use kahan_algebra::{lenient, lexer, read};

const PAGE: &str = "docs/how-to/not-quadratic.md";
const ON_TEXTS: &str = "docs/how-to/texts.md";

fn checked(text: &str) -> Checked {
    read(&lexer::lex(text).tokens)
}

fn mistake(text: &str) -> Diagnostic {
    let read = checked(text);
    let [mistake] = read.diagnostics() else { panic!("one mistake in {text}: {:?}", read.diagnostics()) };
    mistake.clone()
}

/// Returns the text in backticks, split at each `…`.
fn quoted(help: &str) -> Vec<&str> {
    help.split('`').skip(1).step_by(2).flat_map(|quoted| quoted.split('…')).collect()
}

#[test]
fn hints_lead_to_a_text_that_is_read() {
    for (wrong, right) in [
        // Derivatives are written in other notations.
        ("dx = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("dx = -1;", "xdot = -1;"),
        ("dx = -k*dx;", "dxdot = -k*dx;"),
        ("Dx = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("dxdt = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("dx_dt = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("dx/dt = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("x_t = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("x_prime = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("ẋ = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("q\u{307} = p; pdot = -q;", "qdot = p; pdot = -q;"),
        ("ẋ1 = y; ydot = -x1;", "x1dot = y; ydot = -x1;"),
        ("x_dot = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("x_dot = -1;", "xdot = -1;"),
        ("xDot = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("x_Dot = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("xdot(t) = y; ydot = -x;", "xdot = y; ydot = -x;"),
        ("xdot = y(t); ydot = -x;", "xdot = y; ydot = -x;"),
        ("xddot = -x;", "xdot = v; vdot = -x;"),
        ("xddot = -g;", "xdot = v; vdot = -g;"),
        ("x_ddot = -v*x;", "xdot = u; udot = -v*x;"),
        ("ẍ = -x;", "xdot = v; vdot = -x;"),
        ("xdddot = -x;", "xdot = v; vdot = a; adot = -x;"),
        // Rows contain the time, or a derivative on a right-hand side.
        ("xdot = t*x;", "xdot = t*x; tdot = 1;"),
        ("xdot = t*x;", "struct Name { t } xdot = t*x;"),
        ("struct S; xdot = t*x;", "struct S; xdot = t*x; tdot = 1;"),
        ("for i in open { x[i]dot = t*x[i]; }", "for i in open { x[i]dot = t[i]*x[i]; t[i]dot = 1; }"),
        // Rows contain powers and function calls.
        ("xdot = x^(2);", "xdot = x^2;"),
        ("xdot = x^2.0;", "xdot = x^2;"),
        ("xdot = k^-2*x;", "xdot = 1/k^2*x;"),
        ("xdot = (k + 1)^-1*x;", "xdot = 1/(k + 1)*x;"),
        ("xdot = k(x + 1);", "xdot = k*(x + 1);"),
        ("xdot = sqrt(2)*x;", "const c = 1.4142135623730951; xdot = c*x;"),
        ("xdot = c*x + sqrt(4);", "const k = 2; xdot = c*x + k;"),
        ("xdot = exp(2*a)*x;", "xdot = c*x;"),
        ("xdot = exp(2)*x;", "const c = 7.38905609893; xdot = c*x;"),
    ] {
        let Diagnostic { message, help, .. } = mistake(wrong);
        assert!(!help.contains(PAGE), "{wrong}: {help}");
        let alternatives = help.split("; for a parameter").chain([&*help]);
        let is_there = |help: &str| quoted(help).iter().all(|piece| right.contains(piece.trim()));
        let is_choice = help.contains(", or ")
            && quoted(&help).iter().any(|piece| !piece.is_empty() && right.contains(piece));
        assert!(alternatives.into_iter().any(is_there) || is_choice, "{wrong}: {message}: {help}");
        assert_eq!(checked(right).diagnostics(), [], "{wrong} becomes {right}");
    }
}

#[test]
fn hints_on_what_is_not_quadratic_name_the_page() {
    for (wrong, part, right) in [
        ("vdot = -v^3;", "`w` for `v^2`", "vdot = -v*w; wdot = -2*w^2;"),
        ("wdot = -w^3;", "`u` for `w^2`", "wdot = -w*u; udot = -2*u^2;"),
        (
            "xdot = x*y*z; ydot = 0; zdot = 0;",
            "`w` for `x*y`",
            "xdot = w*z; ydot = 0; zdot = 0; wdot = w*y*z;",
        ),
        ("struct S { w } xdot = w*x^3;", "`u` for `x^2`", "struct S { w } xdot = w*u*x; udot = 2*w*u^2;"),
        (
            "for i in open { x[i]dot = x[i]^3; }",
            "`w[i]` for `x[i]^2`",
            "for i in open { x[i]dot = x[i]*w[i]; w[i]dot = 2*w[i]^2; }",
        ),
        ("for i in open { x[i]dot = 1/x[i+1]; }", "`w[i]` for `1/x[i+1]`", ""),
        ("xdot = (x + y)^70; ydot = 0;", "`w` for `x^2`", ""),
        ("xdot = y/(h + x); ydot = -x;", "`w` for `1/(x + h)`", ""),
        ("xdot = x^-1;", "`w` for `1/x`", ""),
        ("const w = 1; xdot = w/x^2;", "`u` for `1/(x^2)`", ""),
        ("xdot = x^(3/2);", "write an integer literal", ""),
        ("xdot = x^0.5;", "write an integer literal", ""),
        ("xdot = x^n;", "write an integer literal", ""),
        ("xdot = sin(x);", "a state for `sin(…)`", "xdot = s; sdot = c*s; cdot = -s^2;"),
        (
            "xdot = y + cos(t); ydot = -x;",
            "a state for `cos(…)`",
            "xdot = y + c; ydot = -x; cdot = -s; sdot = c;",
        ),
        ("xdot = hill(x, 2);", "a state for `hill(…)`", ""),
    ] {
        let help = mistake(wrong).help;
        assert!(help.contains(part) && help.contains(PAGE), "{wrong}: {help}");
        let is_further = |mistake: &Diagnostic| mistake.help.contains(PAGE);
        assert!(
            checked(right).diagnostics().iter().all(|mistake| right.is_empty() || is_further(mistake)),
            "{right}"
        );
    }
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(PAGE).exists());
}

/// Texts of other tools are refused. Each row has such a text, words of the hint, and the corrected
/// text or a page.
#[test]
fn hints_on_texts_of_other_tools_lead_on() {
    let leniently = |text: &str| read(&lenient::read(text).lexed.tokens);
    for (wrong, part, right) in [
        // Rows have products without `*`, and physical units.
        ("(x)' = -9.999 x + 9.999 y", "`-9.999*x + 9.999*y`", "(x)' = -9.999*x + 9.999*y"),
        ("x' = 2x - 3xy", "`2*x - 3*x*y`; if `xy` is one name", "x' = 2*x - 3*x*y"),
        ("x' = 2x - 3xy", "if `xy` is one name", "x' = 2*x - 3*xy"),
        ("x' = 2(x + y)(x - y)\ny' = a x^2y", "`2*(x + y)*(x - y)`", "x' = 2*(x + y)*(x - y)\ny' = a*x^2"),
        ("S' = -beta S I; I' = beta S I - gamma I", "`-beta*S*I`", "S' = -beta*S*I; I' = beta*S*I - gamma*I"),
        ("x' = 0.5e-1x(x + 1)", "`0.5e-1*x*(x + 1)`", "x' = 0.5e-1*x*(x + 1)"),
        ("y' = 3 [1/s] * y", "write the number alone", "y' = 3 * y"),
        // Derivatives are written in the notation of other tools.
        ("x_dot = y; y' = -x", "`xdot = …`", "xdot = y; y' = -x"),
        ("dx = y; y' = -x", "`xdot = …`", "xdot = y; y' = -x"),
        ("x' = y'; y' = 1", "put in what", "x' = 1; y' = 1"),
        ("x' = v; v' = -x + t", "`tdot = 1;`", "x' = v; v' = -x + t; tdot = 1"),
        // Rows set initial values or parameters.
        ("x(0) = a; x' = a*x", "`x(0) = 1/2`", "x(0) = 1/2; x' = a*x"),
        ("x = a; x' = a*x", "`x = 1/2`", "x = 1/2; x' = a*x"),
        ("a = 1; a = 2; x' = a*x", "once", "a = 1; x' = a*x"),
        ("x'(0) = 1; x' = x", "leave it out", "x' = x"),
        ("z(0) = 1; x' = x", "leave it out", "x' = x"),
        // Rows use features of other tools, or functions that are not smooth.
        ("k1, A + B --> C", "Antimony and SBML", ""),
        ("A + B -> C; k1*A*B; C -> A + B; k2*C; A = 1; k1 = 0.1;", "Antimony and SBML", ""),
        ("x' = -x*abs(x)", ON_TEXTS, ""),
        ("x' = max(x, 0)", ON_TEXTS, ""),
        ("x' = x if x > 0 else 0", ON_TEXTS, ""),
        ("x' = sin x", PAGE, ""),
        ("x' = if(x > 0, -x, x)", ON_TEXTS, ""),
        ("x' = -x(t - 1)", ON_TEXTS, ""),
        // The fields are not quadratic.
        ("x'' = -x^3 + cos(t)", PAGE, ""),
        ("x'' = -x^3", PAGE, ""),
        ("S' = -beta*S*I/(S+I+R); I' = beta*S*I/(S+I+R) - gamma*I; R' = gamma*I", PAGE, ""),
        ("x' = r*x*(1 - x/K) - x*y/(h + x); y' = x*y/(h + x) - m*y", PAGE, ""),
        ("x' = v; v' = -x - d*v + F*cos(w*t)", PAGE, ""),
        ("x' = x^(3/2)", PAGE, ""),
        ("x' = exp(-x)", PAGE, ""),
    ] {
        let read = leniently(wrong);
        let helps: Vec<&str> = read.diagnostics().iter().map(|mistake| &*mistake.help).collect();
        assert!(helps.first().is_some_and(|help| help.contains(part)), "{wrong}: {:?}", read.diagnostics());
        assert!(
            !right.is_empty() || helps.iter().all(|help| help.contains("docs/how-to/")),
            "{wrong}: {helps:?}"
        );
        assert_eq!(leniently(if right.is_empty() { "x' = 1" } else { right }).diagnostics(), [], "{right}");
    }
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(ON_TEXTS).exists());
}

/// A name such as `xd` or `x_` is a state if the block has an equation for it.
#[test]
fn names_that_are_used_are_states() {
    for (text, states) in [
        ("x_dot = -k*x_;", "x_"),
        ("xddot = -xd;", "xd"),
        ("xdot = xd; xddot = -x;", "x xd"),
        ("speeddot = 1;", "speed"),
        ("ddot = 1;", "d"),
        ("tdot = 1; xdot = t*x;", "t x"),
        ("struct S; x_dot = x_; integral H = 0*x_ + x_;", ""),
    ] {
        let read = checked(text);
        let is_claim = |mistake: &Diagnostic| mistake.message.contains("does not hold");
        assert!(read.diagnostics().iter().all(is_claim), "{text}: {:?}", read.diagnostics());
        if let Ok(system) = read.system() {
            assert_eq!(system.field.symbols.states.join(" "), states, "{text}");
        }
    }
    assert_eq!(checked("const t = 2; xdot = t*x;").diagnostics(), []);
    assert_eq!(checked("struct S { t } xdot = t*x;").diagnostics(), []);
}

/// A name such as `xdot` must not become a parameter, or claims about a misread field would hold.
#[test]
fn no_name_of_a_derivative_is_taken_for_a_parameter() {
    for text in [
        "x_dot = y; y_dot = -x;",
        "xdot = v; vdot = -x - xdot;",
        "xdot = v; vdot = -x - ẋ;",
        "xdot = v; vdot = -x - v';",
        "xdot = v; vdot = cos(t) - x;",
        "for i in open { x[i]dot = t; }",
        "for i in open { x[i]dot = xdot; }",
    ] {
        assert!(checked(text).system().is_err(), "{text}");
    }
    let both = checked("x_dot = y; y_dot = -x;");
    assert_eq!(both.diagnostics().len(), 2, "{:?}", both.diagnostics());
    let conditions = mistake("xdot = if(x > 0, 1, 2);");
    assert!(!conditions.help.contains("if*"), "{conditions}");
}
