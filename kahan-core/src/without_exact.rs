//! `BigRational` where the feature `exact` is off: a name that cannot be used, so that rustc says
//! how to have it.

use core::marker::PhantomData;

/// Stands in for the big rationals, which need the feature `exact`.
pub type BigRational = Unavailable<FeatureExact>;

/// A number that is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unavailable<F>(PhantomData<F>);

/// The feature `exact`, which is off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeatureExact;

/// No type is this.
#[diagnostic::on_unimplemented(
    message = "`BigRational` needs the feature `exact` of `kahan-core`",
    label = "enable it in Cargo.toml: `kahan-core = {{ …, features = [\"exact\"] }}`"
)]
trait IsEnabled {}

#[expect(private_bounds, reason = "no feature that is off can be enabled by a type")]
impl<F> Unavailable<F> {
    /// numer/denom, with the feature.
    pub fn new(_numer: i128, _denom: i128) -> Self
    where
        F: IsEnabled,
    {
        Self(PhantomData)
    }

    /// An integer, with the feature.
    pub fn from_integer(_integer: i128) -> Self
    where
        F: IsEnabled,
    {
        Self(PhantomData)
    }

    /// A float's value, with the feature.
    pub fn from_float(_float: f64) -> Option<Self>
    where
        F: IsEnabled,
    {
        None
    }
}
