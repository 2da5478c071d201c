use super::blocks;

const FILE: &str = r##"//! kahan! { not this }
use kahan_core::prelude::*;
/* nor /* this */ kahan! { xdot = x; } */
const TEXT: &str = "kahan! { no }"; const RAW: &str = r#"kahan! { " }"#;
const QUOTE: char = '"'; const HIDDEN: char = '\''; fn f<'a>(x: &'a str) {}
kahan! {
    /// A doc comment with a }.
    pub struct First { a }
    xdot = a*x;
}
mod inner {
    kahan_core::kahan!(struct Second; xdot = x; bracket P { {x,y} = 1; });
    fn g() { let mut field = kahan![ydot = y;]; kahan ! { zdot = z; }; kahan(); }
}
"##;

#[test]
fn every_call_is_found_and_nothing_else() {
    let found = blocks(FILE);
    let names: Vec<Option<&str>> = found.iter().map(|block| block.name.as_deref()).collect();
    assert_eq!(names, [Some("First"), Some("Second"), Some("field"), None]);
    assert_eq!(found.iter().map(|block| block.line).collect::<Vec<_>>(), [6, 12, 13, 13]);
    let inside: Vec<&str> = found.iter().map(|block| FILE[block.range.clone()].trim()).collect();
    assert!(inside[0].starts_with("/// A doc") && inside[0].ends_with("xdot = a*x;"), "{}", inside[0]);
    assert!(inside[1].ends_with("{x,y} = 1; }"), "{}", inside[1]);
    assert_eq!(inside[2..], ["ydot = y;", "zdot = z;"]);
}

#[test]
fn a_text_need_not_be_rust() {
    for text in [
        "# Kahan's\n`x` ```rust\nkahan! { xdot = x; }\n``` that's \" all",
        "} kahan! { xdot = x; } (",
        "wrap! { kahan! { xdot = x; } }",
    ] {
        let found = blocks(text);
        assert_eq!(found.len(), 1, "{text}");
        assert_eq!(&text[found[0].range.clone()], " xdot = x; ", "{text}");
    }
}

#[test]
fn what_is_not_closed_ends_with_the_file() {
    for text in ["kahan! { xdot = x;", "kahan!{", "a /* b", "\"c", "r#\"d", "'", "'\\", "kahan", "kahan!"] {
        assert!(blocks(text).iter().all(|block| block.range.end == text.len()), "{text}");
    }
    assert!(blocks("xdot = y; ydot = -x;").is_empty());
}
