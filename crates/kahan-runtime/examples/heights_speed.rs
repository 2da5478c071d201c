//! Times four Diophantine tests of the paper, and prints the best of three times for each.
//!
//! `cargo run --release -p kahan-runtime --example heights_speed`

use std::time::Instant;

use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::{read, system::System};
use kahan_runtime::heights::{DiophantineTest, Heights, HeightsOrbit};

struct Test {
    system: &'static str,
    parameters: &'static [&'static str],
    eps: &'static str,
    start: &'static [&'static str],
    steps: u64,
    limit: f64,
}

const TESTS: [Test; 4] = [
    Test { system: "lv", parameters: &[], eps: "9/14", start: &["1/2", "5/3"], steps: 17, limit: 1.0 },
    Test {
        system: "e9",
        parameters: &["-1/2"],
        eps: "1/2",
        start: &["2/5", "7/3", "11/13"],
        steps: 11,
        limit: 1.0,
    },
    Test {
        system: "e4",
        parameters: &[],
        eps: "1/2",
        start: &["7/3", "11/13", "23/47"],
        steps: 125,
        limit: 9.0,
    },
    Test {
        system: "e7",
        parameters: &["19/17"],
        eps: "1/2",
        start: &["3/7", "11/13", "23/47"],
        steps: 2000,
        limit: 5.0,
    },
];

fn main() {
    println!(
        "{:8}{:>6}{:>10}{:>14}{:>12}{:>10}",
        "system", "steps", "digits", "growth", "best of 3", "limit"
    );
    for test in &TESTS {
        let entry = kahan_systems::registry::find(test.system).expect("a system of the catalog");
        let system = read(&lex(entry.text()).tokens).system().expect("a system");
        let (mut best, mut survey) = test.run(&system);
        for _ in 1..3 {
            let (seconds, again) = test.run(&system);
            best = best.min(seconds);
            survey = again;
        }
        let digits = survey.heights.last().map_or(0, Heights::longest);
        println!(
            "{:8}{:>6}{digits:>10}{:>14}{best:>10.3} s{:>8} s",
            test.system, test.steps, survey.growth, test.limit
        );
    }
}

impl Test {
    fn run(&self, system: &System) -> (f64, DiophantineTest) {
        let number = |text: &&str| Rational::parse(text).expect("a number");
        let numbers = |texts: &[&'static str]| texts.iter().map(number).collect::<Vec<_>>();
        let begun = Instant::now();
        let mut orbit =
            HeightsOrbit::new(system, &numbers(self.parameters), &number(&self.eps), &numbers(self.start))
                .expect("the field is defined");
        let survey = DiophantineTest::of(&mut orbit, self.steps);
        assert_eq!(survey.heights.len() as u64, self.steps + 1, "{:?}", survey.stopped);
        (begun.elapsed().as_secs_f64(), survey)
    }
}
