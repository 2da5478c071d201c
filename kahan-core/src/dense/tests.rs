use std::vec;
use std::vec::Vec;

use super::{DenseWork, LARGEST_FACTOR, Workspace, coefficients, pack, points, run, velocities, velocity};
use crate::Level;
use crate::ensemble::lanes::InLanes;

#[test]
fn lanes_of_any_number_have_the_same_bits() {
    fn agree<T: InLanes + From<f32>>(bits: impl Fn(T) -> u64) {
        let mut state = 1_u32;
        let mut number = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            T::from((state >> 8) as f32 / 16_777_216.0 - 0.5)
        };
        for n in 1..40 {
            let field: Vec<T> = (0..n * coefficients(n)).map(|_| number()).collect();
            let x: Vec<T> = (0..n).map(|_| number()).collect();
            let mut packed = Vec::new();
            pack(n, &field, &mut packed);
            for eps in [0.01, 0.3].map(T::from) {
                let at = |level: Level| {
                    let mut workspace = Workspace::default();
                    let work = DenseWork {
                        packed: &packed,
                        x: &x,
                        eps,
                        eliminates: true,
                        workspace: &mut workspace,
                    };
                    let is_solved = run(work, level);
                    (is_solved, workspace.last(n).iter().map(|entry| bits(*entry)).collect::<Vec<_>>())
                };
                assert_eq!(at(Level::Baseline), at(Level::Avx2), "{n}");
            }
        }
    }
    agree(f64::to_bits);
    agree(|x: f32| u64::from(x.to_bits()));
}

#[test]
fn points_side_by_side_are_solved_as_each_alone() {
    let mut state = 7_u32;
    let mut number = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from((state >> 8) as f32 / 16_777_216.0 - 0.5)
    };
    let (mut solved, mut refused) = (0, 0);
    for n in 1..30 {
        let field: Vec<f64> = (0..n * coefficients(n)).map(|_| number()).collect();
        let mut packed = Vec::new();
        pack(n, &field, &mut packed);
        for eps in [0.01, 0.3, 2.0] {
            let width = points::<f64>();
            let x: Vec<f64> = (0..n * width).map(|_| number()).collect();
            let (mut all, mut growth) = (x.clone(), vec![0.0; width]);
            velocities(&packed, &mut all, eps, &mut growth, &mut Workspace::default());
            for p in 0..width {
                let own: Vec<f64> = (0..n).map(|i| x[i * width + p]).collect();
                let mut workspace = Workspace::default();
                let is_solved = velocity(&packed, &own, eps, &mut workspace);
                assert_eq!(is_solved, growth[p].abs() <= LARGEST_FACTOR as f64, "{n} {eps}");
                if is_solved {
                    assert!((0..n).all(|i| all[i * width + p] == workspace.last(n)[i]), "{n} {eps}");
                    solved += 1;
                } else {
                    refused += 1;
                }
            }
        }
    }
    assert!(solved > 100 && refused > 100, "{solved} {refused}");
}
