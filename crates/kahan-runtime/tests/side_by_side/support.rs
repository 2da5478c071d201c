//! Fields, maps and first points.

use kahan_runtime::{Field, MachineFloat, Map};

pub(crate) const STEPS: u64 = 70;

/// Fields of one, two, three, four, five and nine variables. The last field has no machine code.
pub(crate) const FIELDS: [(&str, &[(&str, f64)]); 6] = [
    ("xdot = r - x^2;", &[("r", -0.3)]),
    ("xdot = x*(1 - y); ydot = r*y*(x - 1);", &[("r", 1.1)]),
    ("xdot = s*(y - x); ydot = x*(28 - z) - y; zdot = x*y - 8/3*z;", &[("s", 10.0)]),
    ("xdot = p; ydot = q; pdot = -a*x - 2*x*y; qdot = y^2 - x^2 - y;", &[("a", 1.0)]),
    (
        "vdot = v*(w - x); wdot = w*(x - y); xdot = x*(y - z); ydot = y*(z - v); zdot = z*(v - k*w);",
        &[("k", 1.0)],
    ),
    (
        "adot = a*(b - i); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = e*(f - d);
         fdot = f*(g - e); gdot = g*(h - f); hdot = h*(i - g); idot = i*(a - m*h);",
        &[("m", 1.0)],
    ),
];

pub(crate) fn columns<T: MachineFloat>(variables: usize, orbits: usize) -> Vec<Vec<T>> {
    let entry = |c: usize, orbit: usize| ((37 * orbit + 23 * c * (orbit + 1) + 11) % 64) as i64 - 24;
    let number = |c, orbit| T::constant(&kahan_core::Constant::ratio(entry(c, orbit), 24));
    (0..variables).map(|c| (0..orbits).map(|orbit| number(c, orbit)).collect()).collect()
}

pub(crate) fn maps() -> impl Iterator<Item = (Field, Map)> {
    FIELDS.into_iter().map(|(text, parameters)| {
        let field = Field::parse(text).expect("a field");
        let map = field.with(parameters.iter().copied()).expect("its parameters");
        (field, map)
    })
}
