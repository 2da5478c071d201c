//! From a system's name to the orbits of its compiled map.

use kahan_core::num_rational::BigRational;
use kahan_core::{Lift, Scheme};
use kahan_systems::with_catalog;

use super::walk::{Walker, walk};

/// Hands over the orbit from a point, in a scheme, with an ε.
pub(super) type Compiled = Box<dyn Fn(&[BigRational], Scheme, f64, Walker<'_>)>;

macro_rules! compiled_maps {
    ($($group:ident {
        $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)*
    })*) => {
        /// The orbits of the catalog's compiled map under this name, where there is one with so
        /// many parameters.
        pub(super) fn compiled(command: &str, parameters: &[BigRational]) -> Option<Compiled> {
            $($(
                if command == kahan_systems::$module::ENTRY.command {
                    let [$($($parameter),*)?] = parameters else { return None };
                    return Some(orbits(kahan_systems::$type { $($($parameter: $parameter.clone()),*)? }));
                }
            )*)*
            None
        }
    };
}

with_catalog!(compiled_maps);

fn orbits<M, const N: usize>(map: M) -> Compiled
where
    M: Lift<BigRational, N> + 'static,
{
    Box::new(move |start, scheme, eps, walker| walk(&map, start, scheme, eps, walker))
}
