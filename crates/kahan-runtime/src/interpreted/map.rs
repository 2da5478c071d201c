//! Implements [`KahanMap`] for an interpreted system.
//!
//! In: a state, and ε. Out: x̃, its Jacobian, integrals and so on. Programs compute them. If a
//! program would be too long, linear algebra with A(x,ε) = I − εf′(x) gives x̃, its Jacobian and
//! det A. Dual numbers give the Jacobian if the step has a program.

use std::marker::PhantomData;
use std::sync::Arc;

use kahan_core::__private::{
    determinant, determinant_and_adjugate_product, jacobian_by_duals, pole, solve, stable_step,
};
use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{ExtendScalars, KahanMap, Pivot, QuadraticField, Scalar, SingularStep};

use smallvec::SmallVec;

use crate::engine::MapObject;
use crate::line::Line;

use super::{Interpreted, InterpretedStep};

fn vector<T: Scalar, const N: usize>(mut values: impl Iterator<Item = T>) -> SVector<T, N> {
    SVector::from_fn(|_, _| values.next().unwrap_or_else(T::zero))
}

impl<T: Scalar, const N: usize> Interpreted<T, N> {
    fn fraction(&self, line: &Line, x: &SVector<T, N>, eps: &T) -> (SVector<T, N>, T) {
        self.run(line, x.as_slice(), eps, |results| {
            let numerators = results.iter().len() - 1;
            (vector(results.iter().take(numerators)), results.get(numerators))
        })
    }

    fn vector_of(&self, object: MapObject, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        self.run(self.engine.known_line(object), x.as_slice(), eps, |results| vector(results.iter()))
    }

    fn slopes_of(&self, object: MapObject, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        let own = self.variables().len();
        self.run(self.engine.known_line(object), x.as_slice(), eps, |entries| {
            SMatrix::from_fn(|i, j| if i.max(j) < own { entries.get(i * own + j) } else { T::zero() })
        })
    }

    fn vector_of_two(&self, object: MapObject, points: [&SVector<T, N>; 2], eps: &T) -> SVector<T, N> {
        let own = self.variables().len();
        let mut entries: SmallVec<[T; 16]> = SmallVec::new();
        points.into_iter().for_each(|point| entries.extend(point.iter().take(own).cloned()));
        self.run(self.engine.known_line(object), &entries, eps, |results| vector(results.iter()))
    }
}

impl<T: Scalar, const N: usize> QuadraticField<T, N> for Interpreted<T, N> {
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N> {
        self.vector_of(MapObject::Field, x, &T::zero())
    }

    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.slopes_of(MapObject::FieldJacobian, x, &T::zero())
    }

    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.vector_of_two(MapObject::Bilinear, [x, y], &T::zero())
    }

    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.vector_of_two(MapObject::Polarized, [x, y], &T::zero())
    }
}

impl<T: Scalar, const N: usize> KahanMap<T, N> for Interpreted<T, N> {
    type Prepared = InterpretedStep<T, N>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        InterpretedStep::new(self.clone(), eps.clone())
    }

    fn has_coefficients_of_eps(&self) -> bool {
        self.engine.derived.system.field.depends_on_eps()
    }

    fn field_at(&self, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        self.vector_of(self.engine.at_eps(MapObject::Field), x, eps)
    }

    fn field_jacobian_at(&self, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        self.slopes_of(self.engine.at_eps(MapObject::FieldJacobian), x, eps)
    }

    fn polarized_at(&self, x: &SVector<T, N>, y: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        self.vector_of_two(self.engine.at_eps(MapObject::Polarized), [x, y], eps)
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
        stable_step(self, prepared, x, eps)
    }

    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        if self.engine.derived.step().is_some() {
            return jacobian_by_duals(self, x, &eps);
        }
        let next = self.step(x, eps.clone());
        let mut jacobian = self.matrix(&next, -eps.clone());
        let Some((tables, mut factors)) = self.factors(x.as_slice(), &eps) else {
            return solve(self.matrix(x, eps.clone()), jacobian).unwrap_or_else(|| pole(&eps));
        };
        let own = self.variables().len();
        for column in jacobian.data.0.iter_mut().take(own) {
            tables.solve(&mut factors, &mut column[..own], 1, 0);
        }
        jacobian
    }

    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        match self.engine.line(MapObject::DetMatrix) {
            Some(line) => self.run(line, x.as_slice(), &eps, |results| results.get(0)),
            None => determinant(self.matrix(x, eps)),
        }
    }

    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match self.engine.line(MapObject::RationalMap) {
            Some(line) => self.fraction(line, x, &eps),
            None => determinant_and_adjugate_product(&self.matrix(x, eps.clone()), &self.rhs(x, eps)),
        }
    }

    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match self.engine.line(MapObject::ReducedMap) {
            Some(line) => self.fraction(line, x, &eps),
            None => self.rational_map(x, eps),
        }
    }
}

impl<T: Scalar, const N: usize> ExtendScalars<T, N> for Interpreted<T, N> {
    type Extended<U: Scalar> = Interpreted<U, N>;

    fn extend_scalars<U: Scalar>(&self, convert: impl Fn(&T) -> U) -> Interpreted<U, N> {
        let parameters = self.parameters.iter().map(convert).collect();
        Interpreted { engine: Arc::clone(&self.engine), parameters, dimension: PhantomData }
    }
}
