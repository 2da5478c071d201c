//! Finds drifts F from polynomials P with P(x̃) = C(x)·M·P(x) for a matrix M. Let P_v = Σ vᵢPᵢ for
//! a row vector v. Then P_v(x̃) = C(x)·P_{vM}(x). Here λ, μ, a, b, c, d are in ℚ(parameters, ε).
//!
//! | equations of v and w | case | next value of F = P_w/P_v |
//! |---|---|---|
//! | vM = λv, wM = λw + v | Jordan chain | F + 1/λ |
//! | vM = λv, wM = μw | two eigenvectors | (μ/λ)·F |
//! | wM = aw + bv, vM = cw + dv | two conjugate eigenvalues | (aF + b)/(cF + d) |

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_factor::factors;

type Vector = Vec<RationalFunction>;
type Matrix = Vec<Vector>;

const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 4_000_000;

/// The value of a function F at the next point, as a function of F.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum NextValue {
    /// The sum F + c with this c.
    Sum(RationalFunction),
    /// The multiple c·F with this c.
    Multiple(RationalFunction),
    /// The Möbius image (aF + b)/(cF + d).
    Image([RationalFunction; 4]),
}

impl NextValue {
    pub(super) fn rank(&self) -> u8 {
        match self {
            NextValue::Sum(_) => 0,
            NextValue::Multiple(_) => 1,
            NextValue::Image(_) => 2,
        }
    }

    pub(super) fn of(&self, function: &RationalFunction) -> Option<RationalFunction> {
        match self {
            NextValue::Sum(step) => Some(function + step),
            NextValue::Multiple(factor) => Some(function * factor),
            NextValue::Image([a, b, c, d]) => (&(a * function) + b).checked_div(&(&(c * function) + d)),
        }
    }

    pub(super) fn mapped(&self, to: impl Fn(&RationalFunction) -> RationalFunction) -> NextValue {
        match self {
            NextValue::Sum(step) => NextValue::Sum(to(step)),
            NextValue::Multiple(factor) => NextValue::Multiple(to(factor)),
            NextValue::Image(entries) => NextValue::Image(entries.each_ref().map(to)),
        }
    }

    /// Returns the next value of s·F, as a function of s·F.
    pub(super) fn scaled(self, scale: &RationalFunction) -> Option<NextValue> {
        Some(match self {
            NextValue::Sum(step) => NextValue::Sum(&step * scale),
            NextValue::Multiple(_) => self,
            NextValue::Image([a, b, c, d]) => NextValue::Image([a, &b * scale, c.checked_div(scale)?, d]),
        })
    }

    /// Returns the next value of 1/F, as a function of 1/F.
    pub(super) fn of_reciprocal(&self) -> Option<NextValue> {
        match self {
            NextValue::Sum(_) => None,
            NextValue::Multiple(factor) => Some(NextValue::Multiple(factor.recip()?)),
            NextValue::Image([a, b, c, d]) => Some(NextValue::Image([d, c, b, a].map(Clone::clone))),
        }
    }
}

/// A function F = P_above/P_below and its next value. A row vector v stands for P_v = Σ vᵢPᵢ.
pub(super) struct FunctionWithNext {
    pub(super) above: Vector,
    pub(super) below: Vector,
    pub(super) next: NextValue,
}

/// Returns the drifts of M = `matrix`. Its characteristic polynomial is in the variable `free`.
pub(super) fn drifts_of(matrix: &Matrix, free: Variable) -> Vec<FunctionWithNext> {
    let (mut sums, mut multiples, mut images) = (Vec::new(), Vec::new(), Vec::new());
    let mut eigenvectors: Vec<(RationalFunction, Vector)> = Vec::new();
    let characteristic = characteristic(matrix, free);
    for (factor, _) in factors(&characteristic, &mut Budget::new(MOST_TERMS, MOST_WORK)).factors {
        let coefficient = |power: u32| {
            let of_power = factor.coefficients_in(free).get(&power).cloned();
            RationalFunction::from(of_power.unwrap_or_default())
        };
        match factor.degree_where(|variable| variable == free) {
            1 => {
                let Some(value) = (-&coefficient(0)).checked_div(&coefficient(1)) else { continue };
                let Some(step) = value.recip() else { continue };
                let difference = plus_multiple(matrix, &-&value);
                let own = left_null_space(&difference);
                for above in left_null_space(&product(&difference, &difference)) {
                    let below = image(&above, &difference);
                    if below.iter().any(|entry| !entry.is_zero()) {
                        sums.push(FunctionWithNext { above, below, next: NextValue::Sum(step.clone()) });
                    }
                }
                for (other, below) in &eigenvectors {
                    let quotient = value.checked_div(other).expect("no eigenvalue is 0");
                    multiples.extend(own.iter().map(|above| FunctionWithNext {
                        above: above.clone(),
                        below: below.clone(),
                        next: NextValue::Multiple(quotient.clone()),
                    }));
                }
                eigenvectors.extend(own.into_iter().map(|vector| (value.clone(), vector)));
            }
            2 => {
                let [constant, linear, leading] = [0, 1, 2].map(coefficient);
                let square = product(matrix, matrix);
                let entries = square.iter().zip(matrix).map(|(square, own)| {
                    let entries = square.iter().zip(own);
                    entries.map(|(square, own)| &(square * &leading) + &(own * &linear)).collect()
                });
                let plane = left_null_space(&plus_multiple(&entries.collect::<Matrix>(), &constant));
                if let [above, below] = &plane[..] {
                    images.extend(in_plane(matrix, above, below));
                }
            }
            _ => {}
        }
    }
    sums.into_iter().chain(multiples).chain(images).collect()
}

fn in_plane(matrix: &Matrix, above: &Vector, below: &Vector) -> Option<FunctionWithNext> {
    let place = |of: &Vector, other: &Vector| {
        (0..of.len()).find(|&place| of[place] == RationalFunction::one() && other[place].is_zero())
    };
    let (first, second) = (place(above, below)?, place(below, above)?);
    let [of_above, of_below] = [above, below].map(|vector| image(vector, matrix));
    let next = [&of_above[first], &of_above[second], &of_below[first], &of_below[second]].map(Clone::clone);
    Some(FunctionWithNext { above: above.clone(), below: below.clone(), next: NextValue::Image(next) })
}

/// Returns det(λ − M) times a factor without λ, by the algorithm of Faddeev and LeVerrier.
fn characteristic(matrix: &Matrix, free: Variable) -> Polynomial {
    let size = matrix.len();
    let mut coefficients = vec![RationalFunction::one()];
    let mut power: Matrix = vec![vec![RationalFunction::zero(); size]; size];
    for k in 1..=size {
        power = plus_multiple(&product(matrix, &power), &coefficients[k - 1]);
        let moved = product(matrix, &power);
        let trace = (0..size).fold(RationalFunction::zero(), |sum, i| &sum + &moved[i][i]);
        let over = RationalFunction::constant(Rational::new(-1, k as i64));
        coefficients.push(&trace * &over);
    }
    let (numerators, _) = RationalFunction::over_common(&coefficients);
    let lambda = Polynomial::variable(free);
    numerators.iter().fold(Polynomial::zero(), |sum, coefficient| &(&sum * &lambda) + coefficient)
}

pub(super) fn image(vector: &Vector, matrix: &Matrix) -> Vector {
    let entry = |column: usize| {
        let terms = vector.iter().zip(matrix).filter(|(own, _)| !own.is_zero());
        terms.fold(RationalFunction::zero(), |sum, (own, row)| &sum + &(own * &row[column]))
    };
    (0..matrix[0].len()).map(entry).collect()
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    left.iter().map(|row| image(row, right)).collect()
}

fn plus_multiple(matrix: &Matrix, factor: &RationalFunction) -> Matrix {
    let mut sum = matrix.clone();
    for (i, row) in sum.iter_mut().enumerate() {
        row[i] = &row[i] + factor;
    }
    sum
}

/// Returns a basis of the row vectors v with vM = 0.
fn left_null_space(matrix: &Matrix) -> Vec<Vector> {
    let columns = matrix.len();
    let transposed = |column: usize| matrix.iter().map(|row| row[column].clone()).collect();
    let mut rows: Matrix = (0..columns).map(transposed).collect();
    let mut pivots = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(done, found);
        let inverse = rows[done][column].recip().expect("a pivot is not zero");
        let pivot_row: Vector = rows[done].iter().map(|entry| entry * &inverse).collect();
        for (row, entries) in rows.iter_mut().enumerate() {
            let factor = -&entries[column];
            if row != done && !factor.is_zero() {
                let pairs = entries.iter_mut().zip(&pivot_row);
                pairs.for_each(|(entry, pivot)| *entry = &*entry + &(pivot * &factor));
            }
        }
        rows[done] = pivot_row;
        pivots.push(column);
    }
    let free = (0..columns).filter(|column| !pivots.contains(column));
    free.map(|free| {
        let mut vector = vec![RationalFunction::zero(); columns];
        vector[free] = RationalFunction::one();
        for (row, &pivot) in rows.iter().zip(&pivots) {
            vector[pivot] = -&row[free];
        }
        vector
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[i64]]) -> Matrix {
        let entry = |&value: &i64| RationalFunction::constant(Rational::from(value));
        rows.iter().map(|row| row.iter().map(entry).collect()).collect()
    }

    #[test]
    fn every_function_is_carried_as_it_says() {
        let of = matrix(&[
            &[2, 0, 0, 0, 0],
            &[5, 2, 0, 0, 0],
            &[0, 0, 3, 0, 0],
            &[0, 0, 0, 1, 2],
            &[0, 0, 0, -2, 1],
        ]);
        let found = drifts_of(&of, Variable(0));
        let kinds: Vec<_> = found.iter().map(|found| std::mem::discriminant(&found.next)).collect();
        assert_eq!(kinds.len(), 3);
        for FunctionWithNext { above, below, next } in found {
            let (moved_above, moved_below) = (image(&above, &of), image(&below, &of));
            let point = matrix(&[&[7], &[-3], &[11], &[2], &[5]]);
            let value = |vector: &Vector| image(vector, &point).remove(0);
            let old = value(&above).checked_div(&value(&below)).unwrap();
            let new = value(&moved_above).checked_div(&value(&moved_below)).unwrap();
            assert_eq!(Some(new), next.of(&old));
        }
    }
}
