//! Placeholders for `BigRational` in builds without `exact`, so that errors name this feature.

use core::marker::PhantomData;

/// A placeholder for big rationals, which need the feature `exact`.
pub type BigRational = Unavailable<FeatureExact>;

/// A number type that needs the missing feature F.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unavailable<F>(PhantomData<F>);

/// The feature `exact`, which is disabled in this build.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeatureExact;

/// A bound that never holds. rustc prints this message if a call requires a missing feature.
#[diagnostic::on_unimplemented(
    message = "`BigRational` needs the feature `exact` of `kahan-core`",
    label = "enable it in Cargo.toml: `kahan-core = {{ …, features = [\"exact\"] }}`"
)]
trait IsEnabled {}

#[expect(private_bounds, reason = "no feature that is off can be enabled by a type")]
impl<F> Unavailable<F> {
    /// Fails to compile without the feature `exact`.
    pub fn new(_numer: i128, _denom: i128) -> Self
    where
        F: IsEnabled,
    {
        Self(PhantomData)
    }

    /// Fails to compile without the feature `exact`.
    pub fn from_integer(_integer: i128) -> Self
    where
        F: IsEnabled,
    {
        Self(PhantomData)
    }

    /// Fails to compile without the feature `exact`.
    pub fn from_float(_float: f64) -> Option<Self>
    where
        F: IsEnabled,
    {
        None
    }
}
