//! The macros of the crate.
//!
//! `kahan!` passes `$crate` to the procedural macro, so that renamed dependencies work. The crate
//! has its own `vector!`, because that of nalgebra works only for users who depend on `nalgebra`.

/// Turns a quadratic system of differential equations into its Kahan map.
///
/// [The language](crate::language) has its own chapter with grammar, limits and examples.
///
/// A block is an optional header, one equation `NAMEdot = expression;` per state variable, and
/// claims. Expressions are polynomials of degree at most 2 in the variables, with the usual
/// precedence: `x^2 - z^2` is (x²) − (z²). Numbers are exact: `0.1` is one tenth.
///
/// - With a header, `struct Name;` or `struct Name { a, b }`, the block becomes that struct
///   (`Name<T>` with one public field for each parameter). The struct implements
///   [`QuadraticField`](crate::QuadraticField), [`KahanMap`](crate::KahanMap) and
///   [`Named`](crate::Named).
/// - Without a header, the block is an expression whose value has an anonymous type. The expression
///   captures its parameters from the scope.
///
/// A block that begins with `lift` may contain functions, quotients and arbitrary powers. Write
/// `lift pub struct Pendulum { g }`, or `lift;` without a header. New variables make the equations
/// quadratic. `embed` maps states to points of the lift, and `project` maps points back to states.
///
/// Claims state properties of the map. `integral NAME = expression;` claims a function that the map
/// conserves, `density` an invariant measure, and `bracket` a Poisson tensor. `drift` claims a
/// function whose next value depends only on its current value. Claims are proved at compile time,
/// and a false claim does not compile. In claims and coefficients `eps` is ε, **half** the time
/// step.
///
/// ```
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// The system E6 of Hone and Petrera, which is integrable as a flow and as a map.
///     pub struct E6;
///     xdot = y*(2*z - x);
///     ydot = x^2 - z^2;
///     zdot = y*(z - 2*x);
///     integral h = (x*z + y^2)/(1 - 3*eps^2*x*z);
///     integral k = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
/// }
///
/// let eps = 0.005_f64; // a time step of 0.01
/// let start = vector![0.3, 0.8, 0.5];
/// let before = E6.integrals(&start, eps);
///
/// let end = E6.orbit(start, eps).nth(1000).unwrap();
/// let after = E6.integrals(&end, eps);
/// assert!((after - before).norm() < 1e-12);
/// assert_eq!(E6.h(&end, eps), after[0]);
///
/// // The inverse of a step is the step with −ε.
/// assert!((E6.step_back(&E6.step(&start, eps), eps) - start).norm() < 1e-15);
/// ```
#[macro_export]
macro_rules! kahan {
    ($($tokens:tt)*) => {
        $crate::__private::kahan_derive::kahan! { [$crate] $($tokens)* }
    };
}

/// Turns the block in a file into its Kahan map, as [`kahan!`](crate::kahan) does for a block.
///
/// The path is relative to the file of the macro call. If the file changes, the crate is compiled
/// again. Errors are shown with line and caret, as the command `kahan` shows them.
///
/// ```ignore
/// include_kahan!("toda.kahan");
/// ```
#[macro_export]
macro_rules! include_kahan {
    ($file:tt) => {
        $crate::__private::kahan_derive::include_kahan! { [$crate] $file }
    };
}

/// Makes a state from its entries: `vector![1.0, 2.0]` is an `SVector<f64, 2>`.
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
