//! From a system's name to its compiled map.

use kahan_algebra::system::System;
use kahan_core::Lift;
use kahan_core::num_rational::BigRational;

use kahan_runtime::interpreted::{CannotInterpret, Interpreted, VisitDimension, visit_dimension};
use kahan_systems::{E6, with_catalog};

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
    if let Some(runner) = compiled(system, command, parameters, start) {
        return Ok(Found { runner: runner?, is_compiled: true });
    }
    let reader = Reader { system, parameters, start };
    let runner = visit_dimension(system.field.dimension(), reader).map_err(CannotTrade::Dimension)??;
    Ok(Found { runner, is_compiled: false })
}

macro_rules! compiled_maps {
    ($($group:ident {
        $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)*
    })*) => {
        /// The catalog's compiled map under this name, where there is one with so many parameters.
        fn compiled(
            system: &System,
            command: &str,
            parameters: &[BigRational],
            start: &[BigRational],
        ) -> Option<Result<Box<dyn Runner>, CannotTrade>> {
            $($(
                if command == kahan_systems::$module::ENTRY.command {
                    let [$($($parameter),*)?] = parameters else { return None };
                    let map = kahan_systems::$type { $($($parameter: $parameter.clone()),*)? };
                    return Some(subject(map, system, parameters, start));
                }
            )*)*
            None
        }
    };
}

with_catalog!(compiled_maps);

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
