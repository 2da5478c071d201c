//! Compares steps of random fields of up to 200 variables with solutions by partial pivoting.

use kahan_runtime::Field;

use super::support::Random;

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Each variable depends on this number of randomly chosen variables.
    Anywhere(usize),
    /// Variable i depends on this number of variables with indices up to i.
    Triangular(usize),
    /// The first variable depends on all others, and all others depend on the first.
    Arrow,
    /// Each variable depends on this number of neighbours on each side, around a ring.
    Ring(usize),
    All,
}

fn field(kind: Kind, n: usize, random: &mut Random) -> String {
    let mut below = |modulus: usize| random.below(u32::try_from(modulus).expect("small")) as usize;
    let mut text = String::new();
    for i in 0..n {
        let acting: Vec<usize> = match kind {
            Kind::Anywhere(count) => (0..count).map(|_| below(n)).collect(),
            Kind::Triangular(count) => (0..count).map(|_| below(i + 1)).collect(),
            Kind::Arrow => {
                if i == 0 {
                    (1..n).collect()
                } else {
                    vec![0]
                }
            }
            Kind::Ring(reach) => (0..=reach).flat_map(|k| [(i + k) % n, (i + n - k) % n]).collect(),
            Kind::All => (0..n).collect(),
        };
        text += &format!("x{i}dot = {}/3 - x{i}", below(5));
        for j in acting {
            text += &format!(" + {}/7*x{i}*x{j} - {}/5*x{j}", below(9) as i32 - 4, below(7));
        }
        text += ";\n";
    }
    text
}

fn pivoted(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let best = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).expect("a row");
        a.swap(k, best);
        b.swap(k, best);
        let (above, below) = a.split_at_mut(k + 1);
        let pivot = &above[k];
        for (row, i) in below.iter_mut().zip(k + 1..) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(pivot).for_each(|(entry, upper)| *entry -= factor * upper);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

fn norm(x: impl IntoIterator<Item = f64>) -> f64 {
    x.into_iter().fold(0.0, |most, entry| most.max(entry.abs()))
}

/// Returns the backward error ‖A·d − 2εf‖/(‖A‖·‖d‖ + ‖2εf‖) of a solution d of A·d = 2εf.
fn backward_error(a: &[Vec<f64>], right: &[f64], d: &[f64]) -> f64 {
    let product = |row: &Vec<f64>| row.iter().zip(d).map(|(entry, d)| entry * d).sum::<f64>();
    let rest = norm(a.iter().zip(right).map(|(row, right)| product(row) - right));
    let size = norm(a.iter().map(|row| row.iter().map(|entry| entry.abs()).sum()));
    rest / (size * norm(d.iter().copied()) + norm(right.iter().copied()))
}

/// If entries do not grow during elimination, partial pivoting has a backward error of at most n·u,
/// where u is the unit roundoff (Higham 2002, §9.3).
#[test]
fn steps_along_couplings_are_as_good_as_partial_pivoting() {
    let mut random = Random(29);
    for (kind, sizes) in [
        (Kind::Anywhere(2), &[9, 24, 60, 117, 200][..]),
        (Kind::Anywhere(5), &[10, 33, 80]),
        (Kind::Triangular(3), &[11, 50, 200]),
        (Kind::Arrow, &[9, 40, 150]),
        (Kind::Ring(1), &[9, 48, 199]),
        (Kind::Ring(3), &[12, 90]),
        (Kind::All, &[9, 12, 20]),
    ] {
        for &n in sizes {
            let read = Field::parse(&field(kind, n, &mut random)).expect("a field");
            let map = read.with::<&str, f64>([]).expect("no parameters");
            for eps in [1e-6, 1e-3, 0.1, 1.0, 30.0, 1e3] {
                let at = map.at(eps);
                let x: Vec<f64> = random.point(n);
                let (mut f, mut matrix, mut next) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n]);
                at.field(&x, &mut f).expect("a field");
                at.matrix(&x, &mut matrix).expect("a matrix");
                at.step(&x, &mut next).expect("a step");
                let a: Vec<Vec<f64>> = matrix.chunks(n).map(<[f64]>::to_vec).collect();
                let right: Vec<f64> = f.iter().map(|f| 2.0 * eps * f).collect();
                let d: Vec<f64> = next.iter().zip(&x).map(|(next, x)| next - x).collect();
                let rounded = norm(x.iter().chain(&next).copied()) / norm(d.iter().copied());
                let found = backward_error(&a, &right, &d);
                let theirs = backward_error(&a, &right, &pivoted(a.clone(), right.clone()));
                let unit = f64::EPSILON / 2.0;
                let bound = 16.0 * n as f64 * unit + rounded * unit + theirs;
                assert!(found <= bound, "{kind:?}, {n}, {eps}: {found:e}, pivoted {theirs:e}");
            }
        }
    }
}
