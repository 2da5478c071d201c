//! The field, the Jacobians, the matrix A, the integrals, the density and the brackets of a map at
//! a state.

use crate::engine::MapObject;
use crate::{ClaimError, DimensionError};

use super::{MapAt, RuntimeFloat};

impl<T: RuntimeFloat> MapAt<T> {
    /// Writes f(x), one entry for each variable.
    ///
    /// # Errors
    /// [`DimensionError`] if the length of `x` or `out` is not the dimension n.
    pub fn field(&self, x: &[T], out: &mut [T]) -> Result<(), DimensionError> {
        self.object(MapObject::Field, x, out, self.dimension())
    }

    /// Writes f′(x), row by row: ∂fᵢ/∂xⱼ is entry n·i + j, for n variables.
    ///
    /// # Errors
    /// [`DimensionError`] unless `x` has n entries and `out` has n² entries.
    pub fn field_jacobian(&self, x: &[T], out: &mut [T]) -> Result<(), DimensionError> {
        self.object(MapObject::FieldJacobian, x, out, self.dimension().pow(2))
    }

    /// Writes A(x,ε) = I − εf′(x), row by row, for n variables.
    ///
    /// # Errors
    /// [`DimensionError`] unless `x` has n entries and `out` has n² entries.
    pub fn matrix(&self, x: &[T], out: &mut [T]) -> Result<(), DimensionError> {
        self.object(MapObject::Matrix, x, out, self.dimension().pow(2))
    }

    /// Writes ∂x̃/∂x, row by row, for n variables.
    ///
    /// # Errors
    /// [`DimensionError`] unless `x` has n entries and `out` has n² entries.
    pub fn jacobian(&self, x: &[T], out: &mut [T]) -> Result<(), DimensionError> {
        self.object(MapObject::Jacobian, x, out, self.dimension().pow(2))
    }

    /// Returns ∂x̃/∂p for the parameter p with this index. The index after the last parameter means
    /// p = ε.
    ///
    /// # Errors
    /// [`DimensionError`] if the length of `x` is not the dimension.
    ///
    /// # Panics
    /// If the index is out of range.
    pub(crate) fn by_constant(&self, place: usize, x: &[T]) -> Result<Vec<T>, DimensionError> {
        self.check_state(x)?;
        Ok(self.engine().by_constant(&self.constants, place, x))
    }

    /// Writes the integrals, in the order of [`Field::integrals`](crate::Field::integrals); for a
    /// [composition](Self::composed), writes those of the flow.
    ///
    /// # Errors
    /// [`DimensionError`] unless `x` has an entry for each variable, and `out` for each integral.
    pub fn integrals(&self, x: &[T], out: &mut [T]) -> Result<(), DimensionError> {
        self.object(MapObject::Integrals, x, out, self.map.field().integrals().len())
    }

    /// Returns the density of the invariant measure.
    ///
    /// # Errors
    /// [`ClaimError`] if the field claims no density, or the length of `x` is not the dimension.
    pub fn density(&self, x: &[T]) -> Result<T, ClaimError> {
        if self.map.field().derived().density.is_none() {
            return Err(ClaimError::NoDensity);
        }
        let mut out = [T::zero()];
        self.object(MapObject::Density, x, &mut out, 1)?;
        Ok(out[0])
    }

    /// Writes the Poisson tensor of a bracket, row by row, as n² numbers for n variables.
    ///
    /// # Errors
    /// [`ClaimError`] if the field claims no bracket called `name`, or if `x` or `out` has a wrong
    /// length.
    pub fn bracket(&self, name: &str, x: &[T], out: &mut [T]) -> Result<(), ClaimError> {
        let mut brackets = self.map.field().brackets();
        let Some(index) = brackets.position(|known| known == name) else {
            let brackets = self.map.field().brackets().map(str::to_owned).collect();
            return Err(ClaimError::NoBracket { name: name.to_owned(), brackets });
        };
        let n = self.dimension();
        self.object(MapObject::Bracket(index), x, out, n.pow(2))?;
        spread_antisymmetric(out, n);
        Ok(())
    }

    fn object(
        &self,
        object: MapObject,
        x: &[T],
        out: &mut [T],
        entries: usize,
    ) -> Result<(), DimensionError> {
        self.check_state(x)?;
        self.check_out(out, entries)?;
        if entries > 0 {
            let is_integral = matches!(object, MapObject::Integrals);
            let constants = if is_integral { &self.of_integrals } else { &self.constants };
            self.engine().evaluate(object, constants, x, out);
        }
        Ok(())
    }
}

/// Expects the entries above the diagonal first, and writes the full antisymmetric matrix.
fn spread_antisymmetric<T: RuntimeFloat>(entries: &mut [T], n: usize) {
    let mut above = n * (n - 1) / 2;
    // The loop runs backwards, so that no entry is overwritten before it is read.
    for i in (0..n).rev() {
        for j in (i + 1..n).rev() {
            above -= 1;
            entries[i * n + j] = entries[above];
        }
    }
    for i in 0..n {
        entries[i * n + i] = T::zero();
        for j in 0..i {
            entries[i * n + j] = -entries[j * n + i];
        }
    }
}
