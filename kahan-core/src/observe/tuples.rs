//! Several observers as one observer: tuples, arrays and vectors.

#[cfg(feature = "std")]
use std::vec::Vec;

#[cfg(feature = "std")]
use crate::EnsembleScalar;

use super::Observer;
#[cfg(feature = "std")]
use super::{Burst, Grouped, Observers, show_in_turn};

macro_rules! tuple {
    ($($name:ident $place:tt),*) => {
        impl<T, $($name: Observer<T>),*> Observer<T> for ($($name,)*) {
            type Report = ($($name::Report,)*);

            const MAY_END: bool = false $(|| $name::MAY_END)*;

            #[inline(always)]
            fn observe(&mut self, _step: u64, _x: &[T]) {
                $(self.$place.observe(_step, _x);)*
            }

            #[inline(always)]
            fn is_done(&self) -> bool {
                false $(|| self.$place.is_done())*
            }

            #[cfg(feature = "std")]
            #[inline]
            fn observe_burst<P: Grouped<T>>(_group: &mut Observers<'_, Self>, _burst: &Burst<'_, P>)
            where
                T: EnsembleScalar,
            {
                // If an observer can end the run, the points are shown to all observers one by one.
                if <Self as Observer<T>>::MAY_END {
                    show_in_turn(_group, _burst);
                    return;
                }
                $(
                    let mut own = _group.each_mut().map(|all| all.as_mut().map(|all| &mut all.$place));
                    $name::observe_burst(&mut own, _burst);
                )*
            }

            #[allow(clippy::unused_unit, reason = "the tuple of none")]
            fn report(self) -> Self::Report {
                ($(self.$place.report(),)*)
            }
        }
    };
}

tuple!();
tuple!(A 0);
tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
tuple!(A 0, B 1, C 2, D 3, E 4);
tuple!(A 0, B 1, C 2, D 3, E 4, F 5);
tuple!(A 0, B 1, C 2, D 3, E 4, F 5, G 6);
tuple!(A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7);

impl<T, O: Observer<T>, const K: usize> Observer<T> for [O; K] {
    type Report = [O::Report; K];

    const MAY_END: bool = O::MAY_END;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        for observer in self {
            observer.observe(step, x);
        }
    }

    #[inline]
    fn is_done(&self) -> bool {
        O::MAY_END && self.iter().any(O::is_done)
    }

    fn report(self) -> Self::Report {
        self.map(O::report)
    }
}

#[cfg(feature = "std")]
impl<T, O: Observer<T>> Observer<T> for Vec<O> {
    type Report = Vec<O::Report>;

    const MAY_END: bool = O::MAY_END;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        for observer in self {
            observer.observe(step, x);
        }
    }

    #[inline]
    fn is_done(&self) -> bool {
        O::MAY_END && self.iter().any(O::is_done)
    }

    fn report(self) -> Self::Report {
        self.into_iter().map(O::report).collect()
    }
}
