//! Tests that blocks are read correctly, and that printed blocks are read as equal blocks.

use kahan_algebra::check::Checked;
use kahan_algebra::diagnostics::Kind;
use kahan_algebra::render::macro_block;
use kahan_algebra::system::System;
use kahan_algebra::{lexer, parse, read, read_unproved};

fn unproved(text: &str) -> System {
    read_unproved(&lexer::lex(text).tokens).system().expect("a system")
}

fn reading(text: &str) -> Checked {
    read(&lexer::lex(text).tokens)
}

fn equations(text: &str) -> Vec<String> {
    let reading = reading(text);
    assert_eq!(reading.diagnostics(), [], "{text}");
    macro_block(&reading.system().expect("a system"))
        .lines()
        .filter(|line| line.contains("dot ="))
        .map(|line| line.trim().to_owned())
        .collect()
}

#[test]
fn spellings_of_one_field_are_one_field() {
    let same = [
        ("xdot = x^2 - 4;", "xdot = -4 + x*x;"),
        ("xdot = -x^2;", "xdot = 0 - (x^2);"),
        ("xdot = (-x)^2;", "xdot = x^2;"),
        ("xdot = x/2/3;", "xdot = x/6;"),
        ("xdot = 2*x/4*6;", "xdot = 3*x;"),
        ("xdot = x - 1 - 2;", "xdot = x - 3;"),
        ("xdot = 0.1*x + 1.5e-3;", "xdot = x/10 + 3/2000;"),
        ("xdot = 1_000*x + 1E2;", "xdot = 1000*x + 100;"),
        ("xdot = 1.*x;", "xdot = x;"),
        ("xdot = --x;", "xdot = x;"),
        ("xdot = 2*-x;", "xdot = -2*x;"),
        ("xdot = x^0 + x^1;", "xdot = 1 + x;"),
        ("xdot = x^3 + x^2 - x*x*x;", "xdot = x^2;"),
        ("const c = 1/3; const d = c^2; xdot = c*x - d;", "xdot = x/3 - 1/9;"),
        ("xdot = 2^10*x;", "xdot = 1024*x;"),
        ("xdot = a*x/a;", "xdot = x;"),
        ("xdot = x/(a - b) + x/(b - a) + a + b;", "xdot = a + b;"),
        ("xdot = x/(a*b)*a;", "xdot = x/b;"),
    ];
    for (spelling, canonical) in same {
        // Parameters that cancel are still parameters, so only equations are compared.
        assert_eq!(equations(spelling), equations(canonical), "{spelling}");
    }
}

#[test]
fn literals_keep_all_their_digits() {
    assert_eq!(
        equations("xdot = 12345678901234567890.123456789*x;"),
        ["xdot = 12345678901234567890123456789/1000000000*x;"]
    );
}

#[test]
fn a_printed_block_reads_as_the_same_system() {
    let text =
        "pub struct Top { a1, a2, a3 } xdot = a1*y*z/(1 + a2); ydot = a2*z*x - 1/2; zdot = a3*x*y + 0.1*x;
        integral s = -x*(y - z)^2/-(x) when a1 = 1/2;";
    let first = unproved(text);
    let printed = macro_block(&first);
    let inner = printed.trim_start_matches("kahan! {").trim_end_matches('}');
    let second = unproved(inner);
    assert_eq!(second.field, first.field);
    assert_eq!(macro_block(&second), printed);
    assert_eq!(second.claims[0].plan, first.claims[0].plan);
}

#[test]
fn the_semicolon_after_a_bracket_is_optional() {
    let field = "xdot = 0; ydot = 0;";
    for end in ["", ";"] {
        let bracket = format!("bracket P {{ {{x,y}} = 1; }} when eps = 1{end}");
        let text = format!("{field} {bracket} integral H = x; {bracket} const c = 2;")
            .replace("bracket P", "bracket Q");
        assert!(reading(&text.replacen("bracket Q", "bracket P", 1)).diagnostics().is_empty(), "{text}");
    }
}

#[test]
fn sums_of_twenty_thousand_terms_are_read() {
    let terms: Vec<String> = (0..20_000).map(|i| format!("{}*x*y/{}", i + 1, i % 97 + 1)).collect();
    let text = format!("xdot = {}; ydot = x;", terms.join(" + "));
    assert!(reading(&text).diagnostics().is_empty());
    let claim = vec!["x/x*y/y"; 20_000].join(" + ");
    let text = format!("xdot = 0; ydot = 0; integral f = x + {claim};");
    assert!(reading(&text).diagnostics().is_empty());
}

#[test]
fn limits_are_errors_at_their_place() {
    let nested = format!("xdot = {}x{};", "(".repeat(5_000), ")".repeat(5_000));
    let many: String = (0..=10_000).map(|i| format!("x{i}dot = 1;")).collect();
    let cases = [
        ("xdot = x^1000000000;", Kind::Degree),
        ("xdot = (x + y + z)^5000; ydot = x; zdot = x;", Kind::Degree),
        ("xdot = (x + y)^5000; ydot = x;", Kind::Degree),
        (nested.as_str(), Kind::TooLarge),
        (many.as_str(), Kind::TooLarge),
        ("xdot = 1e5000*x;", Kind::TooLarge),
        ("xdot = a^65*x;", Kind::TooLarge),
        ("xdot = 2^1000000000*x;", Kind::TooLarge),
        ("xdot = (a + b + c + d + e + f + g + h)^60*x;", Kind::TooLarge),
    ];
    for (text, kind) in cases {
        let kinds: Vec<Kind> = reading(text).diagnostics().iter().map(|diagnostic| diagnostic.kind).collect();
        assert_eq!(kinds, [kind], "{text:.60}");
    }
}

fn listed(count: usize, name: impl Fn(usize) -> String, between: &str) -> String {
    (0..count).map(name).collect::<Vec<_>>().join(between)
}

#[test]
fn blocks_of_more_names_and_claims_than_are_read_are_refused() {
    let parameters = |count| listed(count, |k| format!("a{k}"), " + ");
    let header = |count| listed(count, |k| format!("a{k}"), ", ");
    let constants = |count| listed(count, |k| format!("const c{k} = {k};"), " ");
    let claims = |count| listed(count, |k| format!("integral I{k} = x;"), " ");
    let arrays = |count| listed(count, |k| format!("x{k}[i]dot = x{k}[i+64];"), " ");
    for (allowed, refused) in [
        (format!("xdot = {};", parameters(9_999)), format!("xdot = {};", parameters(70_000))),
        (
            format!("struct S {{ {} }} xdot = {};", header(9_999), parameters(9_999)),
            format!("struct S {{ {} }} xdot = {};", header(70_000), parameters(70_000)),
        ),
        (format!("{} xdot = 1;", constants(9_000)), format!("{} xdot = 1;", constants(70_000))),
        (format!("xdot = 0; {}", claims(500)), format!("xdot = 0; {}", claims(501))),
        (
            format!("{} integral H = x0;", listed(100, |k| format!("x{k}dot = 0*x{k};"), " ")),
            format!("{} integral H = x0;", listed(1_000, |k| format!("x{k}dot = 0*x{k};"), " ")),
        ),
        (
            format!(
                "xdot = 0; ydot = {}; {}",
                listed(2_000, |k| format!("y*a^{}*b^{}", k % 50, k / 50), " + "),
                claims(10)
            ),
            format!(
                "xdot = 0; ydot = {}; {}",
                listed(20_000, |k| format!("y*a^{}*b^{}*c^{}", k % 50, k / 50 % 50, k / 2500), " + "),
                claims(500)
            ),
        ),
        (format!("for i in open {{ {} }}", arrays(77)), format!("for i in open {{ {} }}", arrays(78))),
        (
            format!("for i in periodic {{ x[i]dot = {}; }}", parameters(9_997)),
            format!("for i in periodic {{ x[i]dot = {}; }}", parameters(70_000)),
        ),
    ] {
        assert!(
            reading(&allowed).diagnostics().is_empty(),
            "{allowed:.60}: {:?}",
            reading(&allowed).diagnostics()
        );
        let kinds: Vec<Kind> = reading(&refused).diagnostics().iter().map(|mistake| mistake.kind).collect();
        assert_eq!(kinds, [Kind::TooLarge], "{refused:.60}");
    }
}

#[test]
fn no_more_than_two_hundred_mistakes_are_told() {
    let text = format!("struct S {{ a }} xdot = a + {};", listed(20_000, |k| format!("b{k}"), " + "));
    assert_eq!(reading(&text).diagnostics().len(), 200);
}

#[test]
fn one_mistake_makes_one_error_and_three_make_three() {
    let text = "xdot = y*z + sin(x); ydot = zz*x; zdot = x^2*y; integral H = x + ydot;";
    assert_eq!(reading(text).diagnostics().len(), 3, "{:?}", reading(text).diagnostics());
    for text in ["x = y; ydot = x;", "xdot = y ydot = x;", "xdot = yy + yy*yy; ydot = x; zdot = yy;"] {
        let header = format!("struct S; {text}");
        assert_eq!(reading(&header).diagnostics().len(), 1, "{:?}", reading(&header).diagnostics());
    }
}

#[test]
fn places_point_at_the_token_to_change() {
    let cases = [
        ("xdot = x*y*z; ydot = 0; zdot = 0;", "z"),
        ("xdot = x*(y - 1)*(2 + x) + y; ydot = 0;", "(2 + x)"),
        ("xdot = x + (y*x)^2; ydot = 0;", "(y*x)^2"),
        ("xdot = y/(1 + x); ydot = 0;", "(1 + x)"),
        ("xdot = y/(a - a); ydot = 0;", "(a - a)"),
        ("struct S; xdot = y + mu*x; ydot = 0;", "mu"),
        ("struct S { mu } xdot = x;", "mu"),
        ("xdot = 2x;", "2x"),
        ("xdot = x; xdot = 1;", "xdot"),
        ("xdot = x; integral H = x;", "H"),
    ];
    for (text, place) in cases {
        let lexed = lexer::lex(text);
        let read = read(&lexed.tokens);
        let diagnostics = read.diagnostics();
        let [diagnostic] = diagnostics else { panic!("{text}: {diagnostics:?}") };
        let (first, last) = (&lexed.ranges[diagnostic.span.first], &lexed.ranges[diagnostic.span.last]);
        assert_eq!(&text[first.start..last.end], place, "{text}");
    }
}

/// Each input has failed in the past.
#[test]
fn what_once_went_wrong_stays_mended() {
    for text in ["xdot = 2α*x;", "xdot = 1.5ü*x;", "xdot = x^2é;", "xdot = 0é;", "xdot = 1_é*x;"] {
        assert_eq!(reading(text).diagnostics().len(), 1, "{text}");
    }
    // An unclosed comment once hid all later text.
    assert_eq!(reading("xdot = x; /* open; ydot = y;").diagnostics().len(), 1);
    assert_eq!(equations("xdot = 1e1_0*x;"), equations("xdot = 10000000000*x;"));
    assert_eq!(reading("xdot = _*x;").diagnostics().len(), 1);
    assert_eq!(reading("struct _; xdot = x;").diagnostics().len(), 1);
    // Without equations, the only mistake is the missing field.
    assert_eq!(reading("integral H = x;").diagnostics().len(), 1);
    let read = reading("xdot = @x;");
    let message = &read.diagnostics()[0].message;
    assert!(message.contains('@') && !message.contains("empty"), "{message}");
}

/// Powers of numbers may have larger exponents than states, in equations and in claims.
#[test]
fn claims_take_powers_of_numbers_as_equations_do() {
    let claim = |text: &str| {
        reading(&format!("const two = 2; xdot = y; ydot = -x; integral E = {text};")).diagnostics().to_vec()
    };
    let squares = "(x^2 + y^2)";
    for factor in ["2^1000", "2^-70", "1/10^300", "(1/3)^99", "(-2)^65", "two^100"] {
        let text = format!("{factor}*{squares}");
        assert_eq!(claim(&text), [], "{text}");
    }
    for text in ["x^70", "(x + y)^65", "2^1000000*x^2", "0^4294967296*x^2"] {
        assert!(claim(text).iter().any(|wrong| wrong.kind == Kind::Exponent), "{text}");
    }
}

#[test]
fn families_refuse_the_names_that_systems_refuse() {
    for (names, factor) in [
        ("struct S { fn }", "fn"),
        ("struct fn;", "2"),
        ("struct S { eps }", "2"),
        ("struct S { k, k }", "k"),
        ("struct S { k } const k = 2;", "k"),
        ("", "fn"),
        ("", "ϵ"),
    ] {
        let messages = |text: String| -> Vec<String> {
            reading(&text).diagnostics().iter().map(|mistake| mistake.message.clone()).collect()
        };
        let of_system = messages(format!("{names} xdot = {factor}*x;"));
        let of_family = messages(format!("{names} for i in periodic {{ x[i]dot = {factor}*x[i]; }}"));
        assert!(!of_system.is_empty(), "{names} {factor}");
        assert_eq!(of_system, of_family, "{names} {factor}");
    }
    for text in [
        "for i in periodic { eps[i]dot = eps[i+1]; }",
        "struct S { fn } for i in periodic { x[i]dot = fn[i]*x[i]; }",
        "for i in periodic { x[i]dot = fn[i]*x[i+1]; }",
    ] {
        assert_eq!(reading(text).diagnostics().len(), 1, "{text}: {:?}", reading(text).diagnostics());
    }
}

#[test]
fn a_block_that_asks_for_a_lift_is_told_where_it_is_lifted() {
    for text in [
        "lift; xdot = sin(x);",
        "lift struct S { k } xdot = k*abs(x); ydot = ",
        "#[derive(Eq)] lift pub(crate) struct S; xdot = x;",
    ] {
        let tokens = lexer::lex(text).tokens;
        assert!(parse::asks_for_lift(&tokens), "{text}");
        let checked = read(&tokens);
        let [mistake] = checked.diagnostics() else { panic!("{text}: {:?}", checked.diagnostics()) };
        assert_eq!(&*tokens[mistake.span.first].text, "lift");
        assert!(mistake.help.contains("kahan lift"), "{mistake}");
    }
    for text in [
        "liftdot = lift;",
        "struct S { lift } xdot = lift*x;",
        "xdot = y; ydot = -x; integral lift = x^2 + y^2;",
    ] {
        let tokens = lexer::lex(text).tokens;
        assert!(!parse::asks_for_lift(&tokens), "{text}");
        assert_eq!(read(&tokens).diagnostics(), [], "{text}");
    }
}
