//! Checks that rustc and the `kahan` command report the same mistakes in the same lines and
//! columns. The blocks are those of the compile-error cases.

mod cases;

use std::ops::Range;

use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::render::report;
use kahan_algebra::token::Token;

use cases::{CompileCase, compile_cases};

/// Returns the tokens that rustc passes to the macro. Rustc splits `**` into two stars, and `.5`
/// into a point and a number.
fn tokens_of_rust(text: &str) -> Vec<(Token, Range<usize>)> {
    let Lexed { tokens, ranges, .. } = lex(text);
    let split = |(token, range): (Token, Range<usize>)| {
        let own = &text[range.clone()];
        if own != "**" && (own.len() == 1 || !own.starts_with('.')) {
            return vec![(token, range)];
        }
        let [first, second] = [&own[..1], &own[1..]].map(|part| lex(part).tokens[0].clone());
        let first = (Token { touches_next: true, ..first }, range.start..range.start + 1);
        let second = Token { touches_next: token.touches_next, ..second };
        vec![first, (second, range.start + 1..range.end)]
    };
    tokens.into_iter().zip(ranges).flat_map(split).collect()
}

/// Returns each mistake as `<line>:<column>`, as rustc prints it, and the lines of its message.
fn mistakes(case: &CompileCase) -> Vec<(Option<String>, Vec<String>)> {
    let mut mistakes = Vec::new();
    for block in &case.blocks {
        let text = &case.source[block.clone()];
        let (tokens, ranges): (Vec<_>, Vec<_>) = tokens_of_rust(text).into_iter().unzip();
        for diagnostic in kahan_algebra::read(&tokens).diagnostics() {
            let place = ranges.get(diagnostic.span.first).map(|range| {
                let (line, column) = case.line_and_column(block.start + range.start);
                format!("{line}:{column}")
            });
            let lines: Vec<String> = diagnostic.to_string().lines().map(str::to_owned).collect();
            let paragraph = report(diagnostic, text, &ranges, "--field");
            for line in &lines {
                assert!(paragraph.contains(line.as_str()), "{}: the command leaves out {line}", case.name);
            }
            mistakes.push((place, lines));
        }
    }
    mistakes
}

/// Returns all cases except lifted blocks, which are parsed differently.
fn ordinary_cases() -> impl Iterator<Item = CompileCase> {
    compile_cases().into_iter().filter(|case| !case.name.starts_with("lifts/"))
}

#[test]
fn rustc_prints_every_mistake_of_the_front_end_at_its_place() {
    for case in ordinary_cases() {
        for (place, lines) in mistakes(&case) {
            let place = place.map(|place| format!("{}.rs:{place}\n", case.name));
            assert!(
                place.as_ref().is_none_or(|place| case.expected.contains(place)),
                "{}: rustc prints nothing at {place:?}",
                case.name
            );
            for line in lines {
                assert!(case.expected.contains(&line), "{}: rustc does not print: {line}", case.name);
            }
        }
    }
}

#[test]
fn rustc_prints_nothing_else() {
    let mut all = 0;
    for case in ordinary_cases() {
        let found = mistakes(&case).len();
        all += found;
        if found > 0 {
            let printed = case.expected.lines().filter(|line| line.starts_with("error"));
            assert_eq!(printed.count(), found, "{}:\n{}", case.name, case.expected);
        }
    }
    assert!(all >= 50, "{all} mistakes");
}
