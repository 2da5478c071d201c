//! Computes the field in a plane, the integrals of the map there, and up to 12 equilibria of the
//! field. For lifts with new variables, no equilibria are sought.

use kahan_algebra::rational::Rational;
use kahan_study::{Orbit, Study, StudyError};
use nalgebra::{DMatrix, DVector};
use serde::Deserialize;
use serde_json::{Value, json};

/// A plane, and the points in it at which values are computed.
#[derive(Deserialize)]
pub(crate) struct Plane {
    /// A point in the plane, with a coordinate for each variable.
    at: Vec<f64>,
    /// The indices of the two variables that vary.
    axes: [usize; 2],
    /// The smallest and the largest value of each of the two variables.
    window: [[f64; 2]; 2],
    /// The number of points in each direction.
    points: [usize; 2],
    /// Integrals are computed for the ε of this orbit; `None` if no integrals are wanted.
    pub(crate) orbit: Option<Orbit>,
}

/// Returns the equilibria as JSON, and columns with the field and each integral at all points. The
/// points are in rows, the lowest row first.
pub(crate) fn plane(study: &Study, asked: &Plane) -> Result<(Value, Vec<f64>), StudyError> {
    let map = study.map()?.at(0.0);
    let parameters: Vec<f64> = study.values()?.iter().map(Rational::to_f64).collect();
    let count = study.variables().len();
    let [across, upwards] = asked.points;
    let coordinate = |k: usize, at: usize| {
        let [low, high] = asked.window[k];
        low + (high - low) * (at as f64 + 0.5) / asked.points[k] as f64
    };
    let at_step = asked.orbit.as_ref().map(|orbit| map.map().at(orbit.eps.to_f64()));
    let integrals = at_step.as_ref().map_or(0, |at_step| at_step.map().field().integrals().len());
    let (mut columns, mut starts) = (vec![Vec::new(); 2 + integrals], Vec::new());
    let (mut slope, mut values) = (vec![0.0; count], vec![0.0; integrals]);
    for row in 0..upwards {
        for column in 0..across {
            let mut point = asked.at.clone();
            point[asked.axes[0]] = coordinate(0, column);
            point[asked.axes[1]] = coordinate(1, row);
            let whole = study.embed(&point, &parameters);
            map.field(&whole, &mut slope).expect("the point is of the field");
            let own = study.project(&slope);
            if let Some(at_step) = &at_step {
                at_step.integrals(&whole, &mut values).expect("the point is of the field");
            }
            let cells = asked.axes.iter().map(|&axis| own[axis]).chain(values.iter().copied());
            columns.iter_mut().zip(cells).for_each(|(column, value)| column.push(value));
            if row % 3 == 1 && column % 3 == 1 {
                starts.push(point);
            }
        }
    }
    let mut equilibria: Vec<Equilibrium> = Vec::new();
    // Lifts with new variables may have equilibria that violate their relations.
    if study.lift().is_none_or(|lift| lift.order() == 0 && !lift.has_time) {
        let step = |x: &[f64]| {
            let (mut value, mut derivative) = (vec![0.0; count], vec![0.0; count * count]);
            map.field(x, &mut value).expect("the point is of the field");
            map.field_jacobian(x, &mut derivative).expect("the point is of the field");
            (DVector::from_vec(value), DMatrix::from_row_slice(count, count, &derivative))
        };
        starts.push(vec![0.0; count]);
        starts.push(asked.at.clone());
        for start in starts {
            let Some(found) = Equilibrium::near(start, &step) else { continue };
            let is_new = equilibria.iter().all(|known| !known.is_same(&found));
            if is_new && equilibria.len() < MOST {
                equilibria.push(found);
            }
        }
    }
    let found = equilibria.iter().map(|one| json!({"at": one.at, "eigenvalues": one.eigenvalues}));
    Ok((json!({"equilibria": found.collect::<Vec<_>>()}), columns.concat()))
}

/// The largest number of equilibria in an answer, because some fields have whole curves of them.
const MOST: usize = 12;
/// Newton's method makes at most this many steps.
const STEPS: usize = 60;

struct Equilibrium {
    at: Vec<f64>,
    /// The real and imaginary parts of the eigenvalues of the Jacobian.
    eigenvalues: Vec<[f64; 2]>,
}

impl Equilibrium {
    /// Returns the equilibrium to which Newton's method converges from a point.
    fn near(start: Vec<f64>, step: &impl Fn(&[f64]) -> (DVector<f64>, DMatrix<f64>)) -> Option<Self> {
        let mut x = DVector::from_vec(start);
        for _ in 0..STEPS {
            let (value, derivative) = step(x.as_slice());
            let by = derivative.clone().lu().solve(&value)?;
            x -= &by;
            let size = x.amax();
            if !size.is_finite() {
                return None;
            }
            if by.amax() <= 1e-14 * size.max(f64::MIN_POSITIVE) || by.amax() == 0.0 {
                let (_, derivative) = step(x.as_slice());
                let values = derivative.complex_eigenvalues();
                let eigenvalues = values.iter().map(|value| [value.re, value.im]).collect();
                return Some(Equilibrium { at: x.as_slice().to_vec(), eigenvalues });
            }
        }
        None
    }

    fn is_same(&self, other: &Self) -> bool {
        let size = self.at.iter().chain(&other.at).fold(0.0, |most: f64, x| most.max(x.abs()));
        self.at.iter().zip(&other.at).all(|(one, other)| (one - other).abs() <= 1e-9 * size.max(1e-300))
    }
}
