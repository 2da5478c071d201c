//! Fields that occur nowhere else in this repository, as compiled code and as text for the command.

use kahan_core::prelude::*;

pub(crate) trait Text {
    const TEXT: &str;
}

macro_rules! fields {
    ($($(#[$($doc:tt)*])* $name:ident { $($block:tt)* })*) => { $(
        kahan! {
            $(#[$($doc)*])*
            pub(crate) struct $name;
            $($block)*
        }

        impl Text for $name {
            const TEXT: &str = stringify!($($block)*);
        }
    )* };
}

fields! {
    /// Two oscillators, coupled.
    Oscillators {
        qdot = p;
        pdot = -q - 2*q*r;
        rdot = s;
        sdot = -r - q^2 + r^2;
    }

    /// A gyrostat: a top with a wheel inside.
    Gyrostat {
        xdot = y*z - z/3;
        ydot = -2*z*x + z/5;
        zdot = x*y + x/3 - y/5;
    }

    /// Predators, and prey whose growth is limited.
    Tired {
        xdot = x*(1 - y) - x^2/10;
        ydot = y*(x - 1/2);
    }

    /// A rigid body with moments of inertia 1, 2, 3 and a rotor along the middle axis.
    Rotor {
        xdot = -1/6*y*z + z/4;
        ydot = 2/3*z*x;
        zdot = -1/2*x*y - x/4;
    }

    /// Waves a = p + iq, b = r + is, c = u + iv with ȧ = conj(b)·c, ḃ = conj(a)·c, ċ = −ab.
    ThreeWaves {
        pdot = r*u + s*v;
        qdot = r*v - s*u;
        rdot = u*p + v*q;
        sdot = v*p - u*q;
        udot = -(p*r - q*s);
        vdot = -(p*s + q*r);
    }

    /// Four species in a row. All but the first eat the one before, at different rates.
    Chain {
        xdot = x*(1 - 2*y);
        ydot = y*(2*x - 1/2 - z);
        zdot = z*(y - w);
        wdot = w*(3/2*z - 1/4);
    }

    /// Hénon and Heiles' system for the motion of a star in a galaxy.
    Galaxy {
        xdot = u;
        ydot = v;
        udot = -x - 2*x*y;
        vdot = -y - x^2 + y^2;
    }

    /// Nahm's equations with octahedral symmetry, whose solutions have poles as functions of time.
    Nahm {
        xdot = 2*x^2 - 12*y^2;
        ydot = -6*x*y - 4*y^2;
    }

    /// An epidemic: susceptible, infectious, recovered.
    Epidemic {
        sdot = -5/2*s*i;
        idot = 5/2*s*i - i;
        rdot = i;
    }

    /// Robertson's kinetics: stiff.
    Kinetics {
        xdot = -x/25 + 10000*y*z;
        ydot = x/25 - 10000*y*z - 30000000*y^2;
        zdot = 30000000*y^2;
    }

    /// A slow variable x, and a variable y that quickly follows x²: stiff.
    Slave {
        xdot = x - x*y;
        ydot = 500*(x^2 - y);
    }

    /// Field and Noyes' oregonator with less extreme coefficients: a relaxation oscillation.
    Relaxation {
        xdot = 20*(y - x*y + x - x^2/500);
        ydot = (z - y - x*y)/20;
        zdot = (x - z)/6;
    }
}
