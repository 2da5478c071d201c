//! Fields with known answers, and a watch.

#![allow(dead_code, unused_imports, reason = "not every test uses all of it")]

mod recording;
mod reports;

use kahan_algebra::system::System;
use kahan_algebra::{lexer, read};
use kahan_discover::Report;

pub(crate) use recording::Recording;
pub(crate) use reports::*;

pub(crate) const E1: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;";
pub(crate) const E2: &str = "xdot = -x^2; ydot = x*y; zdot = -2*y^2 + x*z;";
pub(crate) const E3: &str = "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;";
pub(crate) const E4: &str = "xdot = -x*z; ydot = y*z; zdot = x^2 - y^2;";
pub(crate) const E5: &str = "xdot = x*y; ydot = -x^2; zdot = y*(2*x - z);";
pub(crate) const E6: &str = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);";
pub(crate) const E7: &str = "xdot = -x^2; ydot = -xi*x*y; zdot = 2*xi*y^2 + x*z;";
pub(crate) const E8: &str = "xdot = -x^2; ydot = -x*(x + y); zdot = 2*y*(x + y) + x*z;";
pub(crate) const E9: &str = "xdot = -x*z; ydot = -xi*y*z; zdot = x^2 + xi*y^2;";
pub(crate) const EULER: &str = "xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;";
pub(crate) const LOTKA_VOLTERRA: &str = "xdot = x*(1 - y); ydot = y*(x - 1);";
pub(crate) const WEIERSTRASS: &str = "xdot = y; ydot = 6*x^2 - a;";
pub(crate) const VOLTERRA: &str = "xdot = x*(y - z); ydot = y*(z - x); zdot = z*(x - y);";
pub(crate) const LAGRANGE: &str = "m1dot = (al - 1)*m2*m3 + g*p2; m2dot = (1 - al)*m1*m3 - g*p1; m3dot = 0; \
    p1dot = al*p2*m3 - p3*m2; p2dot = p3*m1 - al*p1*m3; p3dot = p1*m2 - p2*m1;";
pub(crate) const HENON_HEILES: &str = "xdot = p; ydot = q; pdot = -a*x - 2*x*y; qdot = -b*y - x^2 + c*y^2;";
pub(crate) const LORENZ: &str = "xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;";
pub(crate) const ZHUKOVSKY: &str =
    "xdot = a1*y*z + b3*y - b2*z; ydot = a2*z*x + b1*z - b3*x; zdot = a3*x*y + b2*x - b1*y;";

pub(crate) fn system(text: &str) -> System {
    read(&lexer::lex(text).tokens).system().expect("a system")
}

pub(crate) fn claims(report: &Report) -> Vec<&str> {
    let formulas = report.integrals.iter().chain(&report.densities).map(|formula| formula.text.as_str());
    let brackets = report.brackets.iter().map(|bracket| bracket.text.as_str());
    formulas.chain(brackets).chain(report.drifts.iter().map(|drift| drift.text.as_str())).collect()
}
