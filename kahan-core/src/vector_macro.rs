//! `vector!`, our own: nalgebra's expands to paths that begin with `nalgebra::`, which a user need not depend on.

/// A state from its entries, of any scalar: `vector![1.0, 2.0]` is an `SVector<f64, 2>`.
///
/// ```
/// use kahan_core::prelude::*;
///
/// let x: SVector<f64, 3> = vector![1.0, 0.5, -2.0];
/// assert_eq!(x[2], -2.0);
/// ```
#[macro_export]
macro_rules! vector {
    ($($entry:expr),* $(,)?) => {
        $crate::__private::vector([$($entry),*])
    };
}
