//! Tangent vectors of a map.
//!
//! In: a map at its ε. Out: the tangent map v ↦ (∂x̃/∂x)·v. A straight-line program computes it
//! from x and a known x̃. Otherwise Kahan's map of the variational field advances x and v.

use kahan_core::observe::{GROUP, Grouped, SideBySide, Tangent, TangentMap, are_moderate};
use kahan_dynamics::Precision;
use smallvec::SmallVec;

use super::group::{AlignedGroups, MOST};
use crate::engine::{MapObject, Scratch, determinant, with_scratch};
use crate::{Field, MachineFloat, MapAt, Rational, RuntimeFloat, RuntimePoint, Sensitivity};

const MOST_COLUMNS: usize = 3 * MOST + 2;

impl<T: MachineFloat> MapAt<T> {
    /// Returns the tangent map. Its state is a point, followed by a tangent vector at the point.
    #[must_use]
    pub fn tangent(&self) -> Tangent<Self> {
        Tangent::new(self.clone(), 1)
    }

    /// Returns whether a straight-line program propagates tangent vectors after x̃ is computed.
    pub(super) fn has_tangent_line(&self) -> bool {
        let has_plain_steps = matches!(self.kind.precision, Precision::Single | Precision::Double);
        let is_composed = self.composition.stages() > 1;
        has_plain_steps && !is_composed && self.engine().line(MapObject::Tangent).is_some()
    }

    fn check_lengths(&self, x: &[T], v: &[T]) {
        let n = self.dimension();
        assert!(
            x.len() == n && v.len() == n,
            "a point of {} numbers and a vector of {} for a map of {n} variables",
            x.len(),
            v.len()
        );
    }

    pub(super) fn variational(&self) -> &Self {
        self.variational.get_or_init(|| self.sensitivities(&[Sensitivity::Start]))
    }
}

impl<T: RuntimeFloat> MapAt<T> {
    /// Returns the map of a point and its derivatives.
    ///
    /// A state holds x, then a vector for each entry of `by`. Begin with a vector of zeros, or for
    /// [`Sensitivity::Start`] with the unit vector of a coordinate. With [`Sensitivity::Epsilon`],
    /// the map has one more parameter, 1/ε, which comes last in [columns](Self::advance_columns).
    ///
    /// The last bits of x may differ from those of this map, since the larger field has its own
    /// plan. For a compiled map, use [`Tangent`], or parameters of type [`Dual`](kahan_core::Dual).
    ///
    /// Cost: the first call for a field plans a field with 1 + `by.len()` times as many variables.
    ///
    /// ```
    /// use kahan_runtime::{Sensitivity, Field};
    ///
    /// // x' = a·x²: one step takes x to x/(1 − 2εax)
    /// let at = Field::parse("xdot = a*x^2;").unwrap().with([("a", 3)]).unwrap().at(0.125);
    /// let mut state = [0.5, 0.0, 1.0];
    /// let vectors = [Sensitivity::Parameter(0), Sensitivity::Start];
    /// at.sensitivities(&vectors).advance(&mut state, 1).unwrap();
    /// assert_eq!(state, [0.8, 0.16, 2.56]);
    /// ```
    #[must_use]
    pub fn sensitivities(&self, by: &[Sensitivity]) -> Self {
        let field = Field { engine: self.engine().sensitivities(by) };
        let mut parameters = self.map.parameters().to_vec();
        let (own, eps) = self.parameters_and_eps();
        let mut constants = own.to_vec();
        if by.contains(&Sensitivity::Epsilon) {
            let inverse = T::one() / eps;
            parameters.push(Rational::from_f64(inverse.approximate()).unwrap_or_default());
            constants.push(inverse);
        }
        constants.push(eps);
        let map = crate::Map::new(field, parameters, self.kind.fuses);
        MapAt::new(map, constants.into(), self.kind.precision).composed(self.composition)
    }
}

/// Cost: the first tangent vector of a field plans the variational field, in some tens of
/// milliseconds.
///
/// ```
/// use kahan_core::Orbit;
/// use kahan_core::observe::Lyapunov;
/// use kahan_runtime::Field;
///
/// let map = Field::parse("xdot = x*(1 - y); ydot = y*(x - 1);").unwrap().map().unwrap().at(0.05);
/// let mut orbit = Orbit::new(&map, vec![1.5, 1.0]);
/// let exponent = orbit.observe(10_000, Lyapunov::new(&map));
/// assert!(exponent.value.abs() < exponent.error);
/// ```
impl<T: MachineFloat> TangentMap for MapAt<T> {
    fn push_forward(&self, x: &[T], v: &mut Vec<T>) {
        self.check_lengths(x, v);
        if self.has_tangent_line() {
            let mut next = RuntimePoint::from_slice(x);
            self.advance_checked([&mut next, &mut []], 1);
            return self.push_forward_to(x, &next, v);
        }
        let mut both: SmallVec<[T; 16]> = x.iter().chain(v.iter()).copied().collect();
        self.variational().advance_checked([&mut both, &mut []], 1);
        v.copy_from_slice(&both[x.len()..]);
    }

    fn push_forward_to(&self, x: &[T], next: &[T], v: &mut Vec<T>) {
        if !self.has_tangent_line() {
            return self.push_forward(x, v);
        }
        self.check_lengths(x, v);
        self.check_lengths(next, v);
        let state: SmallVec<[T; 32]> = [x, v, next, next].into_iter().flatten().copied().collect();
        self.engine().evaluate(MapObject::Tangent, &self.constants, &state, v);
    }

    /// Propagates one or two vectors of each orbit, if there is machine code.
    fn push_forward_group<P: Grouped<T>>(
        maps: [&Self; GROUP],
        SideBySide { places, vectors, squares, .. }: SideBySide<'_, T, P>,
    ) -> Option<usize> {
        let (variables, count) = (places.first()?.as_ref().len(), vectors.len());
        with_scratch(T::single(), |Scratch { given, .. }| {
            let workspace = core::mem::take(given);
            let abreast = match maps[0].has_tangent_line() {
                true => MapAt::group_code_with_vectors(maps, (count, true), workspace)?,
                false => MapAt::variational_abreast(maps, count, workspace)?,
            };
            let mut columns = AlignedGroups::<T, MOST_COLUMNS>::zeros();
            let columns = columns.0.get_mut(..variables * (1 + count) + count)?;
            let (_, carried) = columns.split_at_mut(variables);
            for (own, column) in carried.iter_mut().zip(vectors.iter().flat_map(P::as_ref)) {
                *own = *column;
            }
            let mut taken = 0;
            let mut squares = squares.chunks_exact_mut(count);
            for place in &places[..places.len() - 1] {
                columns[..variables].copy_from_slice(place.as_ref());
                abreast.step(columns);
                let found = &columns[variables * (1 + count)..];
                taken += 1;
                if let Some(squares) = squares.next() {
                    squares.iter_mut().zip(found).for_each(|(square, found)| *square = *found);
                    if !are_moderate(squares) {
                        break;
                    }
                }
            }
            for (column, carried) in vectors.iter_mut().flat_map(P::as_mut).zip(&columns[variables..]) {
                *column = *carried;
            }
            *given = abreast.into_memory();
            Some(taken)
        })
    }

    fn det_jacobian(&self, x: &[T]) -> T {
        let columns = (0..x.len()).flat_map(|i| {
            let mut column = vec![T::zero(); x.len()];
            column[i] = T::one();
            self.push_forward(x, &mut column);
            column
        });
        determinant(&mut columns.collect::<Vec<T>>(), x.len())
    }
}
