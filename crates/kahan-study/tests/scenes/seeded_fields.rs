//! Twenty fields, with the starts and the simulated times of their scenes.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::prelude::*;

/// Draws uniformly from [0, 1).
fn unit(rng: &mut SplitMix64) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

fn between(rng: &mut SplitMix64, low: f64, high: f64) -> f64 {
    low + (high - low) * unit(rng)
}

/// Draws log-uniformly between two numbers.
pub(crate) fn log_between(rng: &mut SplitMix64, low: f64, high: f64) -> f64 {
    between(rng, low.ln(), high.ln()).exp()
}

/// Draws a small displacement from an equilibrium, with a random sign.
fn off(rng: &mut SplitMix64) -> f64 {
    let size = log_between(rng, 1e-12, 1e-2);
    if rng.next_u64().is_multiple_of(2) { size } else { -size }
}

pub(crate) trait Cases<const N: usize> {
    const NAME: &str;
    const HORIZONS: (f64, f64);

    fn start(rng: &mut SplitMix64) -> [f64; N];
}

/// Declares a field by a `kahan!` block, its range of simulated times, and its random start.
macro_rules! case {
    ($(#[$doc:meta])* $name:ident[$n:literal], $low:literal..$high:literal, |$rng:ident| $start:expr, { $($block:tt)* }) => {
        kahan! {
            $(#[$doc])*
            pub(crate) struct $name;
            $($block)*
        }

        impl Cases<$n> for $name {
            const NAME: &str = stringify!($name);
            const HORIZONS: (f64, f64) = ($low, $high);

            fn start($rng: &mut SplitMix64) -> [f64; $n] {
                $start
            }
        }
    };
}

/// Draws a point in the box of the first list, or the point of the second list near an equilibrium.
macro_rules! start {
    ($rng:ident, [$($low:literal..$high:literal),*], [$($near:expr),*]) => {
        if $rng.next_u64().is_multiple_of(3) { [$($near),*] } else { [$(between($rng, $low, $high)),*] }
    };
}

case!(
    /// Predator and prey; a saddle at the origin.
    Prey[2], 1.0..100.0, |rng| start!(rng, [0.1..3.0, 0.1..3.0], [off(rng).abs(), off(rng).abs()]),
    { xdot = x*(1 - y); ydot = y*(x - 1); }
);
case!(
    /// A free rigid body; its middle axis is unstable.
    Body[3], 1.0..100.0, |rng| start!(rng, [-1.0..1.0, -1.0..1.0, -1.0..1.0], [off(rng), 1.0, off(rng)]),
    { xdot = y*z; ydot = -2*z*x; zdot = x*y; }
);
case!(
    /// Flow E6 of Hone and Petrera; heteroclinic orbits.
    Sixth[3], 1.0..40.0, |rng| start!(rng, [-1.0..1.0, -1.0..1.0, -1.0..1.0], [1.0 + off(rng), off(rng), 1.0]),
    { xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x); }
);
case!(
    /// Lorenz' attractor.
    Weather[3], 0.5..40.0,
    |rng| start!(rng, [-15.0..15.0, -15.0..15.0, 5.0..40.0], [1.0 + off(rng), 1.0, 1.0 + off(rng)]),
    { xdot = 10*(y - x); ydot = x*(28 - z) - y; zdot = x*y - 8/3*z; }
);
case!(
    /// Rössler's attractor, where z has spikes.
    Spikes[3], 1.0..100.0, |rng| start!(rng, [-8.0..8.0, -8.0..8.0, 0.0..5.0], [off(rng), off(rng), 0.0]),
    { xdot = -y - z; ydot = x + y/5; zdot = 1/5 + z*(x - 57/10); }
);
case!(
    /// Hénon and Heiles' galaxy, partly chaotic; at high energy stars leave it.
    Galaxy[4], 1.0..200.0,
    |rng| start!(rng, [-0.4..0.4, -0.4..0.4, -0.4..0.4, -0.4..0.4], [off(rng), 1.0 + off(rng), off(rng), 0.0]),
    { xdot = u; ydot = v; udot = -x - 2*x*y; vdot = -y - x^2 + y^2; }
);
case!(
    /// Robertson's kinetics: stiff.
    Kinetics[3], 0.01..4.0,
    |rng| start!(rng, [0.5..1.0, 0.0..1e-4, 0.0..0.5], [1.0, 0.0, off(rng).abs()]),
    { xdot = -x/25 + 10000*y*z; ydot = x/25 - 10000*y*z - 30000000*y^2; zdot = 30000000*y^2; }
);
case!(
    /// Field and Noyes' oregonator, softened: a relaxation oscillation.
    Relaxation[3], 1.0..60.0,
    |rng| start!(rng, [1.0..100.0, 1.0..20.0, 1.0..100.0], [1.0 + off(rng), 2.0, 1.0]),
    { xdot = 20*(y - x*y + x - x^2/500); ydot = (z - y - x*y)/20; zdot = (x - z)/6; }
);
case!(
    /// Logistic growth; states near the equilibrium 0 change slowly at first.
    Growth[1], 1.0..60.0, |rng| start!(rng, [0.01..2.0], [off(rng).abs()]), { xdot = x*(1 - x); }
);
case!(
    /// An epidemic, which may start with almost nobody infected.
    Epidemic[3], 1.0..60.0, |rng| start!(rng, [0.1..1.0, 0.0..0.5, 0.0..0.5], [1.0, off(rng).abs(), 0.0]),
    { sdot = -5/2*s*i; idot = 5/2*s*i - i; rdot = i; }
);
case!(
    /// Riccati's equation for x; orbits may escape to infinity.
    Escape[2], 0.1..4.0, |rng| start!(rng, [-2.0..1.0, -1.0..1.0], [off(rng), off(rng)]),
    { xdot = 1 + x^2; ydot = x*y - y^2; }
);
case!(
    /// Nahm's equations with octahedral symmetry: a pole is never far.
    Monopole[2], 0.05..2.0, |rng| start!(rng, [-1.0..0.5, -0.5..0.5], [off(rng), off(rng)]),
    { xdot = 2*x^2 - 12*y^2; ydot = -6*x*y - 4*y^2; }
);
case!(
    /// Three resonant waves, one of which decays into the others.
    Waves[6], 1.0..60.0,
    |rng| start!(
        rng,
        [-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0],
        [off(rng), 0.0, off(rng), off(rng), 1.0, 0.0]
    ),
    {
        pdot = r*u + s*v; qdot = r*v - s*u; rdot = u*p + v*q;
        sdot = v*p - u*q; udot = -(p*r - q*s); vdot = -(p*s + q*r);
    }
);
case!(
    /// Four species in a row.
    Species[4], 1.0..60.0,
    |rng| start!(rng, [0.1..1.0, 0.1..1.0, 0.1..1.0, 0.1..1.0], [0.5, off(rng).abs(), 0.5, off(rng).abs()]),
    { xdot = x*(1 - 2*y); ydot = y*(2*x - 1/2 - z); zdot = z*(y - w); wdot = w*(3/2*z - 1/4); }
);
case!(
    /// A top with a wheel inside.
    Wheel[3], 1.0..80.0, |rng| start!(rng, [-1.0..1.0, -1.0..1.0, -1.0..1.0], [off(rng), 1.0, off(rng)]),
    { xdot = y*z - z/3; ydot = -2*z*x + z/5; zdot = x*y + x/3 - y/5; }
);
case!(
    /// A fast variable that is the slave of a slow one: stiff.
    Slave[2], 0.5..20.0, |rng| start!(rng, [0.1..2.0, 0.0..2.0], [off(rng).abs(), 0.0]),
    { xdot = x - x*y; ydot = 500*(x^2 - y); }
);
case!(
    /// Weierstrass' function ℘ and its derivative; orbits may reach a pole of ℘.
    Elliptic[2], 0.2..4.0, |rng| start!(rng, [-0.9..0.5, -1.0..1.0], [-0.5 + off(rng), off(rng)]),
    { xdot = y; ydot = 6*x^2 - 2; }
);
case!(
    /// Sprott's case B: chaos; the equilibria are (1, 1, 0) and (−1, −1, 0).
    Simple[3], 1.0..80.0, |rng| start!(rng, [-2.0..2.0, -2.0..2.0, -2.0..2.0], [1.0, 1.0 + off(rng), off(rng)]),
    { xdot = y*z; ydot = x - y; zdot = 1 - x*y; }
);
case!(
    /// A homoclinic orbit: it leaves a saddle slowly and comes back.
    Loop[2], 1.0..60.0, |rng| start!(rng, [-0.4..1.4, -0.4..0.4], [off(rng), off(rng)]),
    { xdot = y; ydot = x - x^2; }
);
case!(
    /// A laser that is quiet until it gives a pulse.
    Laser[2], 0.1..4.0, |rng| start!(rng, [0.0..2.0, 0.0..1.0], [0.0, off(rng).abs()]),
    { ndot = 2 - n - n*s; sdot = 100*s*(n - 1); }
);

/// Calls a macro with all fields, in a fixed order.
macro_rules! with_fields {
    ($macro:ident) => {
        $macro!(
            Prey, Body, Sixth, Weather, Spikes, Galaxy, Kinetics, Relaxation, Growth, Epidemic, Escape,
            Monopole, Waves, Species, Wheel, Slave, Elliptic, Simple, Loop, Laser
        )
    };
}
pub(crate) use with_fields;
