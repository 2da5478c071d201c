//! The steps that are judged: a system's plans, run one operation after the other.
//!
//! In: a system at values of its parameters at which it is defined. Out: every step of its map over
//! a scalar, with the bits of the code that the macro writes for it (which tests show on the whole
//! catalog), so that a verdict on these is a verdict on that. The types have four or eight
//! variables, of which those beyond the field's own stand still: `try_step` begins in one way up to
//! four and in another beyond, and two types take a quarter of the time to compile that eight take.

use std::fmt::Debug;

use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, KahanMap, PreparedStep};
use kahan_runtime::Map;
use kahan_runtime::interpreted::{Interpreted, UnsupportedDimension};

use super::float::Float;

/// The steps of one map over one scalar. A step has as many components as x.
pub(crate) trait Steps<T>: Debug + Send + Sync {
    /// x̃ by `step`, whatever it is.
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T>;

    /// x̃ by the step through a wider format; `None` where the scalar has none.
    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    /// x̃ by elimination with partial pivoting; `None` where det A is zero and the scalar has no
    /// reciprocal of that.
    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    /// x̃ by `try_step`; `None` where it is flagged.
    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;
}

/// Those of a map.
///
/// # Errors
/// Where it has more variables than there are types for.
pub(crate) fn steps<T: Float>(map: &Map) -> Result<Box<dyn Steps<T>>, UnsupportedDimension> {
    match map.field().variables().len() {
        1..=4 => Ok(among::<T, 4>(map)),
        5..=8 => Ok(among::<T, 8>(map)),
        dimension => Err(UnsupportedDimension(dimension)),
    }
}

fn among<T: Float, const N: usize>(map: &Map) -> Box<dyn Steps<T>> {
    Box::new(map.as_kahan_map::<T, N>().expect("N is no less than the number of its variables"))
}

impl<T: Float, const N: usize> Steps<T> for Interpreted<T, N> {
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T> {
        own(x, &KahanMap::step(&self.with_parameters(parameters), &vector(x), eps))
    }

    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(x, &T::wider_step(self.with_parameters(parameters), &vector(x), eps)?))
    }

    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(x, &Elimination::new(self.with_parameters(parameters), eps).next(&vector(x))?))
    }

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(x, &KahanMap::try_step(&self.with_parameters(parameters), &vector(x), eps).ok()?))
    }
}

/// The state among N variables; those beyond its own are 0.
fn vector<T: Float, const N: usize>(x: &[T]) -> SVector<T, N> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or_else(T::zero))
}

/// As many components of the next state as the state x has.
fn own<T: Float, const N: usize>(x: &[T], next: &SVector<T, N>) -> Vec<T> {
    next.as_slice()[..x.len()].to_vec()
}

#[cfg(test)]
mod tests {
    use kahan_core::Dd;

    use super::*;

    /// `f32` of up to four variables begins in `f32`, and of more in `f64`: among eight variables
    /// a field of three would not begin as users' code does.
    #[test]
    fn a_map_begins_as_generated_code_of_its_variables_does() {
        let mut text = String::new();
        for n in 1..=8 {
            text += &format!("x{n}dot = x{n}*x1;");
            let map = kahan_runtime::Field::parse(&text).unwrap().with([("", 0.0); 0]).unwrap();
            let types = format!("{:?}{:?}", steps::<f32>(&map), steps::<Dd>(&map));
            let size = if n <= 4 { 4 } else { 8 };
            assert_eq!(types.matches(&format!("PhantomData<[(); {size}]>")).count(), 2, "{types}");
            let x: Vec<f32> = (0..n).map(|i| 1.0 + i as f32).collect();
            assert_eq!(steps(&map).unwrap().step(&[], &x, 0.125).len(), n);
        }
        text += "x9dot = x9;";
        let map = kahan_runtime::Field::parse(&text).unwrap().with([("", 0.0); 0]).unwrap();
        assert!(steps::<f64>(&map).is_err());
    }
}
