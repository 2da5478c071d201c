//! Tests that texts in many notations are translated into the language of `kahan!`.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics};
use kahan_syntax::lenient::{Reading, read};
use kahan_syntax::lexer::lex;
use kahan_syntax::parse::parse;
use kahan_syntax::token::Token;

fn mistakes(tokens: &[Token]) -> Vec<Diagnostic> {
    let mut diagnostics = Diagnostics::default();
    let _ = parse(tokens, &mut diagnostics);
    diagnostics.finish()
}

/// Returns on one line the values of parameters, the translation, and the initial values.
fn reading(text: &str) -> String {
    let read = read(text);
    assert_eq!(mistakes(&read.lexed.tokens), [], "{text}");
    assert_eq!(read.lexed.tokens.len(), read.lexed.ranges.len());
    let values = |list: &[(String, kahan_syntax::rational::Rational)]| {
        list.iter().fold(String::new(), |line, (name, value)| line + name + "=" + &value.to_string() + " ")
    };
    let line = read.canonical().replace('\n', " ");
    format!("{}{line} {}", values(&read.parameters), values(&read.start)).trim_end().to_owned()
}

#[test]
fn texts_of_other_tools_are_read() {
    for (text, expected) in [
        ("x' = y\ny' = -x - x^2", "xdot = y; ydot = -x - x^2;"),
        ("dx/dt = a*x - b*x*y; dy/dt = -c*y + d*x*y", "xdot = a*x - b*x*y; ydot = -c*y + d*x*y;"),
        (
            "xdot = s*(y - x)\nydot = x*(r - z) - y\nzdot = x*y - b*z",
            "xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;",
        ),
        ("xdot = y; ydot = 6*x**2 - a", "xdot = y; ydot = 6*x^2 - a;"),
        (
            "par s=10,r=28,b=2.66667\ninit x=1,y=1,z=1\nx'=s*(y-x)\ny'=r*x-y-x*z\nz'=x*y-b*z\ndone",
            "s=10 r=28 b=266667/100000 xdot = s*(y-x); ydot = r*x-y-x*z; zdot = x*y-b*z; x=1 y=1 z=1",
        ),
        ("# predator and prey\ndn/dt=n*(1-p)\ndp/dt=p*(n-1)", "ndot = n*(1-p); pdot = p*(n-1);"),
        ("der(x) = y; der(y) = -x;", "xdot = y; ydot = -x;"),
        ("diff(x(t),t) = y(t), diff(y(t),t) = -x(t)", "xdot = y; ydot = -x;"),
        ("x'[t] == y[t], y'[t] == -x[t]", "xdot = y; ydot = -x;"),
        ("Eq(Derivative(x(t), t), y(t))", "xdot = y;"),
        ("Eq(Derivative(x(t), t), y(t))\nEq(Derivative(y(t), t), -x(t))", "xdot = y; ydot = -x;"),
        (
            "Eq(Derivative(x(t), (t, 2)), -(x(t) + 1)*2), Eq(Derivative(y(t), t), y(t));",
            "xdot = v; vdot = -(x + 1)*2; ydot = y;",
        ),
        ("[Eq(Derivative(x(t), t), y(t)), Eq(Derivative(y(t), t), -x(t))]", "xdot = y; ydot = -x;"),
        ("{x'[t] == y[t], y'[t] == -x[t]}", "xdot = y; ydot = -x;"),
        ("\\dot{x} = y, \\dot{y} = -x", "xdot = y; ydot = -x;"),
        ("\\frac{dx}{dt} = y, \\ddot{y} = -x", "xdot = y; ydot = v; vdot = -x;"),
        ("D(x) ~ y\nD(y) ~ -x", "xdot = y; ydot = -x;"),
        ("x'' = -x - x^2", "xdot = v; vdot = -x - x^2;"),
        ("d^2x/dt^2 = -x - d*dx/dt", "xdot = v; vdot = -x - d*v;"),
        ("d²x/dt² = -v*x", "xdot = u; udot = -v*x;"),
        ("x''' = x' - x''\ny'' = v*y'", "xdot = u; udot = a; adot = u - a; ydot = p; pdot = v*p;"),
        ("ẍ = -x - ẋ; x(0) = 1; ẋ(0) = -1/2", "xdot = v; vdot = -x - v; x=1 v=-1/2"),
        ("ẋ = α·x − β·x·y; ẏ = δ·x·y − γ·y", "xdot = α*x - β*x*y; ydot = δ*x*y - γ*y;"),
        (
            "x1' = x1*(x2 - x3); x2' = x2*(x3 - x1); x3' = x3*(x1 - x2)",
            "x1dot = x1*(x2 - x3); x2dot = x2*(x3 - x1); x3dot = x3*(x1 - x2);",
        ),
        (
            "S' = -beta*S*I; I' = beta*S*I - gamma*I; R' = gamma*I",
            "Sdot = -beta*S*I; Idot = beta*S*I - gamma*I; Rdot = gamma*I;",
        ),
        ("N' = E*N - I\nE' = S", "Ndot = E*N - I; Edot = S;"),
        ("x' = sqrt(2)*y; y' = -x", "sqrt_2=14142135623730951/10000000000000000 xdot = sqrt_2*y; ydot = -x;"),
        (
            "x' = sqrt(4)*y + sqrt(0.25)*x - sqrt(2)\ny' = sqrt_2 - sqrt(2)",
            "sqrt_21=14142135623730951/10000000000000000 xdot = 2*y + 0.5*x - sqrt_21; ydot = sqrt_2 - sqrt_21;",
        ),
        ("x' = pi*x", "pi=3141592653589793/1000000000000000 xdot = pi*x;"),
        ("pi = 3; x' = pi*x", "pi=3 xdot = pi*x;"),
        ("pi' = -pi", "pidot = -pi;"),
        ("a = 1; b = 2; x' = a*x - b*x*y; y' = -y + x*y", "a=1 b=2 xdot = a*x - b*x*y; ydot = -y + x*y;"),
        (
            "x' = +x³\n  - (+y)²\n  + y # a line\n# [another]\ny' = −½*x",
            "xdot = x^3 - (y)^2 + y; ydot = -(1/2)*x;",
        ),
        ("x' = y,\ny' = -x,", "xdot = y; ydot = -x;"),
        ("x' = y; y' = -x\n\nintegral H = x^2 + y^2", "xdot = y; ydot = -x; integral H = x^2 + y^2;"),
        (
            "const c = 1\nx' = c*a*x + b\nintegral H = x when a = 1,\nb = 2\nx(0) = 3",
            "const c = 1; xdot = c*a*x + b; integral H = x when a = 1, b = 2; x=3",
        ),
        ("pub struct S { a }\nx' = a*y\ny' = x", "pub struct S { a } xdot = a*y; ydot = x;"),
        (
            "for i in periodic {\n  x[i]dot = +x[i+1]**2 − x[i-1] }\nintegral mass = sum(x[i])",
            "for i in periodic { x[i]dot = x[i+1]^2 - x[i-1]; } integral mass = sum(x[i]);",
        ),
        (
            "r2 = x^2 + y^2; x' = y*r2 - k; y' = -x; k = 2*c; c = 3",
            "c=3 xdot = y*(x^2 + y^2) - (2*c); ydot = -x;",
        ),
        ("p = q - x\nq = -2*x\nx' = p(t)*q", "xdot = ((-2*x) - x)*(-2*x);"),
        ("par unused=3\nx' = x", "xdot = x;"),
        ("par a=1, unused=3 other=2\nx' = a*x", "a=1 xdot = a*x;"),
        ("par a=1 b=2\ninit x=1 y=+2\nx' = a*x + b*y\ny' = x", "a=1 b=2 xdot = a*x + b*y; ydot = x; x=1 y=2"),
        ("init x = 1, a = -1e-3\nx' = -a*x", "a=-1/1000 xdot = -a*x; x=1"),
    ] {
        assert_eq!(reading(text), expected, "{text}");
        let first = read(text);
        let again = read(&first.canonical());
        let kinds =
            |read: &Reading| read.lexed.tokens.iter().map(|token| token.text.to_string()).collect::<Vec<_>>();
        assert_eq!(kinds(&again), kinds(&first), "{text}");
        assert!(again.is_canonical, "{text}");
    }
}

#[test]
fn a_start_of_another_case_names_the_state() {
    let said = |text: &str| {
        let wrong = mistakes(&read(text).lexed.tokens);
        let [wrong, ..] = &wrong[..] else { panic!("{text}: {}", read(text).canonical()) };
        format!("{}; {}", wrong.message, wrong.help)
    };
    let other = "there is no `x`, but there is `X`: names differ by case; write `X(0) =`";
    assert_eq!(said("dX/dt = -X\nx(0) = .5"), other);
    assert!(said("dX/dt = -X\ninit x=1").starts_with("there is no `x`, but there is `X`"));
    assert!(said("dN/dt = -N\ninit n=1").ends_with("write `init N=`"));
    assert_eq!(reading("dX/dt = -x*X\ninit x=1"), "x=1 Xdot = -x*X;");
    assert!(said("dX/dt = -X\ny(0)=.5").contains("gives a value, which is one number; no equation needs it"));
    assert!(said("dX/dt = -X\nX(0)=a").contains("gives a value, which is one number; write `X(0)= 1/2`"));
}

#[test]
fn what_was_read_in_an_unusual_way_is_noted() {
    for (text, note) in [
        ("x'' = -x", "`x''` is read with `xdot = v`: `v` is a new state"),
        (
            "x' = sqrt(2)*x",
            "numbers are exact: sqrt(2) is the parameter `sqrt_2` with the value 1.4142135623730951",
        ),
        ("x' = u(t)", "`u(t)` is read as a parameter `u`: no equation defines it"),
        ("s = x + y; x' = s; y' = s", "no states, but formulas that are put in where they stand: `s`"),
    ] {
        assert_eq!(read(text).notes, [note], "{text}");
    }
    assert_eq!(read("x' = x(t) + t; t' = 1").notes, [""; 0]);
    for (text, is_canonical) in [
        ("// a # sign\n#[doc = \"#\"] struct S; xdot = x; // x'", true),
        ("xdot = x; # a comment", false),
        ("xdot = x**2;", false),
        ("xdot = x", false),
        ("a = 1; xdot = a*x;", false),
    ] {
        assert_eq!(read(text).is_canonical, is_canonical, "{text}");
    }
}

fn catalog() -> Vec<String> {
    let systems = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../systems/src");
    let folders = ["catalog", "lattices"].map(|folder| fs::read_dir(systems.join(folder)).expect("a folder"));
    let files = folders.into_iter().flatten().map(|file| file.expect("a file").path());
    let mut files: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|ending| ending == "rs")).collect();
    files.sort();
    let block = |text: String| {
        let (_, block) = text.split_once("\nkahan! {\n").or_else(|| text.split_once("kahan! {\n"))?;
        Some(block.split_once("\n}").expect("the end of a block").0.to_owned())
    };
    files.into_iter().filter_map(|file| block(fs::read_to_string(file).expect("a text"))).collect()
}

#[test]
fn the_catalog_keeps_its_tokens() {
    let texts = catalog();
    assert!(texts.len() > 20, "{}", texts.len());
    for text in texts {
        let (strict, lenient) = (lex(&text), read(&text));
        let kept = |(own, read): (&Token, &Token)| {
            (&own.kind, &own.text, &own.docs) == (&read.kind, &read.text, &read.docs)
        };
        assert_eq!(lenient.lexed.tokens.len(), strict.tokens.len(), "{text}");
        assert!(strict.tokens.iter().zip(&lenient.lexed.tokens).all(kept), "{text}");
        assert_eq!(lenient.lexed.ranges, strict.ranges, "{text}");
        assert!(lenient.is_canonical, "{text}");
        assert!(lenient.notes.is_empty() && lenient.parameters.is_empty() && lenient.start.is_empty());
    }
}

type Equations = Vec<(String, String)>;

struct Draws(u64);

impl Draws {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }
}

fn random_field(draws: &mut Draws) -> Equations {
    let states: Vec<String> = match draws.below(3) {
        0 => ["x", "y", "z"].map(str::to_owned).to_vec(),
        1 => ["S", "I", "E", "N"].map(str::to_owned).to_vec(),
        _ => (1..=2 + draws.below(4)).map(|k| format!("q{k}")).collect(),
    };
    let factor = |draws: &mut Draws| match draws.below(6) {
        0 => "a".to_owned(),
        1 => format!("{}", 1 + draws.below(9)),
        2 => format!("(k + {})", states[draws.below(states.len())]),
        3 => format!("{}^2", states[draws.below(states.len())]),
        _ => states[draws.below(states.len())].clone(),
    };
    let right = |draws: &mut Draws| {
        (0..=draws.below(4)).fold(String::new(), |mut sum, term| {
            let sign = match (term, draws.below(2)) {
                (0, 0) => "",
                (0, _) => "-",
                (_, 0) => " + ",
                (_, _) => " - ",
            };
            let _ = write!(sum, "{sign}{}", factor(draws));
            (0..draws.below(2)).for_each(|_| sum.push_str(&format!("*{}", factor(draws))));
            sum
        })
    };
    states.iter().map(|state| (state.clone(), right(draws))).collect()
}

/// Splits a block into the text before its equations, the equations, and the text after them.
fn equations_of(text: &str) -> Option<(String, Equations, String)> {
    let begins = |line: &str| {
        line.trim().split_once("dot = ").is_some_and(|(left, _)| left.chars().all(char::is_alphanumeric))
    };
    let lines: Vec<&str> = text.lines().collect();
    let first = lines.iter().position(|line| begins(line)).filter(|_| !text.contains("for i in"))?;
    let behind = lines[first..].iter().position(|line| {
        let word = line.trim().split(' ').next().unwrap_or("");
        matches!(word, "integral" | "density" | "bracket" | "drift" | "//" | "const")
    });
    let last = behind.map_or(lines.len(), |count| first + count);
    let body = lines[first..last].join("\n");
    let equations = body.split(';').filter(|one| !one.trim().is_empty()).map(|one| {
        let (left, right) = one.split_once("dot =").expect("an equation");
        (left.trim().to_owned(), right.trim().to_owned())
    });
    let equations = equations.collect();
    Some((lines[..first].join("\n"), equations, lines[last..].join("\n")))
}

fn written(manner: usize, equations: &[(String, String)]) -> String {
    let each = |left: &dyn Fn(&str) -> String, right: &dyn Fn(&str) -> String, between: &str| {
        let equations = equations.iter().map(|(state, value)| left(state) + &right(value));
        equations.collect::<Vec<_>>().join(between)
    };
    let same = |right: &str| right.to_owned();
    let of_time = |open: &'static str, close: &'static str| {
        move |right: &str| {
            let mut out = String::new();
            let lexed = lex(right);
            let mut end = 0;
            for (token, range) in lexed.tokens.iter().zip(&lexed.ranges) {
                out += &right[end..range.end];
                end = range.end;
                if equations.iter().any(|(state, _)| *state == token.text) {
                    out += &format!("{open}t{close}");
                }
            }
            out + &right[end..]
        }
    };
    match manner {
        0 => each(&|x| format!("{x}' = "), &same, "\n"),
        1 => each(&|x| format!("d{x}/dt = "), &|right| right.replace('^', "**"), "; ") + "; ",
        2 => each(&|x| format!("{x}dot="), &same, "\n# next\n"),
        3 => each(&|x| format!("der({x}) = "), &|right| format!("+{right}"), ";\n"),
        4 => each(&|x| format!("diff({x}(t), t) = "), &of_time("(", ")"), ", "),
        5 => each(&|x| format!("{x}'[t] == "), &of_time("[", "]"), ",\n") + "\n",
        6 => each(&|x| format!("Eq(Derivative({x}(t), t), "), &|right| of_time("(", ")")(right) + ")", "\n"),
        7 => each(&|x| format!("\\dot{{{x}}} = "), &|right| right.replace('*', "·").replace('-', "−"), ",\n"),
        8 => each(&|x| format!("{x}\u{307} = "), &|right| right.replace("^2", "²").replace("^3", "³"), "\n"),
        _ => each(&|x| format!("{x}′ = "), &|right| right.replace(" + ", "\n  + "), "\n") + "\ndone",
    }
}

#[test]
fn one_field_in_ten_manners_is_one_field() {
    let mut draws = Draws(7);
    let of_catalog = catalog().into_iter().filter_map(|text| equations_of(&text));
    let mut fields: Vec<_> = of_catalog.collect();
    assert!(fields.len() > 15, "{}", fields.len());
    while fields.len() < 300 {
        let random = (String::new(), random_field(&mut draws), String::new());
        fields.push(random);
    }
    let words = |tokens: &[Token]| tokens.iter().map(|token| token.text.to_string()).collect::<Vec<_>>();
    for (before, equations, behind) in fields {
        let strict: String =
            equations.iter().map(|(state, right)| format!("{state}dot = {right};\n")).collect();
        let original = lex(&format!("{before}\n{strict}\n{behind}")).tokens;
        assert_eq!(mistakes(&original), [], "{strict}");
        for manner in 0..10 {
            let text = format!("{before}\n{}", written(manner, &equations));
            let text = if manner == 9 && !behind.trim().is_empty() {
                text.replace("\ndone", "\n") + &behind
            } else {
                format!("{text}\n{behind}")
            };
            let read = read(&text);
            assert_eq!(words(&read.lexed.tokens), words(&original), "{text}");
            assert!(read.notes.is_empty(), "{text}: {:?}", read.notes);
        }
    }
}

const PIECES: &[&str] = &[
    "x",
    "y",
    "t",
    "xdot",
    "x'",
    "y''",
    "dx",
    "dt",
    "d",
    "der",
    "diff",
    "Derivative",
    "Eq",
    "D",
    "ẋ",
    "\\dot",
    "\\frac",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "=",
    "==",
    "~",
    ";",
    ",",
    "\n",
    "\n",
    " ",
    "+",
    "-",
    "−",
    "*",
    "**",
    "·",
    "/",
    "^",
    "²",
    "½",
    "0",
    "1",
    "2x",
    "3.5e-2",
    "par",
    "init",
    "done",
    "const",
    "integral",
    "bracket",
    "drift",
    "by",
    "density",
    "when",
    "for",
    "in",
    "i",
    "periodic",
    "struct",
    "pub",
    "#",
    "#[",
    "sqrt",
    "sin",
    "if",
    "a",
    "b",
    "->",
    "'",
    "\"",
    "//",
    "/*",
    "%",
    "xy",
];

/// Random texts cause no panic. Valid texts can be printed and read again.
#[test]
fn hostile_texts_are_read() {
    let mut draws = Draws(1);
    let mut sound = 0;
    for _ in 0..40_000 {
        let count = 1 + draws.below(24);
        let text: String = (0..count).map(|_| PIECES[draws.below(PIECES.len())]).collect();
        let first = read(&text);
        assert_eq!(first.lexed.tokens.len(), first.lexed.ranges.len(), "{text}");
        assert!(first.lexed.ranges.iter().all(|range| text.get(range.clone()).is_some()), "{text}");
        if mistakes(&first.lexed.tokens).is_empty() {
            sound += 1;
            let again = read(&first.canonical());
            let words = |read: &Reading| {
                read.lexed.tokens.iter().map(|token| token.text.to_string()).collect::<Vec<_>>()
            };
            assert_eq!(words(&again), words(&first), "{text}");
            assert!(again.is_canonical, "{text}");
        }
    }
    assert!(sound > 100, "{sound}");
}

/// Long texts are read in time proportional to their length.
#[test]
fn long_texts_are_read() {
    let many = |count: usize, item: &dyn Fn(usize) -> String| (0..count).map(item).collect::<String>();
    let texts = [
        many(20_000, &|k| format!("x{k}' = x{k}\n")),
        many(5_000, &|k| format!("x{k}'' = -x{k}'\n")),
        many(5_000, &|k| format!("a{k} = {k}\n")) + "x' = a1",
        many(300, &|k| format!("a{k} = a{}*x\n", k + 1)) + "a300 = x\nx' = a0",
        many(40, &|k| format!("a{} = a{k}*a{k}\n", k + 1)) + "a0 = x + x\nx' = a40",
        format!("x{} = 1", "'".repeat(100_000)),
        format!("x' = {}x", "sqrt(".repeat(20_000)),
        format!("x' = {}", many(5_000, &|k| format!("sqrt({k}) + "))),
        format!("x' = {}", "+".repeat(100_000)),
        format!("x' = {}", "2x ".repeat(50_000)),
        "Eq(".repeat(50_000),
        "x' = \n".repeat(30_000),
        "{[(".repeat(30_000),
    ];
    for text in texts {
        let read = read(&text);
        assert!(read.lexed.tokens.len() < 1_000_000);
        let _ = mistakes(&read.lexed.tokens);
    }
}
