//! Crossings and jumps of random fields, planes and starts agree with dense samples of each step.
//!
//! This command tests 2000 random cases: `cargo test -p kahan-study --test sections -- --ignored`

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_core::{Step, Workspace};
use kahan_runtime::MapAt;
use kahan_study::{Direction, Plane, Section, Study, Subject, Systems, Unwatched};

const STEPS: u64 = 80;
/// At a crossing, the absolute value of the section's formula is at most this fraction of its
/// larger absolute value at the two ends of the step.
const SMALL: f64 = 1.0 / (1 << 17) as f64;
/// The number of samples of a step.
const SAMPLES: usize = 128;

#[derive(Debug, Default)]
struct Tally {
    crossings: usize,
    jumps: u64,
    /// The number of steps whose samples show that the section's formula passes through 0 smoothly.
    smooth: usize,
}

#[derive(Debug)]
struct Crossing {
    step: u64,
    part: f64,
    point: Vec<f64>,
}

fn number(random: &mut SplitMix64, most: i64, parts: i64) -> Rational {
    Rational::new(random.below((2 * most * parts + 1) as u64) as i64 - most * parts, parts)
}

/// Draws a quadratic field in two or three variables, with a few terms.
fn field(random: &mut SplitMix64, variables: &[&str]) -> String {
    let mut monomials: Vec<String> = variables.iter().map(|name| (*name).to_owned()).collect();
    for (k, one) in variables.iter().enumerate() {
        monomials.extend(variables[k..].iter().map(|other| format!("{one}*{other}")));
    }
    let equation = |name: &&str| {
        let mut terms = vec![format!("({})", number(random, 2, 8))];
        for _ in 0..3 {
            let monomial = &monomials[random.below(monomials.len() as u64) as usize];
            terms.push(format!("({})*{monomial}", number(random, 2, 8)));
        }
        format!("{name}dot = {};", terms.join(" + "))
    };
    variables.iter().map(equation).collect()
}

/// Draws a polynomial, a quotient with poles, or a function that jumps or is undefined somewhere.
fn plane(random: &mut SplitMix64, variables: &[&str]) -> String {
    let mut linear = || {
        let one = variables[random.below(variables.len() as u64) as usize];
        let other = variables[random.below(variables.len() as u64) as usize];
        format!("({one} + ({})*{other} + ({}))", number(random, 2, 4), number(random, 2, 16))
    };
    let [a, b, c] = [linear(), linear(), linear()];
    let forms = [
        a.clone(),
        format!("{a}*{b} + {c}"),
        format!("{a}^2 - 1/4"),
        format!("{a}^3"),
        format!("1/{a}"),
        format!("1/{a}^3"),
        format!("{a}/{b}"),
        format!("{a}/({b}*{c})"),
        format!("{a} - 1/{b}"),
        format!("tan({a})"),
        format!("{a}/abs({a})"),
        format!("floor({a}) + 1/2"),
        format!("log({a})"),
        format!("sqrt({a}) - 1/2"),
        format!("exp(1/{a}) - 2"),
        format!("atan(1/{a})"),
        format!("{a}*{b}/{b}"),
        format!("sin(9*{a})"),
    ];
    forms[random.below(forms.len() as u64) as usize].clone()
}

/// Returns whether repeatedly refined samples show a continuous function that passes through 0.
fn is_smooth(at: &MapAt<f64>, height: &dyn Fn(&[f64]) -> f64, ends: [&[f64]; 2]) -> bool {
    let (mut workspace, eps) = (Workspace::new(), *Step::eps(at));
    let size = ends.map(|x| height(x).abs()).into_iter().fold(0.0, f64::max);
    let is_near = |x: &[f64]| {
        let most = |k: usize| 8.0 * ends[0][k].abs().max(ends[1][k].abs());
        x.iter().enumerate().all(|(k, x)| x.abs() <= most(k))
    };
    let (mut low, mut high) = (0.0, 1.0);
    for level in 0..4 {
        // Each refinement divides the differences between neighbouring samples of a smooth function
        // by about 128. This test only requires a factor of 64.
        let most = size / 8.0 / 64_f64.powi(level);
        let part = |k: usize| low + (high - low) * k as f64 / SAMPLES as f64;
        let points = (0..=SAMPLES).map(|k| match part(k) {
            1.0 => ends[1].to_vec(),
            part => {
                let mut x = ends[0].to_vec();
                at.part(&(eps * part), &mut x, &mut workspace).expect("floats go on");
                x
            }
        });
        let points: Vec<Vec<f64>> = points.collect();
        let heights: Vec<f64> = points.iter().map(|x| height(x)).collect();
        let is_continuous = heights.windows(2).all(|pair| (pair[1] - pair[0]).abs() <= most);
        if !is_continuous || !points.iter().all(|x| is_near(x)) {
            return false;
        }
        let change = heights.windows(2).position(|pair| (pair[0] < 0.0) != (pair[1] < 0.0));
        let Some(change) = change else { return false };
        (low, high) = (part(change), part(change + 1));
    }
    true
}

/// Asks for the section of a random field, plane and start, and checks each of its steps.
fn check(seed: u64, tally: &mut Tally) {
    let mut random = SplitMix64::new(seed);
    let variables = &["x", "y", "z"][..2 + random.below(2) as usize];
    let text = field(&mut random, variables);
    let plane = plane(&mut random, variables);
    let eps = [[1, 100], [1, 20], [-1, 20], [1, 7], [-1, 3]][random.below(5) as usize];
    let eps = Rational::new(eps[0], eps[1]);
    let start: Vec<Rational> = variables.iter().map(|_| number(&mut random, 1, 64)).collect();
    let case = format!("{seed}: {text} from {start:?}, eps = {eps}, plane {plane}");
    let study: Study = Subject::text(&text).study(&Systems).expect("a field");
    let asked =
        Section { direction: Direction::Both, ..Section::new(eps.clone(), start.clone(), STEPS, &plane) };
    let Ok(found) = asked.ask(&study, &Unwatched) else { return };

    let at: MapAt<f64> = study.map().expect("no parameters").at(eps.to_f64());
    let read = Plane::of(study.system(), &[], &eps, &plane).expect("a plane");
    let height = read.height(&at);
    let mut x: Vec<f64> = start.iter().map(Rational::to_f64).collect();
    let crossing = |row: usize| Crossing {
        step: found.steps()[row] as u64,
        part: found.times()[row] / (2.0 * eps.to_f64()) - found.steps()[row] as f64,
        point: found.point(row),
    };
    let (mut workspace, mut changes) = (Workspace::new(), 0);
    let mut crossings = (0..found.count()).map(crossing).peekable();
    for step in 0..found.orbit().steps {
        let before = x.clone();
        Step::advance(&at, &mut x, 1, &mut workspace).expect("floats go on");
        let [from, to] = [&before, &x].map(|x| height(x));
        let crossing = crossings.next_if(|crossing| crossing.step == step);
        if !((from < 0.0 && to >= 0.0) || (from > 0.0 && to <= 0.0)) {
            assert!(crossing.is_none(), "{case}: no sign change in step {step}");
            continue;
        }
        changes += 1;
        let size = [from, to].map(f64::abs).into_iter().filter(|size| size.is_finite()).fold(0.0, f64::max);
        if let Some(crossing) = &crossing {
            tally.crossings += 1;
            assert!(crossing.point.iter().all(|x| x.is_finite()), "{case}: {crossing:?}");
            assert!(height(&crossing.point).abs() <= SMALL * size, "{case}: {crossing:?} of {size}");
            assert!(crossing.part > 0.0 && crossing.part <= 1.0, "{case}: {crossing:?}");
        }
        if is_smooth(&at, &height, [&before, &x]) {
            tally.smooth += 1;
            assert!(crossing.is_some(), "{case}: step {step} from {before:?} goes through 0 smoothly");
        }
    }
    assert!(crossings.next().is_none(), "{case}");
    let (crossings, jumps) = (found.count() as u64, found.orbit().jumps);
    assert_eq!(crossings + jumps, changes, "{case}");
    tally.jumps += jumps;
}

fn checked(seeds: std::ops::Range<u64>) -> Tally {
    let mut tally = Tally::default();
    seeds.for_each(|seed| check(seed, &mut tally));
    println!("{tally:?}");
    tally
}

#[test]
fn reported_crossings_are_zeros_and_smooth_zeros_are_reported() {
    let Tally { crossings, jumps, smooth } = checked(0..150);
    assert!(crossings > 300 && jumps > 300 && smooth > 100, "{crossings} {jumps} {smooth}");
}

#[test]
#[ignore = "takes long; see the head of this file"]
fn two_thousand_sections_have_zeros_only() {
    checked(0..2000);
}
