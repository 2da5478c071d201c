//! From a system's name to its compiled map.

use kahan_algebra::system::System;
use kahan_core::Lift;
use kahan_core::num_rational::BigRational;

use kahan_runtime::interpreted::{CannotInterpret, Interpreted, VisitDimension, visit_dimension};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};
use kahan_systems::{
    HenonHeiles, LagrangeTop, Lorenz, VolterraFour, VolterraLattice, Weierstrass, ZhukovskyVolterra,
};

use super::CannotTrade;
use super::runner::{Runner, Subject};

/// A system at a point, and whether its steps are compiled code.
pub(super) struct Found {
    pub(super) runner: Box<dyn Runner>,
    pub(super) is_compiled: bool,
}

/// The catalog's compiled map under this name, or the system as it was read.
pub(super) fn find(
    system: &System,
    command: &str,
    parameters: &[BigRational],
    start: &[BigRational],
) -> Result<Found, CannotTrade> {
    let values = parameters;
    let compiled = match (command, values) {
        ("euler", [a1, a2, a3]) => {
            let [a1, a2, a3] = [a1.clone(), a2.clone(), a3.clone()];
            subject(EulerTop { a1, a2, a3 }, system, values, start)
        }
        ("lv", _) => subject(LotkaVolterra, system, values, start),
        ("e1", _) => subject(E1, system, values, start),
        ("e2", _) => subject(E2, system, values, start),
        ("e3", _) => subject(E3, system, values, start),
        ("e4", _) => subject(E4, system, values, start),
        ("e5", _) => subject(E5, system, values, start),
        ("e6", _) => subject(E6, system, values, start),
        ("e7", [xi]) => subject(E7 { xi: xi.clone() }, system, values, start),
        ("e8", _) => subject(E8, system, values, start),
        ("e9", [xi]) => subject(E9 { xi: xi.clone() }, system, values, start),
        ("weierstrass", [a]) => subject(Weierstrass { a: a.clone() }, system, values, start),
        ("volterra", _) => subject(VolterraLattice, system, values, start),
        ("volterra4", _) => subject(VolterraFour, system, values, start),
        ("lagrange", [al, g]) => subject(LagrangeTop { al: al.clone(), g: g.clone() }, system, values, start),
        ("henon-heiles", [a, b, c]) => {
            let [a, b, c] = [a.clone(), b.clone(), c.clone()];
            subject(HenonHeiles { a, b, c }, system, values, start)
        }
        ("zhukovsky", [a1, a2, a3, b1, b2, b3]) => {
            let [a1, a2, a3] = [a1.clone(), a2.clone(), a3.clone()];
            let [b1, b2, b3] = [b1.clone(), b2.clone(), b3.clone()];
            subject(ZhukovskyVolterra { a1, a2, a3, b1, b2, b3 }, system, values, start)
        }
        ("lorenz", [s, r, b]) => {
            subject(Lorenz { s: s.clone(), r: r.clone(), b: b.clone() }, system, values, start)
        }
        _ => {
            let reader = Reader { system, parameters: values, start };
            let runner =
                visit_dimension(system.field.dimension(), reader).map_err(CannotTrade::Dimension)??;
            return Ok(Found { runner, is_compiled: false });
        }
    };
    Ok(Found { runner: compiled?, is_compiled: true })
}

fn subject<M, const N: usize>(
    map: M,
    system: &System,
    parameters: &[BigRational],
    start: &[BigRational],
) -> Result<Box<dyn Runner>, CannotTrade>
where
    M: Lift<BigRational, N> + 'static,
{
    let claims = Interpreted::new(system, parameters).map_err(CannotTrade::System)?;
    Ok(Box::new(Subject::compiled(map, start, claims)))
}

/// E6 at a point of ordinary size: what is timed in place of a field without compiled code.
pub(super) fn stand_in() -> Result<Box<dyn Runner>, CannotTrade> {
    let reading = kahan_algebra::read(&kahan_algebra::lexer::lex(kahan_systems::e6::ENTRY.text()).tokens);
    let start = [1, -2, 3].map(|x| BigRational::new(x.into(), 4.into()));
    subject(E6, &reading.system, &[], &start)
}

/// Reads a system in whatever dimension it has.
struct Reader<'a> {
    system: &'a System,
    parameters: &'a [BigRational],
    start: &'a [BigRational],
}

impl VisitDimension for Reader<'_> {
    type Output = Result<Box<dyn Runner>, CannotTrade>;

    fn visit<const N: usize>(self) -> Self::Output {
        let exact: Result<Interpreted<BigRational, N>, CannotInterpret> =
            Interpreted::new(self.system, self.parameters);
        let exact = exact.map_err(CannotTrade::System)?;
        Ok(Box::new(Subject::interpreted(exact, self.start)))
    }
}
