//! Compares elimination by panels with the loops over entries.

use std::vec;

use super::*;
use crate::field::couplings::CouplingRow;

/// The tables of [`Couplings`] for given positions of entries, in the order of the variables.
struct Pattern {
    order: Vec<u32>,
    rows: Vec<CouplingRow>,
    columns: Vec<u32>,
    places: Vec<u32>,
}

impl Pattern {
    fn of(n: usize, is_coupled: impl Fn(usize, usize) -> bool) -> Self {
        let mut is_there: Vec<Vec<bool>> =
            (0..n).map(|i| (0..n).map(|j| i == j || is_coupled(i, j)).collect()).collect();
        let given = is_there.clone();
        for i in 0..n {
            for p in 0..i {
                if is_there[i][p] {
                    (p..n).for_each(|j| is_there[i][j] |= is_there[p][j]);
                }
            }
        }
        let (mut rows, mut columns, mut places) = (vec![], vec![], vec![]);
        for i in 0..n {
            let start = columns.len();
            let mut diagonal = start;
            for j in (0..n).filter(|&j| is_there[i][j]) {
                if j == i {
                    diagonal = columns.len();
                }
                if given[i][j] {
                    places.push(columns.len() as u32);
                }
                columns.push(j as u32);
            }
            let [start, diagonal, end] = [start, diagonal, columns.len()].map(|place| place as u32);
            rows.push(CouplingRow::new(start, start, diagonal, end));
        }
        Pattern { order: (0..n as u32).collect(), rows, columns, places }
    }

    fn couplings(&self) -> Couplings<'_> {
        let Pattern { order, rows, columns, places } = self;
        Couplings { order, rows, columns, blocks: &order[..0], places }
    }
}

fn random(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    *seed >> 32
}

fn factors_are_those_of_rows<T: InLanes>(from: impl Fn(f64) -> T) {
    let (mut seed, mut refused) = (5, 0);
    for n in 1..90 {
        for (divisor, block) in [(2, 1), (n, 1), (n, 6), (n / 3 + 1, 40)] {
            let coupled: Vec<bool> =
                (0..n * n).map(|_| random(&mut seed).is_multiple_of(divisor as u64)).collect();
            let group = |i: usize| i / block * block;
            let pattern = Pattern::of(n, |i, j| coupled[group(i) * n + group(j)] || group(i) == group(j));
            let couplings = pattern.couplings();
            let supernodes = Supernodes::of(&couplings);
            for eps in [0.01, 0.3, 2.0] {
                let slope = |_: &u32| from(random(&mut seed) as f64 / (1_u64 << 31) as f64 - 1.0);
                let slopes: Vec<T> = pattern.places.iter().map(slope).collect();
                let mut expected = vec![T::zero(); pattern.columns.len()];
                couplings.fill(&slopes, &from(eps), &mut expected);
                let mut found = expected.clone();
                let is_factored = couplings.factor(&mut expected, &mut vec![T::zero(); n]);
                let workspace = &mut PanelWorkspace::default();
                assert_eq!(supernodes.factor(&couplings, false, &mut found, workspace), is_factored);
                assert!(!is_factored || found == expected, "{n} variables, blocks of {block}");
                refused += usize::from(!is_factored);
            }
        }
    }
    assert!((50..600).contains(&refused), "{refused}");
}

#[test]
fn panels_have_the_bits_of_rows() {
    factors_are_those_of_rows(|number| number);
    factors_are_those_of_rows(|number| number as f32);
}

fn lattice(side: usize) -> Pattern {
    Pattern::of(side * side, |i, j| i.abs_diff(j) == side || i / side == j / side && i.abs_diff(j) == 1)
}

/// Solves a test system in which variable i has the unit `units(i)`. Returns the smallest nonzero
/// magnitude in the LU factors, and the solution divided by `units`.
fn solved(pattern: &Pattern, eps: f64, units: impl Fn(usize) -> f64, flushes: bool) -> (f64, Vec<f64>) {
    let n = pattern.order.len();
    let couplings = Couplings { blocks: &[n as u32], ..pattern.couplings() };
    let pairs = couplings.pairs().enumerate();
    let slopes: Vec<f64> =
        pairs.map(|(place, (i, j))| (1.0 + (place % 7) as f64) * (units(i) / units(j))).collect();
    let mut values = vec![0.0; pattern.columns.len()];
    couplings.fill(&slopes, &eps, &mut values);
    let supernodes = Supernodes::of(&couplings);
    assert!(supernodes.factor(&couplings, flushes, &mut values, &mut PanelWorkspace::default()));
    let sizes = values.iter().map(|value| value.abs()).filter(|size| *size > 0.0);
    let smallest = sizes.fold(1.0, f64::min);
    let mut solution: Vec<f64> = (0..n).map(|i| (1.0 + i as f64) * units(i)).collect();
    couplings.solve(&values, &mut solution);
    (smallest, (0..n).map(|i| solution[i] / units(i)).collect())
}

#[test]
fn negligible_factors_are_zero_and_solutions_keep_their_bits() {
    let (pattern, eps) = (lattice(24), 1e-12);
    let (smallest, exact) = solved(&pattern, eps, |_| 1.0, false);
    let (smallest_flushed, flushed) = solved(&pattern, eps, |_| 1.0, true);
    // Every off-diagonal entry of A has a magnitude of at least ε.
    assert!(smallest < eps * f64::NEGLIGIBLE, "{smallest}");
    assert!(smallest_flushed >= eps * f64::NEGLIGIBLE, "{smallest_flushed}");
    assert_eq!(flushed, exact);
}

/// The variables are multiplied by powers of 2, which change no digit.
#[test]
fn solutions_are_independent_of_extreme_units() {
    let (pattern, eps) = (lattice(24), 1e-3);
    let (_, expected) = solved(&pattern, eps, |_| 1.0, false);
    for power in [-400, -200, 200, 400] {
        let unit = 2.0_f64.powi(power);
        for own in [|i: usize| i == 300, |i: usize| i.is_multiple_of(5), |i: usize| i >= 300] {
            let units = |i| if own(i) { unit } else { 1.0 };
            assert_eq!(solved(&pattern, eps, units, true).1, expected, "2^{power}");
        }
    }
}
