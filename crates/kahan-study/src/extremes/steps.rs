//! The steps that are judged: a system's plans, run one operation after the other.
//!
//! In: a system at values of its parameters at which it is defined. Out: every step of its map over
//! a scalar, with the bits of the code that the macro writes for it (which tests show on the whole
//! catalog), so that a verdict on these is a verdict on that. A map has as many variables as its
//! field: how `try_step` begins depends on their number.

use std::fmt::Debug;

use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, KahanMap, PreparedStep};
use kahan_runtime::Map;
use kahan_runtime::interpreted::{Interpreted, UnsupportedDimension};

use super::float::Float;

/// The steps of one map over one scalar. A step has as many components as x.
pub(super) trait Steps<T>: Debug + Send + Sync {
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
pub(super) fn steps<T: Float>(map: &Map) -> Result<Box<dyn Steps<T>>, UnsupportedDimension> {
    let dimension = map.field().variables().len();
    Ok(match dimension {
        1 => of::<T, 1>(map),
        2 => of::<T, 2>(map),
        3 => of::<T, 3>(map),
        4 => of::<T, 4>(map),
        5 => of::<T, 5>(map),
        6 => of::<T, 6>(map),
        7 => of::<T, 7>(map),
        8 => of::<T, 8>(map),
        _ => return Err(UnsupportedDimension(dimension)),
    })
}

fn of<T: Float, const N: usize>(map: &Map) -> Box<dyn Steps<T>> {
    Box::new(map.as_kahan_map::<T, N>().expect("N is the number of its variables"))
}

impl<T: Float, const N: usize> Steps<T> for Interpreted<T, N> {
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T> {
        list(&KahanMap::step(&self.with_parameters(parameters), &vector(x), eps))
    }

    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(list(&T::wider_step(self.with_parameters(parameters), &vector(x), eps)?))
    }

    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(list(&Elimination::new(self.with_parameters(parameters), eps).next(&vector(x))?))
    }

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(list(&KahanMap::try_step(&self.with_parameters(parameters), &vector(x), eps).ok()?))
    }
}

fn vector<T: Float, const N: usize>(x: &[T]) -> SVector<T, N> {
    SVector::from_fn(|i, _| x[i])
}

fn list<T: Float, const N: usize>(next: &SVector<T, N>) -> Vec<T> {
    next.iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use kahan_core::Dd;

    use super::*;

    /// `f32` of three variables begins in `f32`, and of five in `f64`: a type of more variables
    /// would not begin as users' code does.
    #[test]
    fn a_map_has_as_many_variables_as_its_field() {
        let mut text = String::new();
        for n in 1..=8 {
            text += &format!("x{n}dot = x{n}*x1;");
            let map = kahan_runtime::Field::parse(&text).unwrap().with([("", 0.0); 0]).unwrap();
            let types = format!("{:?}{:?}", steps::<f32>(&map), steps::<Dd>(&map));
            assert_eq!(types.matches(&format!("PhantomData<[(); {n}]>")).count(), 2, "{types}");
        }
        text += "x9dot = x9;";
        let map = kahan_runtime::Field::parse(&text).unwrap().with([("", 0.0); 0]).unwrap();
        assert!(steps::<f64>(&map).is_err());
    }
}
