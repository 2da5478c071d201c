//! Every system as a map over floats, behind one face: what `back_end` is for exact numbers.
//!
//! In: the catalog and the random fields. Out: [`FloatMap`]s, in the order of `subject::whole_catalog` and
//! `subject::random` and with the same parameters.

use kahan_core::prelude::*;
use kahan_core::{Constant, Orbit, SingularStep};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};
use kahan_systems::{
    HenonHeiles, LagrangeTop, Lorenz, VolterraFour, VolterraLattice, Weierstrass, ZhukovskyVolterra,
};

/// A map over a float scalar.
pub trait FloatMap<T> {
    /// x̃, whatever it is.
    fn step(&self, x: &[T], eps: T) -> Vec<T>;
    /// x̃ or why there is none.
    fn try_step(&self, x: &[T], eps: T) -> Result<Vec<T>, SingularStep>;
    /// x₁, …, x_steps by every way to take steps that the map has: `step` with ε each time, the prepared map's, its orbit,
    /// and the map's.
    fn every_way(&self, x: &[T], eps: T, steps: usize) -> [Vec<Vec<T>>; 4];
    /// Calls every method; returns the number of points of an orbit of four.
    fn call_everything(&self, x: &[T], eps: T) -> usize;
}

impl<T, M, const N: usize> FloatMap<T> for OfDimension<M, N>
where
    T: Pivot + Copy,
    M: KahanMap<T, N> + Clone,
{
    fn step(&self, x: &[T], eps: T) -> Vec<T> {
        self.0.step(&SVector::from_column_slice(x), eps).iter().copied().collect()
    }

    fn try_step(&self, x: &[T], eps: T) -> Result<Vec<T>, SingularStep> {
        let next = self.0.try_step(&SVector::from_column_slice(x), eps)?;
        Ok(next.iter().copied().collect())
    }

    fn every_way(&self, x: &[T], eps: T, steps: usize) -> [Vec<Vec<T>>; 4] {
        let start = SVector::<T, N>::from_column_slice(x);
        let (map, prepared) = (&self.0, self.0.at(eps));
        let entries = |x: &SVector<T, N>| x.iter().copied().collect::<Vec<_>>();
        let by = |step: &dyn Fn(&SVector<T, N>) -> SVector<T, N>| {
            let mut x = start;
            let points = (0..steps).map(|_| {
                x = step(&x);
                entries(&x)
            });
            points.collect()
        };
        let of = |orbit: Orbit<M, T, N>| orbit.skip(1).take(steps).map(|x| entries(&x)).collect();
        [
            by(&|x| map.step(x, eps)),
            by(&|x| prepared.step(x)),
            of(prepared.orbit(start)),
            of(map.orbit(start, eps)),
        ]
    }

    fn call_everything(&self, x: &[T], eps: T) -> usize {
        let (map, x) = (&self.0, SVector::<T, N>::from_column_slice(x));
        let _ = (map.field(&x), map.field_jacobian(&x), map.bilinear(&x, &x), map.polarized(&x, &x));
        let _ = (map.matrix(&x, eps), map.rhs(&x, eps), map.rational_map(&x, eps), map.det_matrix(&x, eps));
        let _ = (map.step(&x, eps), map.step_back(&x, eps), map.try_step(&x, eps).is_ok());
        let _ = (map.jacobian(&x, eps), map.det_jacobian(&x, eps));
        let prepared = map.at(eps);
        let _ = (prepared.step(&x), prepared.try_step(&x).is_ok(), prepared.jacobian(&x));
        map.orbit(x, eps).take(4).count()
    }
}

/// A map with its dimension.
#[derive(Clone, Copy, Debug)]
pub struct OfDimension<M, const N: usize>(M);

fn ratio<T: Scalar>(p: i64, d: i64) -> T {
    T::constant(&Constant::ratio(p, d))
}

/// The catalog at [`EULER_PARAMETERS`] and [`XI`].
#[must_use]
pub fn catalog<T: Pivot + Copy>() -> Vec<Box<dyn FloatMap<T>>> {
    let [a1, a2, a3] = EULER_PARAMETERS.map(|(p, d)| ratio(p, d));
    vec![
        Box::new(OfDimension(EulerTop { a1, a2, a3 })),
        Box::new(OfDimension(LotkaVolterra)),
        Box::new(OfDimension(E1)),
        Box::new(OfDimension(E2)),
        Box::new(OfDimension(E3)),
        Box::new(OfDimension(E4)),
        Box::new(OfDimension(E5)),
        Box::new(OfDimension(E6)),
        Box::new(OfDimension(E7 { xi: ratio(XI.0, XI.1) })),
        Box::new(OfDimension(E8)),
        Box::new(OfDimension(E9 { xi: ratio(XI.0, XI.1) })),
    ]
}

/// Dyadic, so that every float has them exactly.
pub const EULER_PARAMETERS: [(i64, i64); 3] = [(3, 2), (-5, 8), (7, 4)];
/// ξ of E7 and E9, dyadic.
pub const XI: (i64, i64) = (-5, 4);

/// The parameters of a further system by its type's name, in order: dyadic, and of the size that the literature gives them.
#[must_use]
pub fn parameters(type_name: &str) -> &'static [(i64, i64)] {
    match type_name {
        "Weierstrass" => &[(5, 4)],
        "LagrangeTop" => &[(3, 2), (5, 8)],
        "HenonHeiles" => &[(1, 1), (5, 4), (3, 4)],
        "ZhukovskyVolterra" => &[(3, 2), (-5, 8), (7, 4), (1, 4), (-3, 8), (1, 2)],
        "Lorenz" => &[(10, 1), (28, 1), (11, 4)],
        _ => &[],
    }
}

/// The catalog's further systems at their [`parameters`], in the order of the registry.
#[must_use]
pub fn further<T: Pivot + Copy>() -> Vec<Box<dyn FloatMap<T>>> {
    let of = |name: &str, k: usize| {
        let (p, d) = parameters(name)[k];
        ratio::<T>(p, d)
    };
    let [a1, a2, a3, b1, b2, b3] = [0, 1, 2, 3, 4, 5].map(|k| of("ZhukovskyVolterra", k));
    let [a, b, c] = [0, 1, 2].map(|k| of("HenonHeiles", k));
    vec![
        Box::new(OfDimension(Weierstrass { a: of("Weierstrass", 0) })),
        Box::new(OfDimension(VolterraLattice)),
        Box::new(OfDimension(VolterraFour)),
        Box::new(OfDimension(LagrangeTop { al: of("LagrangeTop", 0), g: of("LagrangeTop", 1) })),
        Box::new(OfDimension(HenonHeiles { a, b, c })),
        Box::new(OfDimension(ZhukovskyVolterra { a1, a2, a3, b1, b2, b3 })),
        Box::new(OfDimension(Lorenz { s: of("Lorenz", 0), r: of("Lorenz", 1), b: of("Lorenz", 2) })),
    ]
}

macro_rules! random_float_maps {
    ($($name:ident: $n:literal { $($parameter:ident = $p:literal / $d:literal),* }),* $(,)?) => {
        /// The random fields.
        #[must_use]
        pub fn random<T: Pivot + Copy>() -> Vec<Box<dyn FloatMap<T>>> {
            vec![$(Box::new(OfDimension::<_, $n>(
                crate::random_systems::$name { $($parameter: ratio::<T>($p, $d)),* },
            ))),*]
        }
    };
}

crate::with_random_systems!(random_float_maps);

/// A float of the machine.
pub trait MachineFloat: Pivot + Copy {
    /// The catalog and the random fields. The code of all their steps is made here, once, and not in every test that names it.
    fn maps() -> Vec<Box<dyn FloatMap<Self>>>;
}

impl MachineFloat for f32 {
    fn maps() -> Vec<Box<dyn FloatMap<f32>>> {
        catalog().into_iter().chain(random()).collect()
    }
}

impl MachineFloat for f64 {
    fn maps() -> Vec<Box<dyn FloatMap<f64>>> {
        catalog().into_iter().chain(random()).collect()
    }
}
