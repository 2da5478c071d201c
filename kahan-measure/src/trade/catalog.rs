//! From a system's name to the orbits of its compiled map.

use kahan_core::Lift;
use kahan_core::num_rational::BigRational;
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};
use kahan_systems::{
    HenonHeiles, LagrangeTop, Lorenz, VolterraFour, VolterraLattice, Weierstrass, ZhukovskyVolterra,
};

use super::kind::Kind;
use super::walk::{Walker, walk};

/// Hands over the orbit from a point, in a kind of arithmetic, with an ε.
pub(super) type Compiled = Box<dyn Fn(&[BigRational], Kind, f64, Walker<'_>)>;

/// The orbits of the catalog's compiled map under this name.
pub(super) fn compiled(command: &str, parameters: &[BigRational]) -> Option<Compiled> {
    Some(match (command, parameters) {
        ("lv", _) => orbits(LotkaVolterra),
        ("e1", _) => orbits(E1),
        ("e2", _) => orbits(E2),
        ("e3", _) => orbits(E3),
        ("e4", _) => orbits(E4),
        ("e5", _) => orbits(E5),
        ("e6", _) => orbits(E6),
        ("e8", _) => orbits(E8),
        ("volterra", _) => orbits(VolterraLattice),
        ("volterra4", _) => orbits(VolterraFour),
        (command, _) => return with_parameters(command, parameters.to_vec()),
    })
}

/// The same for the systems that have parameters.
fn with_parameters(command: &str, parameters: Vec<BigRational>) -> Option<Compiled> {
    fn array<const P: usize>(parameters: Vec<BigRational>) -> Option<[BigRational; P]> {
        parameters.try_into().ok()
    }
    Some(match command {
        "e7" => array(parameters).map(|[xi]| orbits(E7 { xi }))?,
        "e9" => array(parameters).map(|[xi]| orbits(E9 { xi }))?,
        "euler" => array(parameters).map(|[a1, a2, a3]| orbits(EulerTop { a1, a2, a3 }))?,
        "weierstrass" => array(parameters).map(|[a]| orbits(Weierstrass { a }))?,
        "lagrange" => array(parameters).map(|[al, g]| orbits(LagrangeTop { al, g }))?,
        "henon-heiles" => array(parameters).map(|[a, b, c]| orbits(HenonHeiles { a, b, c }))?,
        "zhukovsky" => array(parameters)
            .map(|[a1, a2, a3, b1, b2, b3]| orbits(ZhukovskyVolterra { a1, a2, a3, b1, b2, b3 }))?,
        "lorenz" => array(parameters).map(|[s, r, b]| orbits(Lorenz { s, r, b }))?,
        _ => return None,
    })
}

fn orbits<M, const N: usize>(map: M) -> Compiled
where
    M: Lift<BigRational, N> + 'static,
{
    Box::new(move |start, kind, eps, walker| walk(&map, start, kind, eps, walker))
}
