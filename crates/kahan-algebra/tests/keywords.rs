//! Tests that synonyms of keywords lead to one suggestion.

use kahan_algebra::{lexer, read};

/// Returns the message, the help and the place of the only mistake.
fn mistake(item: &str) -> (String, String, String) {
    let text = format!("xdot = y; ydot = -x; {item} integral Last = x^2 + y^2;");
    let lexed = lexer::lex(&text);
    let read = read(&lexed.tokens);
    let diagnostics = read.diagnostics();
    let [diagnostic] = diagnostics else { panic!("one mistake in {item}: {diagnostics:?}") };
    assert_eq!(diagnostic.span.first, diagnostic.span.last, "{item}");
    let word = lexed.tokens[diagnostic.span.first].text.to_string();
    (diagnostic.message.clone(), diagnostic.help.clone(), word)
}

#[test]
fn the_keyword_that_is_meant_is_suggested() {
    for (item, help) in [
        ("invariant H = x^2;", "did you mean `integral H = …;`?"),
        ("first_integral H = x^2;", "did you mean `integral H = …;`?"),
        ("first integral H = x^2 + y^2;", "did you mean `integral H …`?"),
        ("conserved E = x^2 when eps = 1;", "did you mean `integral E = …;`?"),
        ("Integral H = x^2;", "did you mean `integral H = …;`?"),
        ("integrals H = x^2;", "did you mean `integral H = …;`?"),
        ("measure mu = 1;", "did you mean `density mu = …;`?"),
        ("invariant_measure mu = 1;", "did you mean `density mu = …;`?"),
        ("densty mu = 1;", "did you mean `density mu = …;`?"),
        ("poisson P { {x,y} = 1; }", "did you mean `bracket P { {x,y} = …; }`?"),
        ("poisson bracket P { {x,y} = 1; };", "did you mean `bracket P …`?"),
        ("brackets P { {x,y} = 1; }", "did you mean `bracket P { {x,y} = …; }`?"),
        ("recurrence L = x by L;", "did you mean `drift L = … by …;`?"),
        ("let c = 1;", "did you mean `const c = …;`?"),
        ("constant c = 1/2;", "did you mean `const c = …;`?"),
        ("parameter mu;", "parameters stand in the header: `struct Name { mu }`"),
    ] {
        let word = item.split_whitespace().next().unwrap();
        let expected = (format!("`{word}` is no keyword of the language"), help.to_owned(), word.to_owned());
        assert_eq!(mistake(item), expected, "{item}");
    }
}

#[test]
fn what_is_built_on_it_is_no_second_mistake() {
    mistake("invariant H = x^2; integral G = H + 1;");
    mistake("let c = 1; integral G = c*(x^2 + y^2);");
}

#[test]
fn other_words_are_left_hand_sides() {
    for item in ["velocity = 2;", "velocity of = 2;", "x y = 2;"] {
        let (message, ..) = mistake(item);
        assert!(message.contains("is no left-hand side"), "{item}: {message}");
    }
}
