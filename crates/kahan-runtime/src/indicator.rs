//! One number for each of many orbits: what a stability map shows.
//!
//! In: the maps and first points of orbits. Out: what an observer says of each, over `f64`,
//! compiled here for those who draw.

use kahan_core::observe::{Drifted, Escape, Fli, Lyapunov, Megno, Observer, Sali};

use crate::{DimensionError, IntegralDrift, MapAt};

/// What is asked of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Indicator {
    /// The smaller alignment index.
    Sali,
    /// The fast Lyapunov indicator.
    Fli,
    /// The mean of MEGNO.
    Megno,
    /// The largest Lyapunov exponent, per unit of time.
    Lyapunov,
    /// The greatest drift of the claimed integrals, 0 where there is none.
    Drift,
    /// The first step after which a variable is larger in size than this, or no number; not a
    /// number where there is none.
    Escape(f64),
}

impl Indicator {
    /// The indicator of many orbits, each followed for so many steps: column c holds variable c of
    /// all of them, first that of their first points and then of their last, and `maps` is one map
    /// for all or one each. But for an escape, it is not a number where an orbit leaves the
    /// numbers.
    ///
    /// # Errors
    /// [`DimensionError`] for columns that do not fit the maps, or each other.
    ///
    /// ```
    /// use kahan_runtime::{Field, Indicator};
    ///
    /// let field = Field::parse("xdot = p; ydot = q; pdot = -x - 2*x*y; qdot = y^2 - x^2 - y;").unwrap();
    /// let map = field.map().unwrap().at(0.05);
    /// let mut columns = [[0.0, 0.0], [0.1, -0.2], [0.3, 0.49], [0.0, 0.0]];
    /// let mut columns = columns.each_mut().map(|column| &mut column[..]);
    /// let indices = Indicator::Sali.of(&[&map], &mut columns, 5000).unwrap();
    /// assert!(indices[0] > 0.1 && indices[1] < 1e-6);
    /// ```
    pub fn of(
        self,
        maps: &[&MapAt<f64>],
        columns: &mut [&mut [f64]],
        steps: u64,
    ) -> Result<Vec<f64>, DimensionError> {
        let map = |orbit: usize| maps[orbit.min(maps.len() - 1)];
        let values = match self {
            Indicator::Sali => follow(maps, columns, steps, |orbit| Sali::new(map(orbit)), |sali| sali),
            Indicator::Fli => follow(maps, columns, steps, |orbit| Fli::new(map(orbit)), |fli| fli),
            Indicator::Megno => {
                follow(maps, columns, steps, |orbit| Megno::new(map(orbit)), |megno| megno.mean)
            }
            Indicator::Lyapunov => {
                follow(maps, columns, steps, |orbit| Lyapunov::new(map(orbit)), |found| found.value)
            }
            Indicator::Drift => {
                let worst =
                    |drifts: Vec<Drifted>| drifts.iter().map(|drifted| drifted.max).fold(0.0, f64::max);
                follow(maps, columns, steps, |orbit| IntegralDrift::of(map(orbit)), worst)
            }
            Indicator::Escape(size) => {
                let is_beyond = move |x: &[f64]| !x.iter().all(|x| x.abs() <= size);
                let number = |step: Option<u64>| step.map_or(f64::NAN, |step| step as f64);
                return follow(maps, columns, steps, |_| Escape::when(is_beyond), number);
            }
        };
        let mut values = values?;
        // What is not finite stays so: steps add to it.
        for (orbit, value) in values.iter_mut().enumerate() {
            if !columns.iter().all(|column| column[orbit].is_finite()) {
                *value = f64::NAN;
            }
        }
        Ok(values)
    }
}

/// What comes of the reports on orbits.
fn follow<O: Observer<f64>>(
    maps: &[&MapAt<f64>],
    columns: &mut [&mut [f64]],
    steps: u64,
    observer: impl Fn(usize) -> O,
    number: impl Fn(O::Report) -> f64,
) -> Result<Vec<f64>, DimensionError> {
    Ok(MapAt::observe_columns(maps, columns, steps, observer)?.into_iter().map(number).collect())
}
