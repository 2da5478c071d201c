//! Compares derivatives and cycles with closed forms.

use std::ops::ControlFlow;

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::{Complex, ComplexField};
use kahan_dynamics::periodic::{
    Branch, BranchChange, ChangePoint, Differentiable, Parametric, Stability, branch, periodic_point,
};

use crate::Field;

fn polynomial(coefficients: &[(i64, i64)]) -> Polynomial {
    let term = |(power, &(above, below)): (u32, &(i64, i64))| {
        (Monomial::power(Variable(0), power), Rational::new(above, below))
    };
    Polynomial::from_terms((0..).zip(coefficients).map(term))
}

#[test]
fn equilibria_of_the_flow_are_fixed_points_of_the_map() {
    // The field has equilibria at x = 1/3 and x = −2, with y = x − 1/3.
    let map = Field::parse("xdot = (3*x - 1)*(x + 2); ydot = x - 1/3 - y;").unwrap().map().unwrap();
    let eps = Rational::new(1, 9);
    for (start, x, y) in [
        ([0.3, 0.1], Rational::new(1, 3), Rational::zero()),
        ([-1.9, -2.0], Rational::new(-2, 1), Rational::new(-7, 3)),
    ] {
        let cycle = periodic_point(&map.at(eps.to_f64()), &start, 1).unwrap();
        assert_eq!(map.rational_cycle(&eps, &cycle).unwrap().points, [[x, y]]);
    }
}

#[test]
fn a_rational_cycle_of_three_is_proved() {
    // In one variable the map is a Möbius transformation. At ε = 1 its matrix is similar to a
    // multiple of the rotation by arctan(ε√3) = π/3, so the map has order 3.
    let map = Field::parse("xdot = x^2 + x + 1;").unwrap().map().unwrap();
    let eps = Rational::one();
    let at = map.at(1.0);
    let cycle = periodic_point(&at, &[0.2], 3).unwrap();
    assert_eq!((cycle.points.len(), cycle.family), (3, 1));
    let proved = map.rational_cycle(&eps, &cycle).unwrap();
    let points = [(1, 5), (-6, 1), (-5, 6)].map(|(above, below)| [Rational::new(above, below)]);
    assert_eq!(proved.points, points);
    assert_eq!((proved.polynomial, proved.stability), (polynomial(&[(-1, 1), (1, 1)]), Stability::Neutral));
}

#[test]
fn derivatives_by_eps_and_by_parameters_are_those_of_the_formulas() {
    // With the polarised field F, the map satisfies (x̃ − x)/2ε = F(x,x̃). Its derivatives satisfy
    // A(x,ε) ∂x̃/∂ε = (x̃ − x)/ε and, for a parameter p, A(x,ε) ∂x̃/∂p = 2ε ∂F/∂p.
    let text = "xdot = r*x*y + s; ydot = y - x^2/r;";
    let map = Field::parse(text).unwrap().with([("r", 0.75), ("s", 1.5)]).unwrap();
    let (eps, x) = (0.125, [0.5, -0.25]);
    let at = map.at(eps);
    let next = at.image(&x);
    let mut rows = [0.0; 4];
    at.matrix(&x, &mut rows).unwrap();
    let moved = [next[0] - x[0], next[1] - x[1]];
    let by_r = [(x[0] * next[1] + next[0] * x[1]) / 2.0, x[0] * next[0] / (0.75 * 0.75)];
    let expected = [
        (None, moved.map(|entry| entry / eps)),
        (Some(0), by_r.map(|entry| 2.0 * eps * entry)),
        (Some(1), [2.0 * eps, 0.0]),
    ];
    for (parameter, right) in expected {
        let slope = at.by(parameter).by_parameter(&x);
        for i in 0..2 {
            let left = rows[2 * i] * slope[0] + rows[2 * i + 1] * slope[1];
            assert!((left - right[i]).abs() < 1e-15 * 4.0, "{parameter:?}: {left} for {}", right[i]);
        }
    }
}

#[test]
fn the_derivative_by_eps_goes_through_elimination_too() {
    let equation = |i: usize| format!("x{i}dot = x{i}*x{} - x{}/2 + 1/3;", (i + 1) % 10, (i + 7) % 10);
    let map = Field::parse(&(0..10).map(equation).collect::<String>()).unwrap().map().unwrap();
    let (eps, x) = (0.125, [0.5, -0.25, 1.0, 0.75, -0.5, 0.25, -1.0, 0.125, 0.375, 0.625]);
    let at = map.at(eps);
    let (next, slope) = (at.image(&x), at.by(None).by_parameter(&x));
    let mut rows = [0.0; 100];
    at.matrix(&x, &mut rows).unwrap();
    for (i, row) in rows.chunks(10).enumerate() {
        let left: f64 = row.iter().zip(&slope).map(|(entry, slope)| entry * slope).sum();
        assert!((left - (next[i] - x[i]) / eps).abs() < 1e-14, "{i}: {left}");
    }
}

#[test]
fn a_cycle_between_fractions_is_not_taken_for_one_of_fractions() {
    let map = Field::parse("xdot = x^2 - 2;").unwrap().map().unwrap();
    let cycle = periodic_point(&map.at(0.25), &[1.4], 1).unwrap();
    assert!((cycle.points[0][0] - 2f64.sqrt()).abs() < 1e-15);
    assert_eq!(map.rational_cycle(&Rational::new(1, 4), &cycle), None);
}

#[test]
fn derivatives_along_a_cycle_are_multiplied_in_its_order() {
    // The map is linear in (y, z). Its matrix depends on x, so it changes along the cycle.
    let text = "xdot = x^2 + x + 1; ydot = x*z + y; zdot = x*y/2 - 2*z - y;";
    let map = Field::parse(text).unwrap().map().unwrap();
    let at = map.at(1.0);
    let cycle = periodic_point(&at, &[0.2, 0.0, 0.0], 3).unwrap();
    let after_three = |x: &[f64]| (0..3).fold(x.to_vec(), |x, _| at.image(&x));
    let [first, second] = [after_three(&[0.2, 1.0, 0.0]), after_three(&[0.2, 0.0, 1.0])];
    let (trace, determinant) = (first[1] + second[2], first[1] * second[2] - first[2] * second[1]);
    let expected = [-determinant, determinant + trace, -(1.0 + trace), 1.0];
    let proved = map.rational_cycle(&Rational::one(), &cycle).unwrap().polynomial;
    let [a, b, c] = cycle.multipliers[..] else { panic!("three") };
    let found = [-(a * b * c), a * b + a * c + b * c, -(a + b + c), Complex::new(1.0, 0.0)];
    for ((k, expected), found) in (0..).zip(expected).zip(found) {
        let exact = proved.coefficient(&Monomial::power(Variable(0), k)).to_f64();
        let bound = 1e-13 * (1.0 + determinant.abs() + trace.abs());
        assert!(
            (exact - expected).abs() < bound && (found - expected).norm1() < bound,
            "{k}: {exact} {found}"
        );
    }
}

/// The Hénon–Heiles system; a is the square of the frequency of x.
const HENON_HEILES: &str = "xdot = p; ydot = q; pdot = -a*x - 2*x*y; qdot = -y - x^2 + y^2;";

/// Returns a cycle of three points of the Hénon–Heiles system in the plane x = p = 0.
///
/// The map takes (y, q) = (d, 0) to (b, c), then to (b, −c), and back to (d, 0). Here b = (ε² −
/// 3)/2ε², c = ε(b − b²) and d = b − εc.
fn cycle_of_three(eps: &Rational) -> [[Rational; 4]; 3] {
    let square = eps * eps;
    let b = (&square - &Rational::from(3)).checked_div(&(&square + &square)).unwrap();
    let c = eps * &(&b - &(&b * &b));
    let d = &b - &(eps * &c);
    let point = |y: &Rational, q: Rational| [Rational::zero(), y.clone(), Rational::zero(), q];
    [point(&d, Rational::zero()), point(&b, c.clone()), point(&b, -&c)]
}

#[test]
fn henon_and_heiles_have_a_rational_cycle_of_three_at_each_rational_eps() {
    let map = Field::parse(HENON_HEILES).unwrap().with([("a", 1)]).unwrap();
    for eps in [Rational::new(2, 1), Rational::new(1, 2), Rational::new(5, 3)] {
        let expected = cycle_of_three(&eps);
        let start = expected[0].each_ref().map(Rational::to_f64);
        let cycle = periodic_point(&map.at(eps.to_f64()), &start, 3).unwrap();
        let proved = map.rational_cycle(&eps, &cycle).unwrap();
        assert_eq!(proved.points, expected);
        // The map preserves a volume, and an area in the plane x = p = 0. Therefore the two
        // multipliers in this plane are a pair m, 1/m, and so are the other two.
        let coefficient = |k| proved.polynomial.coefficient(&Monomial::power(Variable(0), k));
        assert_eq!([coefficient(0), coefficient(1)], [coefficient(4), coefficient(3)]);
        assert_eq!(proved.stability, Stability::Saddle);
        let [a, b, c, d] = cycle.multipliers[..] else { panic!("four") };
        for product in [a * d, b * c] {
            assert!((product - Complex::new(1.0, 0.0)).norm1() < 1e-12, "{eps}: {product}");
        }
    }
    let plane = Field::parse("ydot = q; qdot = -y + y^2;").unwrap().map().unwrap();
    let cycle = periodic_point(&plane.at(2.0), &[-0.3, 0.01], 3).unwrap();
    let expected = polynomial(&[(1, 1), (-289, 120), (1, 1)]);
    assert_eq!(plane.rational_cycle(&Rational::from(2), &cycle).unwrap().polynomial, expected);
}

/// Returns whether a branch's bifurcations have these kinds, and parameters within the bounds.
fn has_turns(branch: &Branch, expected: &[(BranchChange, f64, f64)]) -> bool {
    let pairs = branch.turns.iter().zip(expected);
    let is_near = |(turn, (change, at, bound)): (&ChangePoint, &(BranchChange, f64, f64))| {
        turn.change == *change && (turn.parameter - at).abs() < *bound
    };
    branch.turns.len() == expected.len() && pairs.into_iter().all(is_near)
}

#[test]
fn a_cycle_of_henon_and_heiles_changes_its_stability_where_the_formula_says() {
    // At ε = 2, let m and 1/m be the multipliers transverse to the plane x = p = 0. Then m + 1/m −
    // 2 = (11 − 8a)(32a² − 8a + 3)/(2(2a + 1)²(8a − 3)). The multipliers leave the circle at a =
    // 11/8.
    let field = Field::parse(HENON_HEILES).unwrap();
    let map = |a: f64| field.with([("a", a)]).unwrap().at(2.0).by(Some(0));
    let start = cycle_of_three(&Rational::from(2))[0].each_ref().map(Rational::to_f64);
    for (from, to) in [(1.0, 2.0), (2.0, 1.0)] {
        let cycle = periodic_point(&map(from), &start, 3).unwrap();
        let branch = branch(map, &cycle, [from, to], 10, |_| ControlFlow::Continue(()));
        assert!(has_turns(&branch, &[(BranchChange::ThroughOne, 1.375, 1e-11)]), "{:?}", branch.turns);
    }
}

#[test]
fn the_lorenz_system_changes_where_the_flow_does() {
    // The map and the flow have the same equilibria. Multipliers (1 + ελ)/(1 − ελ) cross the circle
    // where eigenvalues λ cross the imaginary axis.
    let field = Field::parse("xdot = s*(y - x); ydot = r*x - y - x*z; zdot = x*y - b*z;").unwrap();
    let place = field.parameters().iter().position(|name| name == "r");
    let b = Rational::new(8, 3);
    let map = |r: f64| {
        let values = [("s", Rational::from(10)), ("b", b.clone()), ("r", Rational::from_f64(r).unwrap())];
        field.with(values).unwrap().at(0.01).by(place)
    };
    let origin = periodic_point(&map(0.5), &[0.0; 3], 1).unwrap();
    for steps in [1, 7] {
        let branch = branch(map, &origin, [0.5, 1.5], steps, |_| ControlFlow::Continue(()));
        assert!(has_turns(&branch, &[(BranchChange::ThroughOne, 1.0, 1e-13)]), "{:?}", branch.turns);
    }
    // At r = 1 the two equilibria other than the origin merge there, so their branch has a fold.
    let wing = periodic_point(&map(28.0), &[8.5, 8.5, 27.0], 1).unwrap();
    let branch = branch(map, &wing, [28.0, 0.5], 30, |_| ControlFlow::Continue(()));
    let hopf = (BranchChange::ThroughCircle, 470.0 / 19.0, 1e-9);
    // Equilibria satisfy x(r − 1 − x²/b) = 0. For x = 10⁻⁴, an error of 10⁻⁸ in r changes the
    // left-hand side by only 10⁻¹².
    let fold = (BranchChange::Fold, 1.0, 1e-7);
    assert!(has_turns(&branch, &[hopf, fold, hopf]), "{:?}", branch.turns);
    let last = branch.points.last().unwrap();
    assert!(last.parameter >= 28.0 && (last.cycle.points[0][2] - (last.parameter - 1.0)).abs() < 1e-10);
}

#[test]
fn cycles_of_maps_that_keep_a_volume_keep_it() {
    // The map preserves a measure, whose density is equal at both ends of a cycle, so the product
    // of the multipliers is 1. In two variables, the multipliers are thus m and 1/m.
    let plane = "xdot = y - x^2/3 + y^2; ydot = -x + 2*x*y/3 - x^2/2;";
    let top = "xdot = y*z; ydot = -2*x*z; zdot = x*y;";
    let cycles = [
        (plane, [0.3, 0.0].as_slice(), 7),
        (plane, &[0.4, -0.4], 8),
        (top, &[0.1, 1.7, 0.4], 5),
        (top, &[0.2, 1.6, 0.4], 6),
        (top, &[0.0, -1.8, 0.1], 7),
    ];
    for (text, start, period) in cycles {
        let map = Field::parse(text).unwrap().map().unwrap();
        let cycle = periodic_point(&map.at(0.5), start, period).unwrap();
        assert_eq!(cycle.points.len(), period, "{text}");
        let one = Complex::new(1.0, 0.0);
        let product = cycle.multipliers.iter().fold(one, |product, multiplier| product * multiplier);
        assert!((product - one).norm1() < 1e-12, "{text}: {product}");
    }
}

#[test]
fn rounding_of_multipliers_of_1_is_no_change() {
    // All multipliers of the cycle are 1, and its derivative is not diagonalisable.
    let top = Field::parse("xdot = y*z; ydot = -2*x*z; zdot = x*y;").unwrap().map().unwrap();
    let map = |eps: f64| top.at(eps).by(None);
    let cycle = periodic_point(&map(0.5), &[0.2, 1.6, 0.4], 7).unwrap();
    let branch = branch(map, &cycle, [0.5, 0.75], 20, |_| ControlFlow::Continue(()));
    assert!(branch.turns.is_empty() && !branch.is_cut, "{:?}", branch.turns);
    assert!(branch.points.iter().all(|point| point.cycle.stability() == Stability::Neutral));
}
