//! Computes the values that a basis's integrals have on an orbit, exactly or in floats.

use std::error::Error;
use std::fmt;

use kahan_algebra::rational::Rational;
use nalgebra::{DMatrix, DVector};

use super::{Basis, Term};
use crate::modular::weights::reduce;

/// The coefficients of a basis's relation on one orbit, in floats.
#[derive(Clone, Debug, PartialEq)]
pub struct BasisValues {
    /// The coefficients in the order of the monomials. The chosen unit monomial has coefficient 1.
    pub coefficients: Vec<f64>,
    /// The condition number of the linear system for the coefficients cₖ, in which each monomial mₖ
    /// is scaled by its largest value. It grows if points lie close together.
    ///
    /// Let the points have a relative error u, and let Mₖ be the largest |mₖ| at the points. Then
    /// the error of each cₖMₖ is at most about `condition`·u times the largest |cₖMₖ|.
    pub condition: f64,
}

/// The reason why the coefficients of a basis cannot be computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BasisError {
    /// The points are too few to determine the coefficients.
    TooFewPoints {
        /// The number of points needed.
        wanted: usize,
        /// The number of points given.
        given: usize,
    },
    /// A point has more or fewer states than the monomials.
    Dimension {
        /// The number of states of the monomials.
        wanted: usize,
        /// The number of entries of the point.
        given: usize,
    },
    /// A point, or the value of a monomial at a point, is not finite.
    NotFinite,
    /// The points do not determine the coefficients. Either the points repeat or lie too close
    /// together, or the coefficient of the unit monomial is 0 on this orbit.
    Undetermined,
}

impl fmt::Display for BasisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BasisError::TooFewPoints { wanted, given } => write!(
                f,
                "{given} points of the orbit do not determine the coefficients: give {wanted} consecutive ones"
            ),
            BasisError::Dimension { wanted, given } => {
                write!(f, "a point has {given} states, and the monomials have {wanted}")
            }
            BasisError::NotFinite => f.write_str("a point or the value of a monomial there is not finite"),
            BasisError::Undetermined => f.write_str(
                "the points do not determine the coefficients: take a longer time step or another orbit",
            ),
        }
    }
}

impl Error for BasisError {}

impl Basis {
    /// Solves exactly for the coefficients along an orbit, with coefficient 1 for the unit
    /// monomial. The first [`points`](Self::points) points of `orbit` are used.
    ///
    /// # Errors
    /// Returns a [`BasisError`] if the coefficients cannot be computed.
    pub fn evaluate_exact(&self, orbit: &[Vec<Rational>]) -> Result<Vec<Rational>, BasisError> {
        self.check(orbit)?;
        let value = |exponents: &[u32], point: &[Rational]| {
            let powers = exponents.iter().zip(point).filter(|(exponent, _)| **exponent > 0);
            powers.fold(Rational::one(), |product, (&exponent, x)| {
                (0..exponent).fold(product, |product, _| &product * x)
            })
        };
        let sum = |term: &Term, point: &[Rational]| {
            term.iter().fold(Rational::zero(), |sum, &(place, factor)| {
                &sum + &(&Rational::from(factor) * &value(&self.monomials[place], point))
            })
        };
        let (unit, others) = self.unit_and_others();
        let mut rows: Vec<Vec<Rational>> = orbit[..self.points()]
            .iter()
            .map(|point| {
                let own = others.iter().map(|term| sum(term, point));
                own.chain([-&sum(unit, point)]).collect()
            })
            .collect();
        let width = others.len() + 1;
        if reduce(&mut rows, width) != (0..others.len()).collect::<Vec<_>>() {
            return Err(BasisError::Undetermined);
        }
        let mut coefficients = vec![Rational::one(); self.monomials.len()];
        let values = rows.iter().map(|row| row[others.len()].clone());
        for (term, value) in others.iter().zip(values).chain([(&unit, Rational::one())]) {
            for &(place, factor) in *term {
                coefficients[place] = &Rational::from(factor) * &value;
            }
        }
        Ok(coefficients)
    }

    /// Solves for the coefficients along an orbit by least squares, with coefficient 1 for the unit
    /// monomial. All points of `orbit` are used, and must be consecutive.
    ///
    /// # Errors
    /// Returns a [`BasisError`] if the coefficients cannot be computed.
    pub fn evaluate(&self, orbit: &[Vec<f64>]) -> Result<BasisValues, BasisError> {
        self.check(orbit)?;
        let value = |exponents: &[u32], point: &[f64]| {
            exponents.iter().zip(point).map(|(&exponent, x)| x.powi(exponent as i32)).product::<f64>()
        };
        let sum = |term: &Term, point: &[f64]| -> f64 {
            term.iter().map(|&(place, factor)| factor as f64 * value(&self.monomials[place], point)).sum()
        };
        let (own, others) = self.unit_and_others();
        let mut matrix =
            DMatrix::from_fn(orbit.len(), others.len(), |row, column| sum(others[column], &orbit[row]));
        let unit = DVector::from_fn(orbit.len(), |row, _| -sum(own, &orbit[row]));
        if !matrix.iter().chain(unit.iter()).all(|entry| entry.is_finite()) {
            return Err(BasisError::NotFinite);
        }
        let scales: Vec<f64> = matrix.column_iter().map(|column| column.amax()).collect();
        if scales.contains(&0.0) {
            return Err(BasisError::Undetermined);
        }
        for (mut column, scale) in matrix.column_iter_mut().zip(&scales) {
            column /= *scale;
        }
        // The singular value decomposition gives only the condition number. It is too inaccurate
        // for the solution, which uses a QR decomposition.
        let singular_values = matrix.singular_values();
        let condition = singular_values.max() / singular_values.min();
        if condition.is_nan() || condition * f64::EPSILON > 1.0 {
            return Err(BasisError::Undetermined);
        }
        let factors = matrix.qr();
        let right = factors.q().tr_mul(&unit);
        let solution = factors.r().solve_upper_triangular(&right).ok_or(BasisError::Undetermined)?;
        let mut coefficients = vec![1.0; self.monomials.len()];
        let values = solution.iter().zip(&scales).map(|(value, scale)| value / scale);
        for (term, value) in others.iter().zip(values).chain([(&own, 1.0)]) {
            for &(place, factor) in *term {
                coefficients[place] = factor as f64 * value;
            }
        }
        Ok(BasisValues { coefficients, condition })
    }

    fn unit_and_others(&self) -> (&Term, Vec<&Term>) {
        let is_unit = |term: &&Term| term.iter().any(|&(place, _)| place == self.unit);
        let (unit, others): (Vec<_>, Vec<_>) = self.terms.iter().partition(is_unit);
        (unit.first().copied().expect("every monomial stands in a term"), others)
    }

    fn check<T>(&self, orbit: &[Vec<T>]) -> Result<(), BasisError> {
        let wanted = self.monomials[0].len();
        if let Some(point) = orbit.iter().find(|point| point.len() != wanted) {
            return Err(BasisError::Dimension { wanted, given: point.len() });
        }
        if orbit.len() < self.points() {
            return Err(BasisError::TooFewPoints { wanted: self.points(), given: orbit.len() });
        }
        Ok(())
    }
}
