//! Twenty fields in any units of length and time.
//!
//! If y solves ẏ = Q(y) + By + c, then x(t) = y(νt)/q solves ẋ = ν·(q·Q(x) + Bx + c/q).

use kahan_runtime::{Field, Map};

/// A field with a first point and an ε, in reference units.
#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    /// The equations. `q` is a factor of quadratic terms, and a divisor of constant terms.
    text: &'static str,
    pub(crate) eps: f64,
    pub(crate) start: &'static [f64],
}

/// Units of length and time; `length` and `time` are exponents of 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unit {
    pub(crate) length: i32,
    pub(crate) time: i32,
}

pub(crate) const ORDINARY: Unit = Unit { length: 0, time: 0 };

pub(crate) fn two_to(exponent: i32) -> f64 {
    f64::from(exponent).exp2()
}

impl Unit {
    pub(crate) fn length(self, ordinary: f64) -> f64 {
        ordinary * two_to(-self.length)
    }

    pub(crate) fn time(self, ordinary: f64) -> f64 {
        ordinary * two_to(-self.time)
    }
}

impl Case {
    /// Returns the field. Its parameters are `nu`, and `q` if the text contains `q`.
    pub(crate) fn field(&self) -> Field {
        let timed = |statement: &str| match statement.split_once("dot = ") {
            Some((variable, rate)) => format!("{variable}dot = nu*({rate});"),
            None => format!("{statement};"),
        };
        let text: String = self.text.split_terminator(';').map(timed).collect();
        Field::parse(&text).unwrap_or_else(|wrong| panic!("{}: {wrong}", self.name))
    }

    pub(crate) fn start(&self, unit: Unit) -> Vec<f64> {
        self.start.iter().map(|x| unit.length(*x)).collect()
    }
}

pub(crate) fn map(field: &Field, unit: Unit) -> Map {
    let values = [("q", two_to(unit.length)), ("nu", two_to(unit.time))];
    let known = |name: &&str| field.parameters().iter().any(|known| known == *name);
    field.with(values.iter().filter(|(name, _)| known(name)).copied()).expect("q and nu are all there is")
}

pub(crate) const CASES: [Case; 20] = [
    Case {
        name: "oscillator",
        text: "xdot = y; ydot = -x; integral H = x^2 + y^2;",
        eps: 0.1,
        start: &[1.0, 0.25],
    },
    Case { name: "driven", text: "xdot = y; ydot = -x - 0.1*y + 0.3/q;", eps: 0.2, start: &[1.0, 0.25] },
    Case { name: "logistic", text: "xdot = 1.5*x - q*x^2;", eps: 0.1, start: &[0.1] },
    Case { name: "riccati", text: "xdot = 1.3/q - 0.7*q*x^2;", eps: 0.1, start: &[0.1] },
    Case { name: "predators", text: "xdot = x*(1 - q*y); ydot = y*(q*x - 1);", eps: 0.1, start: &[1.5, 0.7] },
    Case { name: "well", text: "xdot = y; ydot = q*x^2 - x;", eps: 0.1, start: &[0.5, 0.1] },
    Case { name: "weierstrass", text: "xdot = y; ydot = 6*q*x^2 - 1.7/q;", eps: 0.05, start: &[-0.5, 0.1] },
    Case {
        name: "euler",
        text: "xdot = 1.5*q*y*z; ydot = -0.6*q*z*x; zdot = 0.7*q*x*y;",
        eps: 0.1,
        start: &[0.4, 1.1, -0.3],
    },
    Case {
        name: "lorenz",
        text: "xdot = 10*(y - x); ydot = x*(28 - q*z) - y; zdot = q*x*y - 8*z/3;",
        eps: 0.01,
        start: &[1.0, 2.0, 20.0],
    },
    Case {
        name: "volterra",
        text: "xdot = q*x*(y - z); ydot = q*y*(z - x); zdot = q*z*(x - y);",
        eps: 0.1,
        start: &[1.0, 0.3, 0.6],
    },
    Case {
        name: "e6",
        text: "xdot = q*y*(2*z - x); ydot = q*(x^2 - z^2); zdot = q*y*(z - 2*x); \
               integral H = (x*z + y^2)/(1 - 3*nu^2*q^2*eps^2*x*z); density rho = -2/((x*z + y^2)*(x^2 + y^2 + z^2));",
        eps: 0.05,
        start: &[0.3, 0.8, 0.5],
    },
    Case {
        name: "roessler",
        text: "xdot = -y - z; ydot = x + 0.2*y; zdot = 0.2/q + z*(q*x - 5.7);",
        eps: 0.02,
        start: &[1.0, -2.0, 0.3],
    },
    Case {
        name: "rabinovich",
        text: "xdot = 4*y - x + q*y*z; ydot = 4*x - y - q*x*z; zdot = q*x*y - z;",
        eps: 0.02,
        start: &[1.0, 0.5, 0.3],
    },
    Case {
        name: "gyrostat",
        text: "xdot = 1.5*q*y*z + 0.5*y + 0.4*z; ydot = -0.6*q*z*x + 0.2*z - 0.5*x; zdot = 1.7*q*x*y - 0.4*x - 0.2*y;",
        eps: 0.05,
        start: &[0.7, 0.5, 0.3],
    },
    Case {
        name: "henon-heiles",
        text: "xdot = u; ydot = v; udot = -x - 2*q*x*y; vdot = -y - q*x^2 + q*y^2;",
        eps: 0.1,
        start: &[0.1, 0.2, 0.3, -0.1],
    },
    Case {
        name: "oregonator",
        text: "xdot = 3*(y - q*x*y + x - q*x^2/12); ydot = (z - y - q*x*y)/3 + 0.1/q; zdot = 0.161*(x - z); wdot = x - w;",
        eps: 0.05,
        start: &[1.0, 0.5, 1.5, 0.7],
    },
    Case {
        name: "noumi-yamada",
        text: "adot = q*a*(b - c + d - e) + 0.1/q; bdot = q*b*(c - d + e - a) - 0.1/q; cdot = q*c*(d - e + a - b); \
               ddot = q*d*(e - a + b - c); edot = q*e*(a - b + c - d);",
        eps: 0.05,
        start: &[0.5, 0.3, 0.6, 0.2, 0.7],
    },
    Case {
        name: "lagrange",
        text: "xdot = 0.5*q*y*z + 0.6*v; ydot = -0.5*q*x*z - 0.6*u; zdot = 0; udot = q*(1.5*v*z - w*y); \
               vdot = q*(w*x - 1.5*u*z); wdot = q*(u*y - v*x);",
        eps: 0.05,
        start: &[0.4, 0.3, 0.8, 0.1, -0.5, 0.6],
    },
    Case {
        name: "fermi",
        text: "adot = u; bdot = v; cdot = w; ddot = p; udot = b - 2*a + q*(b - a)^2 - q*a^2; \
               vdot = c - 2*b + a + q*(c - b)^2 - q*(b - a)^2; wdot = d - 2*c + b + q*(d - c)^2 - q*(c - b)^2; \
               pdot = c - 2*d + q*d^2 - q*(d - c)^2;",
        eps: 0.1,
        start: &[0.1, 0.2, 0.15, -0.1, 0.05, 0.0, 0.1, -0.05],
    },
    Case {
        name: "atmosphere",
        text: "adot = q*j*(b - i) - a + 8/q; bdot = q*a*(c - j) - b + 8/q; cdot = q*b*(d - a) - c + 8/q; \
               ddot = q*c*(e - b) - d + 8/q; edot = q*d*(f - c) - e + 8/q; fdot = q*e*(g - d) - f + 8/q; \
               gdot = q*f*(h - e) - g + 8/q; hdot = q*g*(i - f) - h + 8/q; idot = q*h*(j - g) - i + 8/q; \
               jdot = q*i*(a - h) - j + 8/q;",
        eps: 0.01,
        start: &[1.0, 2.0, 3.5, 0.5, -1.0, 4.0, 2.5, 1.5, 3.0, -0.5],
    },
];
