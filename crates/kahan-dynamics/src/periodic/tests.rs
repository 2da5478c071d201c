//! Tests periodic points that are known in closed form.

mod flow;

use kahan_core::nalgebra::DMatrix;
use std::ops::ControlFlow;

use kahan_core::prelude::*;
use kahan_core::{Dual, Step, Stopped, Workspace};

use super::{
    Branch, BranchChange, Differentiable, NoPeriodicPoint, Parametric, Stability, branch, periodic_point,
};

trait ByHand {
    const DIMENSION: usize;

    fn image(&self, x: &[f64]) -> Vec<f64>;
}

macro_rules! steps {
    ($($map:ty),*) => {$(
        impl Step for $map {
            type Scalar = f64;
            type State = Vec<f64>;

            fn dimension(&self) -> usize {
                Self::DIMENSION
            }

            fn eps(&self) -> &f64 {
                &1.0
            }

            fn advance(&self, x: &mut [f64], steps: u64, _: &mut Workspace) -> Result<(), Stopped> {
                (0..steps).for_each(|_| x.copy_from_slice(&ByHand::image(self, x)));
                Ok(())
            }

            fn part(&self, _: &f64, _: &mut [f64], _: &mut Workspace) -> Result<(), Stopped> {
                unreachable!("nobody looks between the points of a cycle")
            }
        }
    )*};
}

steps!(Logistic, Henon, SaddleNode, Fifth, Arctangent, Turning, Several, Meeting, Far, Linear);

/// The logistic map x ↦ r x (1 − x).
struct Logistic(f64);

impl ByHand for Logistic {
    const DIMENSION: usize = 1;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![self.0 * x[0] * (1.0 - x[0])]
    }
}

impl Differentiable for Logistic {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_element(1, 1, self.0 * (1.0 - 2.0 * x[0]))
    }
}

impl Parametric for Logistic {
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        vec![x[0] * (1.0 - x[0])]
    }
}

kahan! {
    /// The map is x̃ = (x + 2εa)/(1 + 2εx).
    struct Roots {
        a
    }
    xdot = a - x^2;
}

#[test]
fn maps_over_dual_numbers_know_how_they_depend_on_what_changes() {
    let (a, eps, x) = (0.75, 0.125, 0.5);
    let below = 1.0 + 2.0 * eps * x;
    let next = (x + 2.0 * eps * a) / below;
    let over_a = Roots { a: Dual::coordinate(a, 0) }.at(Dual::from_value(eps));
    let over_eps = Roots { a: Dual::from_value(a) }.at(Dual::coordinate(eps, 0));
    let by_eps = (2.0 * a - 2.0 * x * next) / below;
    for (map, expected) in [(over_a, 2.0 * eps / below), (over_eps, by_eps)] {
        assert!((map.image(&[x])[0] - next).abs() < 1e-15);
        assert!((map.derivative(&[x])[(0, 0)] - (1.0 - 2.0 * eps * next) / below).abs() < 1e-15);
        assert!((map.by_parameter(&[x])[0] - expected).abs() < 1e-15);
    }
}

/// Hénon's map (x, y) ↦ (1 − a x² + y, b x).
struct Henon(f64, f64);

impl ByHand for Henon {
    const DIMENSION: usize = 2;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![1.0 - self.0 * x[0] * x[0] + x[1], self.1 * x[0]]
    }
}

impl Differentiable for Henon {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(2, 2, &[-2.0 * self.0 * x[0], 1.0, self.1, 0.0])
    }
}

impl Parametric for Henon {
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        vec![-x[0] * x[0], 0.0]
    }
}

/// The map x ↦ x + p − x², which has a fold at p = 0.
struct SaddleNode(f64);

impl ByHand for SaddleNode {
    const DIMENSION: usize = 1;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![x[0] + self.0 - x[0] * x[0]]
    }
}

impl Differentiable for SaddleNode {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_element(1, 1, 1.0 - 2.0 * x[0])
    }
}

impl Parametric for SaddleNode {
    fn by_parameter(&self, _: &[f64]) -> Vec<f64> {
        vec![1.0]
    }
}

struct Fifth;

impl ByHand for Fifth {
    const DIMENSION: usize = 2;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        let image = self.derivative(x) * DMatrix::from_column_slice(2, 1, x);
        image.as_slice().to_vec()
    }
}

impl Differentiable for Fifth {
    fn derivative(&self, _: &[f64]) -> DMatrix<f64> {
        let (sin, cos) = (std::f64::consts::TAU / 5.0).sin_cos();
        DMatrix::from_row_slice(2, 2, &[cos, -sin, sin, cos])
    }
}

#[test]
fn cycles_of_the_logistic_map_are_those_of_the_formula() {
    let r = 3.3f64;
    let root = ((r + 1.0) * (r - 3.0)).sqrt();
    let cycle = periodic_point(&Logistic(r), &[0.8], 2).unwrap();
    let mut points: Vec<f64> = cycle.points.concat();
    points.sort_by(f64::total_cmp);
    assert!((points[0] - (r + 1.0 - root) / (2.0 * r)).abs() < 1e-13);
    assert!((points[1] - (r + 1.0 + root) / (2.0 * r)).abs() < 1e-13);
    let multiplier = 1.0 - (r + 1.0) * (r - 3.0);
    assert!((cycle.multipliers[0].re - multiplier).abs() < 1e-12 && cycle.family == 0);
    assert_eq!(cycle.stability(), Stability::Attracting);
    let fixed = periodic_point(&Logistic(r), &[1.0 - 1.0 / r + 1e-6], 4).unwrap();
    assert_eq!((fixed.points.len(), fixed.stability()), (1, Stability::Repelling));
}

#[test]
fn a_turn_of_a_fifth_has_a_family_of_cycles() {
    let cycle = periodic_point(&Fifth, &[1.0, 0.3], 5).unwrap();
    assert_eq!((cycle.points.len(), cycle.family, cycle.stability()), (5, 2, Stability::Neutral));
    assert!((cycle.points[0][0] - 1.0).abs() < 1e-12);
}

struct Linear([f64; 4]);

impl ByHand for Linear {
    const DIMENSION: usize = 2;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        let image = self.derivative(x) * DMatrix::from_column_slice(2, 1, x);
        image.as_slice().to_vec()
    }
}

impl Differentiable for Linear {
    fn derivative(&self, _: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(2, 2, &self.0)
    }
}

#[test]
fn a_multiplier_is_off_the_circle_only_beyond_its_error() {
    let turned = |[a, b, c, d]: [f64; 4]| {
        let (sin, cos) = 0.7_f64.sin_cos();
        let turn = DMatrix::from_row_slice(2, 2, &[cos, -sin, sin, cos]);
        let matrix = &turn * DMatrix::from_row_slice(2, 2, &[a, b, c, d]) * turn.transpose();
        Linear([matrix[(0, 0)], matrix[(0, 1)], matrix[(1, 0)], matrix[(1, 1)]])
    };
    let verdict = |matrix| periodic_point(&turned(matrix), &[0.0, 0.0], 1).unwrap().stability();
    for shear in [1.0, 1e2, 1e4, 1e6, 1e7] {
        assert_eq!(verdict([1.0, shear, 0.0, 1.0]), Stability::Neutral, "{shear}");
        assert_eq!(verdict([-1.0, shear, 0.0, -1.0]), Stability::Neutral, "{shear}");
    }
    for shear in [1.0, 1e2, 1e4] {
        assert_eq!(verdict([1.01, shear, 0.0, 1.0 / 1.01]), Stability::Saddle, "{shear}");
        assert_eq!(verdict([0.99, shear, 0.0, 0.98]), Stability::Attracting, "{shear}");
        assert_eq!(verdict([1.02, shear, 0.0, 1.01]), Stability::Repelling, "{shear}");
    }
    assert_eq!(verdict([1e9, 1.0, 0.0, 1e-9]), Stability::Saddle);
}

#[test]
fn a_cycle_is_the_same_in_every_unit() {
    let ordinary = periodic_point(&Fifth, &[1.0, 0.3], 5).unwrap();
    for exponent in [-900, -30, 30, 900] {
        let unit = f64::from(exponent).exp2();
        let cycle = periodic_point(&Fifth, &[unit, 0.3 * unit], 5).unwrap();
        let scaled: Vec<Vec<f64>> =
            ordinary.points.iter().map(|x| x.iter().map(|x| x * unit).collect()).collect();
        assert_eq!((cycle.points, cycle.residual), (scaled, ordinary.residual * unit));
        assert_eq!((cycle.family, cycle.multipliers), (2, ordinary.multipliers.clone()));
    }
    assert_eq!(periodic_point(&Fifth, &[1e-9, 0.0], 5).unwrap().points.len(), 5);
}

#[test]
fn a_cycle_at_0_is_as_near_to_it_as_its_start_is_large() {
    for exponent in [-900, 0, 900] {
        let start = f64::from(exponent).exp2();
        let cycle = periodic_point(&Meeting(0.125), &[start, 0.5 * start], 4).unwrap();
        assert_eq!((cycle.points.len(), cycle.size()), (1, start));
        assert!(cycle.points[0].iter().all(|x| x.abs() < 1e-15 * start), "{cycle:?}");
    }
    let cycle = periodic_point(&Meeting(0.125), &[0.0, 0.0], 4).unwrap();
    assert_eq!((cycle.points, cycle.residual, cycle.size), (vec![vec![0.0, 0.0]], 0.0, 0.0));
}

#[test]
fn a_branch_that_begins_at_0_is_the_same_in_every_unit() {
    // The fixed points of the map x̃ = x/2 + a − x²/unit are proportional to `unit` if a is.
    struct Root(f64, f64);

    impl ByHand for Root {
        const DIMENSION: usize = 1;

        fn image(&self, x: &[f64]) -> Vec<f64> {
            vec![0.5 * x[0] + self.0 - x[0] * (x[0] / self.1)]
        }
    }

    steps!(Root);

    impl Differentiable for Root {
        fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
            DMatrix::from_element(1, 1, 0.5 - 2.0 * (x[0] / self.1))
        }
    }

    impl Parametric for Root {
        fn by_parameter(&self, _: &[f64]) -> Vec<f64> {
            vec![1.0]
        }
    }

    let points = |unit: f64| -> Vec<[f64; 2]> {
        let map = |a| Root(a, unit);
        let start = periodic_point(&map(0.0), &[0.0], 1).unwrap();
        let branch = branch(map, &start, [0.0, unit], 10, |_| ControlFlow::Continue(()));
        branch.points.iter().map(|at| [at.parameter / unit, at.cycle.points[0][0] / unit]).collect()
    };
    let ordinary = points(1.0);
    assert!(ordinary.len() > 10);
    for exponent in [-500, 500] {
        assert_eq!(points(f64::from(exponent).exp2()), ordinary);
    }
}

/// The map x ↦ x + arctan x.
struct Arctangent;

impl ByHand for Arctangent {
    const DIMENSION: usize = 1;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![x[0] + x[0].atan()]
    }
}

impl Differentiable for Arctangent {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_element(1, 1, 1.0 + 1.0 / (1.0 + x[0] * x[0]))
    }
}

#[test]
fn steps_that_lead_away_are_halved() {
    // Newton's method without damping for arctan x = 0 diverges for starts with |x| ≥ 1.4.
    let fixed = periodic_point(&Arctangent, &[3.0], 1).unwrap();
    assert!(fixed.points[0][0].abs() < 1e-11);
}

#[test]
fn what_is_no_cycle_is_told() {
    assert_eq!(periodic_point(&Logistic(3.0), &[0.5], 0), Err(NoPeriodicPoint::Unfit));
    assert_eq!(periodic_point(&Logistic(3.0), &[0.5, 0.5], 1), Err(NoPeriodicPoint::Unfit));
    assert_eq!(periodic_point(&Logistic(3.0), &[f64::NAN], 1), Err(NoPeriodicPoint::NotFinite));
    let none = periodic_point(&Henon(-0.2, 0.3), &[0.0, 0.0], 1);
    assert!(matches!(none, Err(NoPeriodicPoint::NotFound { residual }) if residual > 1e-3), "{none:?}");
}

#[test]
fn a_branch_turns_back_where_two_fixed_points_meet() {
    for steps in [1, 3, 40] {
        let start = periodic_point(&SaddleNode(0.5), &[0.7], 1).unwrap();
        let branch = branch(SaddleNode, &start, [0.5, -0.5], steps, |_| ControlFlow::Continue(()));
        // The tangent at a fold has an error of about √u with the unit roundoff u. The parameter
        // has an error of about u.
        assert!(has_turns(&branch, &[(BranchChange::Fold, 0.0)], 1e-9), "{steps}: {:?}", branch.turns);
        let last = branch.points.last().unwrap();
        assert!(last.parameter >= 0.5 && last.cycle.points[0][0] < -0.7 && !branch.is_cut, "{steps}");
        for point in &branch.points {
            let x = point.cycle.points[0][0];
            assert!((x * x - point.parameter).abs() < 1e-10);
        }
    }
}

#[test]
fn a_period_doubles_where_a_multiplier_goes_through_minus_one() {
    let start = periodic_point(&Logistic(2.5), &[0.6], 1).unwrap();
    let branch = branch(Logistic, &start, [2.5, 3.4], 20, |_| ControlFlow::Continue(()));
    assert_eq!(branch.turns.len(), 1);
    assert_eq!(branch.turns[0].change, BranchChange::ThroughMinusOne);
    assert!((branch.turns[0].parameter - 3.0).abs() < 1e-12, "{:?}", branch.turns);
}

#[test]
fn a_pair_that_leaves_the_circle_is_found_where_it_does() {
    // The map preserves areas. At a = 3 the fixed point x = 1/3 has the double multiplier −1.
    let start = periodic_point(&Henon(1.0, -1.0), &[0.4, -0.4], 1).unwrap();
    assert_eq!(start.stability(), Stability::Neutral);
    let branch = branch(|a| Henon(a, -1.0), &start, [1.0, 4.0], 20, |_| ControlFlow::Continue(()));
    assert_eq!(branch.turns.len(), 1);
    assert_eq!(branch.turns[0].change, BranchChange::ThroughMinusOne);
    assert!((branch.turns[0].parameter - 3.0).abs() < 1e-10, "{:?}", branch.turns);
}

/// The map (x, y) ↦ (x + p − x², (x/2 − 9/8)·y).
///
/// The fixed points x² = p, y = 0 have the multipliers 1 − 2x and x/2 − 9/8. The first multiplier
/// is 1 at x = 0, a fold. The second multiplier is −1 at x = 1/4.
struct Turning(f64);

impl ByHand for Turning {
    const DIMENSION: usize = 2;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![x[0] + self.0 - x[0] * x[0], (x[0] / 2.0 - 1.125) * x[1]]
    }
}

impl Differentiable for Turning {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(2, 2, &[1.0 - 2.0 * x[0], 0.0, x[1] / 2.0, x[0] / 2.0 - 1.125])
    }
}

impl Parametric for Turning {
    fn by_parameter(&self, _: &[f64]) -> Vec<f64> {
        vec![1.0, 0.0]
    }
}

/// A linear map with multipliers p, −(p + 1/4) and (p − 1/4)·e^{±i}.
struct Several(f64);

impl ByHand for Several {
    const DIMENSION: usize = 4;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        (self.derivative(x) * DMatrix::from_column_slice(4, 1, x)).as_slice().to_vec()
    }
}

impl Differentiable for Several {
    fn derivative(&self, _: &[f64]) -> DMatrix<f64> {
        let (sin, cos) = 1f64.sin_cos();
        let mut matrix = DMatrix::zeros(4, 4);
        (matrix[(0, 0)], matrix[(1, 1)]) = (self.0, -self.0 - 0.25);
        let turn = DMatrix::from_row_slice(2, 2, &[cos, -sin, sin, cos]) * (self.0 - 0.25);
        matrix.view_mut((2, 2), (2, 2)).copy_from(&turn);
        matrix
    }
}

impl Parametric for Several {
    fn by_parameter(&self, _: &[f64]) -> Vec<f64> {
        vec![0.0; 4]
    }
}

/// Returns whether a branch has exactly these bifurcations, with parameters within `bound`.
fn has_turns(branch: &Branch, expected: &[(BranchChange, f64)], bound: f64) -> bool {
    let pairs = branch.turns.iter().zip(expected);
    branch.turns.len() == expected.len()
        && pairs
            .into_iter()
            .all(|(turn, (change, at))| turn.change == *change && (turn.parameter - at).abs() < bound)
}

#[test]
fn all_changes_of_one_stride_are_told_in_order() {
    use BranchChange::{ThroughCircle, ThroughMinusOne, ThroughOne};

    for steps in [1, 2, 7] {
        let start = periodic_point(&Several(0.5), &[0.0; 4], 1).unwrap();
        let there = branch(Several, &start, [0.5, 1.5], steps, |_| ControlFlow::Continue(()));
        let mut expected = [(ThroughMinusOne, 0.75), (ThroughOne, 1.0), (ThroughCircle, 1.25)];
        assert!(has_turns(&there, &expected, 1e-13), "{steps}: {:?}", there.turns);
        let start = periodic_point(&Several(1.5), &[0.0; 4], 1).unwrap();
        let back = branch(Several, &start, [1.5, 0.5], steps, |_| ControlFlow::Continue(()));
        expected.reverse();
        assert!(has_turns(&back, &expected, 1e-13), "{steps}: {:?}", back.turns);
    }
}

/// A linear map with multipliers 3/2 ± √p.
struct Meeting(f64);

impl ByHand for Meeting {
    const DIMENSION: usize = 2;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![1.5 * x[0] + self.0 * x[1], x[0] + 1.5 * x[1]]
    }
}

impl Differentiable for Meeting {
    fn derivative(&self, _: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(2, 2, &[1.5, self.0, 1.0, 1.5])
    }
}

impl Parametric for Meeting {
    fn by_parameter(&self, _: &[f64]) -> Vec<f64> {
        vec![0.0; 2]
    }
}

#[test]
fn multipliers_that_meet_outside_the_circle_go_through_nothing() {
    for (from, to) in [(0.125, -1.0), (-1.0, 0.125)] {
        let start = periodic_point(&Meeting(from), &[0.0; 2], 1).unwrap();
        let branch = branch(Meeting, &start, [from, to], 3, |_| ControlFlow::Continue(()));
        assert!(branch.turns.is_empty() && branch.points.len() > 3, "{:?}", branch.turns);
    }
}

#[test]
fn a_fold_hides_no_other_change() {
    let both = [(BranchChange::ThroughMinusOne, 1.0 / 16.0), (BranchChange::Fold, 0.0)];
    for (from, to, steps) in
        [(1.0, -1.0, 2), (1.0, -1.0, 5), (1.0, -1.0, 40), (0.25, -3.75, 1), (16.0, -16.0, 1)]
    {
        let start = periodic_point(&Turning(from), &[from.sqrt(), 0.0], 1).unwrap();
        let mut seen = Vec::new();
        let branch = branch(Turning, &start, [from, to], steps, |point| {
            seen.push((point.cycle.points[0][0], point.change()));
            ControlFlow::Continue(())
        });
        let first = [(BranchChange::ThroughMinusOne, 1.0)];
        let expected = if from > 1.0 { [&first[..], &both].concat() } else { both.to_vec() };
        assert!(has_turns(&branch, &expected, 1e-9 * from.max(1.0)), "{steps}: {:?}", branch.turns);
        assert_eq!(seen.len(), branch.points.len());
        let ends = seen.iter().filter(|(_, change)| change.is_none()).map(|(x, _)| *x);
        let is_over_both = |pair: &[f64]| pair[0] > 0.25 && pair[1] < 0.0;
        let is_any = ends.collect::<Vec<_>>().windows(2).any(is_over_both);
        assert_eq!(is_any, from > 1.0, "{seen:?}");
    }
}

/// The map x ↦ (x + 1 − px)/2. The fixed point 1/(1 + p) diverges for p → −1.
struct Far(f64);

impl ByHand for Far {
    const DIMENSION: usize = 1;

    fn image(&self, x: &[f64]) -> Vec<f64> {
        vec![(x[0] + 1.0 - self.0 * x[0]) / 2.0]
    }
}

impl Differentiable for Far {
    fn derivative(&self, _: &[f64]) -> DMatrix<f64> {
        DMatrix::from_element(1, 1, (1.0 - self.0) / 2.0)
    }
}

impl Parametric for Far {
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        vec![-x[0] / 2.0]
    }
}

#[test]
fn a_branch_goes_far_in_few_strides() {
    let start = periodic_point(&Far(0.0), &[0.9], 1).unwrap();
    let branch = branch(Far, &start, [0.0, -0.999], 10, |_| ControlFlow::Continue(()));
    let last = branch.points.last().unwrap();
    assert!(!branch.is_cut && last.cycle.points[0][0] > 990.0 && branch.points.len() < 150);
}

#[test]
fn a_planar_map_doubles_its_period_where_the_formula_says() {
    // The multipliers μ of the fixed point x satisfy μ² + 2axμ − b = 0. One of them is −1 if 2ax =
    // 1 − b, which holds for a = 3(1 − b)²/4.
    let start = periodic_point(&Henon(0.2, 0.3), &[0.9, 0.3], 1).unwrap();
    let branch = branch(|a| Henon(a, 0.3), &start, [0.2, 0.5], 3, |_| ControlFlow::Continue(()));
    assert!(has_turns(&branch, &[(BranchChange::ThroughMinusOne, 0.3675)], 1e-12), "{:?}", branch.turns);
}
