//! The steps that are tested, run operation by operation from the formulas of a system.
//!
//! Every step equals that of generated code bit for bit. Constant states pad fields to four or
//! eight variables. Compiling for all dimensions up to 8 would take four times as long.

use std::fmt::Debug;

use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, KahanMap, PreparedStep};
use kahan_runtime::Map;
use kahan_runtime::interpreted::{Interpreted, UnsupportedDimension};

use super::float::Float;

/// The steps of one map in one scalar type. Each result has as many components as x.
pub(crate) trait StepMethods<T>: Debug + Send + Sync {
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T>;

    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    /// Makes the step by elimination with partial pivoting; may return `None` if det A is zero.
    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;
}

/// Returns the steps of a map in a scalar type, or an error beyond eight variables.
pub(crate) fn steps<T: Float>(map: &Map) -> Result<Box<dyn StepMethods<T>>, UnsupportedDimension> {
    match map.field().variables().len() {
        1..=4 => Ok(among::<T, 4>(map)),
        5..=8 => Ok(among::<T, 8>(map)),
        dimension => Err(UnsupportedDimension(dimension)),
    }
}

fn among<T: Float, const N: usize>(map: &Map) -> Box<dyn StepMethods<T>> {
    Box::new(map.as_kahan_map::<T, N>().expect("N is no less than the number of its variables"))
}

impl<T: Float, const N: usize> StepMethods<T> for Interpreted<T, N> {
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

fn vector<T: Float, const N: usize>(x: &[T]) -> SVector<T, N> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or_else(T::zero))
}

fn own<T: Float, const N: usize>(x: &[T], next: &SVector<T, N>) -> Vec<T> {
    next.as_slice()[..x.len()].to_vec()
}

#[cfg(test)]
mod tests {
    use kahan_core::Dd;

    use super::*;

    /// Tests that `try_step` begins with the precision of generated code: `f32` for up to four
    /// variables, and `f64` for more.
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
