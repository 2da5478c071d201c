//! Equations in many notations.

use serde_json::json;

use crate::running::{answer, kahan, refusal, text};

const LORENZ: &str = "par s=10,r=28,b=8/3\ninit x=1,y=1,z=1\nx'=s*(y-x)\ny'=r*x-y-x*z\nz'=x*y-b*z\ndone";

fn printed(arguments: &[&str]) -> String {
    let run = kahan(arguments);
    assert_eq!(run.status.code(), Some(0), "{arguments:?}: {}", text(&run.stderr));
    text(&run.stdout)
}

#[test]
fn one_field_in_other_manners_has_the_same_answers() {
    let strict = answer(&["show", "--field", "xdot = a*y; ydot = -x - x^2;"]);
    for field in [
        "x' = a*y\ny' = -x - x**2",
        "# a comment\ndx/dt = a·y, dy/dt = −x − x²",
        "Eq(Derivative(x(t), t), a*y(t)), Eq(Derivative(y(t), t), -x(t) - x(t)**2)",
        "\\dot{x} = a*y, \\dot{y} = -x - x^2",
        "a = 3; p = x + x^2; x'[t] == a*y[t]; y'[t] == -p",
    ] {
        assert_eq!(printed(&["show", "--field", field]), strict, "{field}");
    }
}

#[test]
fn the_language_is_what_is_printed() {
    let block = printed(&["show", "--macro", "--field", LORENZ]);
    assert!(block.contains("ydot = -y - x*z + r*x;") && !block.contains("par"), "{block}");
    let expanded = answer(&["show", "--expand", "--field", "x' = y, y' = -x"]);
    assert!(expanded.contains("fn field("), "{expanded}");
}

#[test]
fn values_and_first_points_of_a_text_serve_where_none_are_given() {
    let steps = ["--eps", "1/100", "--steps", "1"];
    let orbit = |more: &[&str]| {
        let run = kahan(&[&["orbit", "--field", LORENZ][..], &steps, more].concat());
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        (text(&run.stdout), text(&run.stderr))
    };
    let strict = "xdot = s*(y-x); ydot = r*x-y-x*z; zdot = x*y-b*z;";
    let of_strict = |values: [&str; 3], at: &str| {
        let parameters = values.map(|value| ["--param", value]).concat();
        answer(&[&["orbit", "--field", strict][..], &steps, &parameters, &["--at", at]].concat())
    };
    let (rows, notes) = orbit(&[]);
    assert_eq!(rows, of_strict(["s=10", "r=28", "b=8/3"], "1,1,1"));
    assert_eq!(
        notes,
        "note: the text gives s = 10, r = 28, b = 8/3 where numbers are needed; --param gives others\n\
         note: the text gives x = 1, y = 1, z = 1 at the beginning; --at gives another point\n"
    );
    let (rows, notes) = orbit(&["--param", "r=1/2", "--at", "1,2,3"]);
    assert_eq!(rows, of_strict(["s=10", "r=1/2", "b=8/3"], "1,2,3"));
    assert!(notes.starts_with("note: the text gives s = 10, b = 8/3 where"), "{notes}");
    let evaluated = printed(&["eval", "--field", LORENZ, "--eps", "1", "--json"]);
    let object: serde_json::Value = serde_json::from_str(&evaluated).expect("one object");
    assert_eq!(object["x"], json!(["1", "1", "1"]));
    assert_eq!(object["parameters"]["b"], "8/3");
}

#[test]
fn a_name_that_may_be_a_product_is_noted() {
    let run = kahan(&["show", "--field", "x' = x - xy, y' = -y"]);
    let note = "note: xy is taken as a parameter: nothing defines xydot; for a product write x*y\n";
    assert_eq!(text(&run.stderr), note);
}

#[test]
fn what_has_no_first_value_asks_for_a_point() {
    let paragraph = refusal(&["orbit", "--field", "x' = y, y' = -x, x(0) = 1", "--eps", "1", "--steps", "1"]);
    assert!(paragraph.contains("--at x,y"), "{paragraph}");
}

#[test]
fn mistakes_stand_at_their_place_in_the_text() {
    let paragraph = refusal(&["show", "--field", "x' = y\n  - 3*y'\ny' = -x"]);
    assert!(paragraph.contains("--> --field:2:8") && paragraph.contains("2 |   - 3*y'"), "{paragraph}");
    let paragraph = refusal(&["show", "--field", "k1, A + B --> C"]);
    assert!(paragraph.contains("--field:1:12") && paragraph.contains("docs/how-to/texts.md"), "{paragraph}");
}
