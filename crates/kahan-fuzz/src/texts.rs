//! Reads texts in many notations as fields.

use kahan_runtime::FieldText;

use crate::words::text;

const WORDS: &[&str] = &[
    "x",
    "y",
    "a",
    "t",
    "d",
    "i",
    "2x",
    "1",
    "0",
    "2.5e-1",
    "x' = ",
    "y'' = ",
    "x'",
    "dx/dt = ",
    "d^2y/dt^2 = ",
    "ẋ = ",
    "\\dot{y} = ",
    "\\frac{dx}{dt}",
    "der(x) = ",
    "D(x) ~ ",
    "diff(x(t), t) = ",
    "x'[t] == ",
    "Eq(Derivative(y(t), t), ",
    "xdot = ",
    "x(0) = ",
    "a = ",
    "b = ",
    "x = ",
    "par ",
    "init ",
    "done",
    "\n",
    "\n",
    ", ",
    "; ",
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
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "(t)",
    "[t]",
    "sqrt(2)",
    "sin(",
    "if",
    "# ",
    "#[",
    "// ",
    "/*",
    "*/",
    "const c = 2; ",
    "pub struct S { a } ",
    "for i in periodic { ",
    "x[i]dot = x[i+1]; ",
    "integral H = x^2 + y^2",
    " when a = 1, b = 2",
    "bracket P { {x,y} = 1; }",
    "drift F = 1/x by F - 2*eps",
    "*eps^2",
    "->",
    "'",
    "\"",
    "\\",
    "=",
];

/// Reads a text as a field, and checks that the printed field is read as an equal field.
pub fn read_text(bytes: &[u8]) {
    let Some(text) = text(bytes, WORDS) else { return };
    let given = FieldText::new(text, "field".to_owned());
    match given.unproved_system() {
        Ok(system) => {
            let canonical = FieldText::new(given.text().to_owned(), "field".to_owned());
            let again = canonical.unproved_system().unwrap_or_else(|mistakes| panic!("{mistakes}"));
            assert_eq!(again.field, system.field);
            assert_eq!(canonical.text(), canonical.given());
        }
        Err(mistakes) => assert!(!mistakes.to_string().is_empty()),
    }
}
