use kahan_core::prelude::*;

kahan! {
    /// Prey `x` and predators `y`.
    pub struct LotkaVolterra;

    xdot = x*(1 - y);
    ydot = y*(x - 1);
}
