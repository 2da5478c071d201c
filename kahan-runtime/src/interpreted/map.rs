//! An interpreted system as a Kahan map: every object by its program, or from the field where that
//! is beyond the budget of terms.

use kahan_core::__private::jacobian_by_duals;
use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{KahanMap, Lift, Pivot, QuadraticField, Scalar, SingularStep};

use super::program::{Inputs, Program, Registers};
use super::unplanned::Unplanned;
use super::{Interpreted, InterpretedStep};

/// The values, and 0 for each variable that stands still.
fn vector<T: Scalar, const N: usize>(mut values: impl Iterator<Item = T>) -> SVector<T, N> {
    SVector::from_fn(|_, _| values.next().unwrap_or_else(T::zero))
}

impl<T: Scalar, const N: usize> Interpreted<T, N> {
    /// A program whose results are a vector.
    fn vector(&self, program: &Program, inputs: &Inputs<'_, T>) -> SVector<T, N> {
        vector(program.values(inputs, &mut Registers::new()).iter())
    }

    /// A program whose results are numerators and the denominator behind them.
    fn fraction(&self, program: &Program, x: &SVector<T, N>, eps: &T) -> (SVector<T, N>, T) {
        let mut registers = Registers::new();
        let results = program.values(&Inputs { eps: Some(eps), ..self.inputs(x) }, &mut registers);
        let numerators = results.iter().len() - 1;
        (vector(results.iter().take(numerators)), results.get(numerators))
    }
}

impl<T: Scalar, const N: usize> QuadraticField<T, N> for Interpreted<T, N> {
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N> {
        self.vector(&self.code.field, &self.inputs(x))
    }

    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        let mut registers = Registers::new();
        let entries = self.code.field_jacobian.values(&self.inputs(x), &mut registers);
        let own = self.code.states.len();
        SMatrix::from_fn(|i, j| if i.max(j) < own { entries.get(i * own + j) } else { T::zero() })
    }

    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.vector(&self.code.bilinear, &Inputs { other: y.as_slice(), ..self.inputs(x) })
    }

    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.vector(&self.code.polarized, &Inputs { other: y.as_slice(), ..self.inputs(x) })
    }
}

impl<T: Scalar, const N: usize> KahanMap<T, N> for Interpreted<T, N> {
    type Prepared = InterpretedStep<T, N>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        InterpretedStep::new(self.clone(), eps.clone())
    }

    fn try_prepared(
        &self,
        prepared: &Self::Prepared,
        x: &SVector<T, N>,
        eps: &T,
    ) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        T::stable_step(self, prepared, x, eps)
    }

    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        match &self.code.step {
            Some(_) => jacobian_by_duals(self, x, &eps),
            None => Unplanned(self.clone()).jacobian(x, eps),
        }
    }

    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        match &self.code.det_matrix {
            Some(program) => {
                let inputs = Inputs { eps: Some(&eps), ..self.inputs(x) };
                program.values(&inputs, &mut Registers::new()).get(0)
            }
            None => Unplanned(self.clone()).det_matrix(x, eps),
        }
    }

    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match &self.code.rational_map {
            Some(program) => self.fraction(program, x, &eps),
            None => Unplanned(self.clone()).rational_map(x, eps),
        }
    }

    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match &self.code.reduced_map {
            Some(program) => self.fraction(program, x, &eps),
            None => self.rational_map(x, eps),
        }
    }
}

impl<T: Scalar, const N: usize> Lift<T, N> for Interpreted<T, N> {
    type Lifted<U: Scalar> = Interpreted<U, N>;

    fn lift<U: Scalar>(&self, lift: impl Fn(&T) -> U) -> Interpreted<U, N> {
        self.over(lift)
    }
}
