//! Fields of many variables, and fields whose reduced map has too many terms.

use kahan_core::nalgebra::SVector;
use kahan_core::{KahanMap, Pivot};
use kahan_runtime::interpreted::Interpreted;
use kahan_runtime::{Field, MachineFloat, Map};

use super::support::{Random, assert_same, number, steps};

/// Returns a field in n variables, of which each depends on all others. From about six variables
/// on, its reduced map has too many terms.
pub(crate) fn dense(n: usize) -> String {
    let equation = |i: usize| {
        let terms = (0..n).flat_map(|j| (j..n).map(move |k| (j, k)));
        let terms = terms.map(|(j, k)| format!("{}/9*x{j}*x{k}", (i * 5 + j * 3 + k) % 7 + 1));
        format!("x{i}dot = {} + a*x{i} - b;", terms.collect::<Vec<_>>().join(" + "))
    };
    (0..n).map(equation).collect()
}

/// Returns a Lotka–Volterra chain of n variables, each of which depends on its neighbours.
pub(crate) fn chain(n: usize) -> String {
    let neighbour = |i: usize| if i < n { format!("x{i}") } else { "0".to_owned() };
    let equation =
        |i: usize| format!("x{i}dot = x{i}*({} - {});", neighbour(i + 1), neighbour(i.wrapping_sub(1)));
    (0..n).map(equation).collect()
}

fn map(text: &str) -> Map {
    let field = Field::parse(text).expect("a field");
    let parameters = field.parameters().iter().map(|name| (name.clone(), 0.25)).collect::<Vec<_>>();
    field.with(parameters).expect("its parameters")
}

fn eliminated_as_by_types<T: MachineFloat, const N: usize>() {
    let map = map(&dense(N));
    assert!(map.field().derived().step().is_none(), "{N} variables are within the budget");
    let typed: Interpreted<T, N> = map.as_kahan_map().unwrap();
    let mut random = Random(23);
    for eps in steps::<T>() {
        let x = SVector::<T, N>::from_vec(random.point(N));
        let ours = map.at(eps);
        let (mut next, mut entries) = (vec![T::zero(); N], vec![T::zero(); N * N]);
        ours.step(x.as_slice(), &mut next).unwrap();
        assert_same(&next, typed.step(&x, eps).as_slice(), ("step", N, eps));
        ours.matrix(x.as_slice(), &mut entries).unwrap();
        assert_same(&entries, typed.matrix(&x, eps).transpose().as_slice(), ("matrix", N, eps));
        ours.jacobian(x.as_slice(), &mut entries).unwrap();
        assert_same(&entries, typed.jacobian(&x, eps).transpose().as_slice(), ("jacobian", N, eps));
        let (mut last, mut carry) = (x.as_slice().to_vec(), vec![T::zero(); N]);
        ours.advance_with_carry(&mut last, &mut carry, 5).unwrap();
        let orbit = typed.orbit(x, eps).compensated().nth(5).expect("floats go on");
        assert_same(&last, orbit.as_slice(), ("compensated", N, eps));
    }
}

#[test]
fn a_field_beyond_the_budget_is_eliminated_as_by_types() {
    eliminated_as_by_types::<f64, 9>();
    eliminated_as_by_types::<f32, 9>();
    eliminated_as_by_types::<f64, 12>();
}

fn promised_as_by_types<T: MachineFloat + Pivot, const N: usize>() {
    let map = map(&chain(N));
    let typed: Interpreted<T, N> = map.as_kahan_map().unwrap();
    let mut random = Random(29);
    let (mut found, mut refused) = (0, 0);
    for eps in steps::<T>().into_iter().chain([number(2.0 / 3.0), number(1e30), T::zero() / T::zero()]) {
        for point in [random.point(N), vec![T::one(); N], vec![number(1e-30); N]] {
            let (x, mut next) = (SVector::<T, N>::from_vec(point), vec![T::zero(); N]);
            match (map.try_step(x.as_slice(), eps, &mut next).unwrap(), typed.try_step(&x, eps)) {
                (Ok(()), Ok(by_type)) => assert_same(&next, by_type.as_slice(), ("try_step", N, eps)),
                (ours, by_type) => {
                    assert_eq!(format!("{:?}", ours.unwrap_err()), format!("{:?}", by_type.unwrap_err()));
                    refused += 1;
                }
            }
            found += 1;
        }
    }
    assert!(refused > 0 && refused < found, "{refused} of {found} are refused");
}

#[test]
fn slices_have_the_step_with_a_promise() {
    promised_as_by_types::<f64, 3>();
    promised_as_by_types::<f32, 3>();
    promised_as_by_types::<f32, 5>();
    promised_as_by_types::<f64, 9>();
    let map = map(&chain(17));
    assert!(map.try_step(&[1.0; 17], 0.1, &mut [0.0; 17]).is_err());
    assert!(self::map(&chain(3)).try_step(&[1.0; 4], 0.1, &mut [0.0; 3]).is_err());
}

/// The field of a chain is f(x) = Q(x,x), so a step satisfies (x̃ − x)/2ε = Q(x,x̃) = ¼[f(x + x̃) −
/// f(x − x̃)].
#[test]
fn a_chain_of_sixty_variables_obeys_the_defining_equation() {
    let (map, eps, n) = (map(&chain(60)), 0.01, 60);
    let at = map.at(eps);
    let x: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * (0.7 * i as f64).sin()).collect();
    let mut next = vec![0.0; n];
    at.step(&x, &mut next).unwrap();
    let f = |sign: f64| {
        let (point, mut value): (Vec<f64>, _) =
            (x.iter().zip(&next).map(|(x, y)| x + sign * y).collect(), vec![0.0; n]);
        at.field(&point, &mut value).unwrap();
        value
    };
    for (i, (plus, minus)) in f(1.0).iter().zip(&f(-1.0)).enumerate() {
        let lack = next[i] - x[i] - 2.0 * eps * (plus - minus) / 4.0;
        assert!(lack.abs() < 1e-14, "{i}: {lack:e}");
    }
    let mut back = next.clone();
    map.at(-eps).advance(&mut back, 1).unwrap();
    for (there, here) in back.iter().zip(&x) {
        assert!((there - here).abs() < 1e-14, "the map with -eps is the inverse");
    }
    let (mut state, total) = (x.clone(), |x: &[f64]| x.iter().sum::<f64>());
    at.advance(&mut state, 1000).unwrap();
    assert!((total(&state) - total(&x)).abs() < 1e-11, "{}", total(&state) - total(&x));
}

/// The variables form a grid, and those in column j start near 1 + 4j. Interior diagonal entries of
/// A are then near 1 − 8ε, which is 0 at ε = 1/8.
#[test]
fn a_lattice_without_pivots_on_the_diagonal_obeys_its_linear_equations() {
    const SIDE: usize = 15;
    let (n, eps) = (SIDE * SIDE, 0.125);
    let site = |i: usize, j: usize| {
        let beside = |i: usize, j: usize| {
            if i < SIDE && j < SIDE { format!("x{}", i * SIDE + j) } else { "0".to_owned() }
        };
        let (right, left) = (beside(i, j + 1), beside(i, j.wrapping_sub(1)));
        let (down, up) = (beside(i + 1, j), beside(i.wrapping_sub(1), j));
        let x = beside(i, j);
        format!("{x}dot = {x}*({right} - {left} + {down} - {up});")
    };
    let text: String = (0..n).map(|k| site(k / SIDE, k % SIDE)).collect();
    let at = map(&text).at(eps);
    for noise in [0.0, 1e-9, 1e-3, 1.0] {
        let x: Vec<f64> =
            (0..n).map(|k| 4.0 * (k % SIDE) as f64 + 1.0 + noise * (0.7 * k as f64).sin()).collect();
        let (mut next, mut field, mut matrix) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n]);
        at.step(&x, &mut next).unwrap();
        at.field(&x, &mut field).unwrap();
        at.matrix(&x, &mut matrix).unwrap();
        let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
        for (i, row) in matrix.chunks_exact(n).enumerate() {
            let products = row.iter().zip(next.iter().zip(&x)).map(|(entry, (next, x))| entry * (next - x));
            let (mut sum, mut size) = (-2.0 * eps * field[i], 0.0);
            products.for_each(|product| (sum, size) = (sum + product, size + product.abs()));
            (largest, worst) = (largest.max(size), worst.max(sum.abs()));
        }
        assert!(worst <= 1e-13 * largest, "{noise}: {worst:e} of {largest:e}");
    }
}

#[test]
fn the_jacobian_of_sixty_variables_is_that_of_differences() {
    let map = map(&chain(60));
    let at = map.at(number::<f64>(0.01));
    let x: Vec<f64> = (0..60).map(|i| 1.0 + 0.3 * (0.7 * f64::from(i)).sin()).collect();
    let mut jacobian = vec![0.0; 3600];
    at.jacobian(&x, &mut jacobian).unwrap();
    let h = 1e-5;
    for j in [0, 17, 59] {
        let moved = |by: f64| {
            let (mut point, mut next) = (x.clone(), vec![0.0; 60]);
            point[j] += by;
            at.step(&point, &mut next).unwrap();
            next
        };
        for (i, (plus, minus)) in moved(h).iter().zip(&moved(-h)).enumerate() {
            let slope = (plus - minus) / (2.0 * h);
            assert!((slope - jacobian[60 * i + j]).abs() < 1e-9, "{i}, {j}");
        }
    }
}

fn follows_the_interpreter<T: MachineFloat, const N: usize>(text: &str) {
    let large = map(text);
    let typed: Interpreted<T, N> = large.as_kahan_map().unwrap();
    let mut random = Random(31);
    for eps in [1e-3, 0.05, 0.3, 2.0, 40.0].map(number::<T>) {
        let mut x: Vec<T> = random.point(N);
        let (mut point, mut next) = (SVector::<T, N>::from_column_slice(&x), x.clone());
        let at = large.at(eps);
        assert!(at.is_code() || !map("xdot = a*x^2;").at(eps).is_code(), "where there is code at all");
        for steps in [1, 3, 100] {
            at.advance(&mut x, steps).unwrap();
            for _ in 0..steps {
                at.step(point.as_slice(), &mut next).unwrap();
                point = typed.step(&point, eps);
                assert_same(&next, point.as_slice(), ("step", N, eps));
            }
            assert_same(&x, point.as_slice(), (steps, N, eps));
        }
    }
}

#[test]
fn orbits_by_code_take_the_pivots_of_the_interpreter() {
    follows_the_interpreter::<f64, 6>(&dense(6));
    follows_the_interpreter::<f32, 6>(&dense(6));
    follows_the_interpreter::<f64, 8>(&dense(8));
    follows_the_interpreter::<f64, 10>(&dense(10));
    follows_the_interpreter::<f64, 12>(&chain(12));
    follows_the_interpreter::<f32, 30>(&chain(30));
}
