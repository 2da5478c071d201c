//! Blocks with names of the prelude, names that are keywords, and names of generated items.

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

kahan! {
    /// A type and parameters named like common type parameters, and states with short names.
    pub(super) struct T { N, S }
    tdot = h + eps_;
    hdot = -N*t*x_;
    eps_dot = S*t;
    x_dot = t^2 - h^2/N;
}

kahan! {
    /// A system whose states have the names of Rust keywords.
    pub(super) struct Keywords;
    indot = as*in;
    asdot = self - type;
    selfdot = -as*self + loop;
    typedot = 1;
    loopdot = in^2;
}

kahan! {
    /// A system with names of Rust's prelude and of primitive types.
    pub(super) struct Vec { Vec, Some, None, Clone, str, f64 }
    Resultdot = Vec*Option - Some;
    Optiondot = None*Result + Clone*Option^2;
    Boxdot = str*Option - f64*Result*Box;
}

kahan! {
    /// A system with names of temporary variables in generated code.
    pub(super) struct Temporaries { p_x, half_step, state, other, system, field, extended, numerators, denominator }
    s_xdot = p_x*t_1 + half_step*o_x;
    t_1dot = state*s_x - other*o_x^2;
    o_xdot = system*field*s_x*t_1 + extended;
    c_2dot = numerators*s_x + 2*c_2*denominator;
}

kahan! {
    /// A system whose parameters have names of generated items.
    pub(super) struct U { convert, prepared }
    xdot = convert*x*y;
    ydot = prepared*x^2;
}

/// A module for the unit struct `x`, because no variable can be named `x` beside it.
#[allow(non_camel_case_types, reason = "a name to be in the way")]
pub(super) mod argument {
    kahan_core::kahan! {
        /// A system without parameters, named like an argument of generated functions.
        pub(in super::super) struct x;
        ydot = x;
        xdot = -y;
        integral H = x^2 + y^2;
    }
}

kahan! {
    /// A system with names that contain non-ASCII letters, and names that differ by case only.
    pub(super) struct Größe { größe, Größe }
    Xdot = größe*x*X;
    xdot = Größe*X - x;
}

kahan! {
    /// A state and a parameter that differ by an underscore only.
    pub(super) struct Underscores { x_, __x }
    xdot = x_*_x - __x*x;
    _xdot = x;
}

kahan! {
    /// A system whose claims have the names of methods, of constants and of Rust keywords.
    pub(super) struct Claims { k }
    xdot = k*y;
    ydot = -k*x;
    integral step = x^2 + y^2;
    integral VARIABLES = step^2;
    integral integral_step = 2*step;
    integral r#match = 3*step;
    integral energy = step/2;
    density density = 1/step;
    bracket bracket { {x,y} = 1; }
    bracket type { {x,y} = step; }
}

#[test]
fn names_of_blocks_do_not_meet_names_of_the_macro() {
    assert_kahan(&T { N: ratio(3, 2), S: ratio(1, 3) });
    assert_kahan(&Keywords);
    assert_kahan(&Vec {
        Vec: ratio(1, 2),
        Some: ratio(1, 3),
        None: ratio(1, 4),
        Clone: ratio(1, 5),
        str: ratio(1, 6),
        f64: ratio(1, 7),
    });
    assert_kahan(&Temporaries {
        p_x: ratio(1, 2),
        half_step: ratio(1, 3),
        state: ratio(1, 4),
        other: ratio(1, 5),
        system: ratio(1, 6),
        field: ratio(1, 7),
        extended: ratio(1, 8),
        numerators: ratio(1, 9),
        denominator: ratio(1, 10),
    });
    assert_kahan(&U { convert: ratio(1, 2), prepared: ratio(1, 3) });
    assert_kahan(&argument::x);
    assert_kahan(&Größe { größe: ratio(1, 2), Größe: ratio(1, 3) });
    assert_kahan(&Underscores { x_: ratio(1, 2), __x: ratio(1, 3) });
    assert_eq!(T::<f64>::VARIABLES, ["t", "h", "eps_", "x_"]);
    assert_eq!(Keywords::VARIABLES, ["in", "as", "self", "type", "loop"]);
}

#[test]
fn claims_may_have_the_names_of_methods() {
    let (x, next) = assert_kahan(&Claims { k: ratio(3, 2) });
    let claims = Claims { k: ratio(3, 2) };
    assert_eq!(claims.integrals(&x, ratio(1, 2)), claims.integrals(&next, ratio(1, 2)));
    // Accessors have the names of their claims, with a prefix if another item has the name.
    let own = [
        claims.integral_step(&x, ratio(1, 2)),
        claims.integral_VARIABLES(&x, ratio(1, 2)),
        claims.integral_integral_step(&x, ratio(1, 2)),
        claims.integral_match(&x, ratio(1, 2)),
        claims.energy(&x, ratio(1, 2)),
    ];
    assert_eq!(claims.integrals(&x, ratio(1, 2)).as_slice(), own);
    assert_eq!(claims.density(&x, ratio(1, 2)), claims.density(&next, ratio(1, 2)));
    assert_eq!(claims.bracket_bracket(&x, ratio(1, 2))[(1, 0)], ratio(-1, 1));
    assert_eq!(claims.bracket_type(&x, ratio(1, 2)), claims.bracket_type(&next, ratio(1, 2)));
    assert_eq!(Claims::<BigRational>::INTEGRALS, ["step", "VARIABLES", "integral_step", "match", "energy"]);
}

kahan! {
    /// A system whose index constants would collide with each other, with H or with VARIABLES.
    struct Places { mu }
    xdot = y;
    ydot = -mu*x;
    hdot = 0;
    variablesdot = 0;
    Edot = 0;
    edot = 0;
    ßdot = h;
    integral H = mu*x^2 + y^2;
}

#[test]
fn a_state_has_a_constant_of_its_name() {
    assert_eq!([Places::X, Places::Y, Places::SS], [0, 1, 6]);
    let point = vector![1, 2, 3, 4, 5, 6, 7].map(|state| ratio(state, 1));
    assert_eq!(Places { mu: ratio(3, 1) }.H(&point, ratio(1, 9)), ratio(3, 1) + point[Places::Y].pow(2));
    assert_eq!(Places::<f32>::VARIABLES[Places::SS], "ß");
    assert_eq!(argument::x::Y + argument::x::X, 1);
}
