//! Growth classes of systems of the catalog.

use kahan_runtime::heights::{DiophantineTest, Growth};

use crate::support::{catalog, orbit};

#[test]
fn the_other_systems_grow_as_the_paper_says() {
    let start = "3/7,11/13,23/47";
    let cases = [
        ("e1", "", Growth::Logarithmic),
        ("e2", "", Growth::Logarithmic),
        ("e5", "", Growth::Linear),
        ("euler", "1,2,-3", Growth::Quadratic),
        ("e9", "1", Growth::Linear),
        ("e9", "-1", Growth::Quadratic),
        ("e7", "1", Growth::Logarithmic),
    ];
    for (name, parameters, growth) in cases {
        let steps = if growth == Growth::Quadratic { 40 } else { 200 };
        let survey = DiophantineTest::of(&mut orbit(&catalog(name), parameters, "1/2", start), steps);
        assert_eq!(survey.growth, growth, "{name} {parameters}");
        assert_eq!(survey.entropy, 0.0, "{name}");
        assert_eq!(survey.stopped, None);
    }
}
