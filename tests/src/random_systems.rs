//! Written by `random_fields::written_file`, not by hand: its fields, compiled by the macro.
//!
//! [`with_random_systems`](crate::with_random_systems) hands the list to a macro of one's own.

use kahan_core::prelude::*;

kahan! {
    /// Of dimension 1: constant, linear and quadratic terms.
    pub struct Affine1;
    xdot = 4 + (-8)*x + 2*x*x + 5*x;
}

kahan! {
    /// Of dimension 1: parameters, and divisors of them.
    pub struct Scaled1 { a, b, k }
    xdot = a*b*x*x + x*(b/(1 + k^2))/k + (a - b);
}

kahan! {
    /// Of dimension 2: one or two quadratic terms an equation.
    pub struct Sparse2;
    xdot = (-6/4)*x*x + (-7/4)*y*x;
    ydot = (-2/3)*y*y;
}

kahan! {
    /// Of dimension 2: parameters, and divisors of them.
    pub struct Scaled2 { a, b, k }
    xdot = 1/(a - b)*y*x + x*(b/(1 + k^2))/k + (a - b);
    ydot = (-b)*y*x + x*(1/(a - b))/k;
}

kahan! {
    /// Of dimension 2: awkward spellings, and cubic terms that cancel.
    pub struct Spelled2;
    Tdot = -(-T*0.1*h) + T^2*h - T*1e2/0.7 - T*h*T;
    hdot = -h^2 + h^2*T + 1_000/3 - h*T*h;
}

kahan! {
    /// Of dimension 2: every monomial in every equation.
    pub struct Dense2;
    xdot = -3 + (-4)*x + 7*x*x + 2/3*x*y + 4/5*y + 9/2*y*y;
    ydot = -6 + (-9)*x + (-9/7)*x*x + 3*x*y + (-3/3)*y + 7/3*y*y;
}

kahan! {
    /// Of dimension 3: one or two quadratic terms an equation.
    pub struct Sparse3;
    xdot = 7/6*y*y + 2*y*y;
    ydot = 5*x*y;
    zdot = 1*y*z + (-9/6)*y*x;
}

kahan! {
    /// Of dimension 3: constant, linear and quadratic terms.
    pub struct Affine3;
    xdot = 1/2 + (-3/6)*y + (-7)*x*y + 7*x;
    ydot = -2/4 + 2*z + 6*y*y + 8*x;
    zdot = -8/5 + (-7/6)*x + 7*z*z + (-3)*y;
}

kahan! {
    /// Of dimension 3: awkward spellings, and cubic terms that cancel.
    pub struct Spelled3;
    Tdot = T*(h - x_)^1 + T^2*h + 1_000/3 - T*h*T;
    hdot = (h + 2*x_)^2/3 + h^2*x_ + 1.5e-3*T - h*x_*h;
    x_dot = (x_ + T)*(x_ - T) + x_^2*T + 12.50*T^0 - x_*T*x_;
}

kahan! {
    /// Of dimension 4: parameters, and divisors of them.
    pub struct Scaled4 { a, b, k }
    xdot = (a - k)/(3*k)*x*y + u*(b/(1 + k^2))/k + (a - b);
    ydot = (a - k)/(3*k)*y*y + x*(-b)/k;
    zdot = 1/(a - b)*z*z + x*a/k;
    udot = b/(1 + k^2)*y*u + x*(1/(a - b))/k;
}

kahan! {
    /// Of dimension 5: constant, linear and quadratic terms.
    pub struct Affine5;
    xdot = -2 + (-5)*u + (-4)*y*x + 7*v;
    ydot = 6 + 6*z + 3/7*v*y + 6*u;
    zdot = -4 + 2/2*u + 9/6*z*u + 1/4*u;
    udot = 6/7 + (-5)*u + 8*v*x + (-7/2)*v;
    vdot = 6 + (-9)*v + (-9/5)*u*z + (-4)*v;
}

kahan! {
    /// Of dimension 6: one or two quadratic terms an equation.
    pub struct Sparse6;
    xdot = 1*y*v;
    ydot = (-6)*v*z + 9/2*u*w;
    zdot = (-2)*w*v;
    udot = (-7/5)*x*u + 4*y*w;
    vdot = (-5)*v*v;
    wdot = (-8)*z*z + 7/4*w*v;
}

kahan! {
    /// Of dimension 6: every monomial in every equation.
    pub struct Dense6;
    xdot = -2 + (-4/2)*x + 8/2*x*x + (-2)*x*y + (-3)*x*z + (-8)*x*u + 3*x*v + (-7)*x*w + (-1)*y + (-1)*y*y + (-3)*y*z + (-4/6)*y*u + 4/5*y*v + (-1)*y*w + (-4)*z + (-4)*z*z + 8*z*u + 4/2*z*v + (-5)*z*w + 2*u + (-5)*u*u + (-2/2)*u*v + (-8)*u*w + (-4/4)*v + 3/5*v*v + 4*v*w + 8*w + 3*w*w;
    ydot = -1 + 2*x + (-8)*x*x + (-1)*x*y + (-5)*x*z + 7*x*u + 3*x*v + 5*x*w + (-6)*y + (-7)*y*y + (-6)*y*z + 7*y*u + (-1)*y*v + 4*y*w + (-6/4)*z + 5/5*z*z + (-9/6)*z*u + 7*z*v + (-2)*z*w + (-7/3)*u + (-3/5)*u*u + (-7)*u*v + (-2)*u*w + (-1/7)*v + (-8)*v*v + 1*v*w + (-6/5)*w + (-6/5)*w*w;
    zdot = 3 + 7*x + (-5)*x*x + 1/5*x*y + (-3)*x*z + (-1)*x*u + (-2/4)*x*v + (-3)*x*w + (-1)*y + 1*y*y + 4*y*z + (-3)*y*u + (-1)*y*v + (-5)*y*w + (-5)*z + 8/4*z*z + (-1/2)*z*u + 7*z*v + 1*z*w + 2/6*u + 9*u*u + (-7/7)*u*v + 7*u*w + 6/5*v + 3/3*v*v + 8*v*w + 6*w + (-7)*w*w;
    udot = 8/7 + 2*x + (-8)*x*x + (-9/3)*x*y + (-8/5)*x*z + 1*x*u + (-2)*x*v + 1*x*w + (-9)*y + 7/7*y*y + (-1)*y*z + (-9/3)*y*u + 7*y*v + (-3/2)*y*w + 8*z + 8*z*z + 9*z*u + (-5/7)*z*v + 9*z*w + (-5)*u + (-7)*u*u + (-5/4)*u*v + (-2)*u*w + 2*v + 2*v*v + (-1)*v*w + 3/2*w + (-1)*w*w;
    vdot = 4 + 2*x + 9*x*x + 3*x*y + (-5/4)*x*z + 4/6*x*u + 2/6*x*v + (-7/7)*x*w + 2*y + (-7)*y*y + 3*y*z + 7/5*y*u + (-8)*y*v + (-1/7)*y*w + (-4/6)*z + 1*z*z + 2*z*u + 2*z*v + (-9/4)*z*w + (-5)*u + 7/7*u*u + (-6)*u*v + (-7)*u*w + (-8)*v + (-8)*v*v + 3*v*w + 8/2*w + 5/3*w*w;
    wdot = 8 + 1*x + 5/2*x*x + 5/2*x*y + 7*x*z + (-9)*x*u + (-7)*x*v + 8/4*x*w + (-8)*y + (-1)*y*y + 2*y*z + 8*y*u + (-9/6)*y*v + (-9/2)*y*w + 6*z + 4/7*z*z + 6/5*z*u + 2*z*v + 8/6*z*w + 8*u + (-8)*u*u + (-1)*u*v + (-1)*u*w + 4*v + (-5)*v*v + (-4/5)*v*w + (-1)*w + (-3/6)*w*w;
}

kahan! {
    /// Of dimension 1: one or two quadratic terms an equation.
    pub struct Sparse1;
    xdot = (-9/7)*x*x;
}

kahan! {
    /// Of dimension 1: awkward spellings, and cubic terms that cancel.
    pub struct Spelled1;
    Tdot = (T + 2*T)^2/3 + T^2*T + 12.50*T^0 - T*T*T;
}

kahan! {
    /// Of dimension 1: every monomial in every equation.
    pub struct Dense1;
    xdot = -7/2 + 9*x + (-1)*x*x;
}

kahan! {
    /// Of dimension 2: constant, linear and quadratic terms.
    pub struct Affine2;
    xdot = 1/7 + (-5)*y + (-3)*y*x + (-2/5)*x;
    ydot = -7/3 + 2/2*x + (-4/4)*y*x + 4*y;
}

kahan! {
    /// Of dimension 3: parameters, and divisors of them.
    pub struct Scaled3 { a, b, k }
    xdot = (-b)*y*y + x*(-b)/k + (a - b);
    ydot = a*y*z + z*(1/(a - b))/k;
    zdot = (a - k)/(3*k)*y*x + z*(b/(1 + k^2))/k;
}

kahan! {
    /// Of dimension 3: every monomial in every equation.
    pub struct Dense3;
    xdot = -6 + (-2/7)*x + (-9)*x*x + (-8)*x*y + (-5)*x*z + (-6)*y + (-1/6)*y*y + (-8/2)*y*z + 6/3*z + 1/4*z*z;
    ydot = -9/7 + 4/5*x + 6*x*x + (-6/4)*x*y + (-5)*x*z + (-2)*y + (-6/2)*y*y + 8*y*z + 6*z + (-5)*z*z;
    zdot = -5/6 + (-1)*x + (-5)*x*x + (-7/7)*x*y + (-2)*x*z + (-3/5)*y + 2*y*y + 9*y*z + (-6/4)*z + (-9/4)*z*z;
}

kahan! {
    /// Of dimension 4: one or two quadratic terms an equation.
    pub struct Sparse4;
    xdot = (-7)*x*x + 5/7*z*y;
    ydot = 6*u*x + (-8)*z*x;
    zdot = 2/6*x*x;
    udot = 2*x*z;
}

kahan! {
    /// Of dimension 4: constant, linear and quadratic terms.
    pub struct Affine4;
    xdot = 4 + 9*z + 2*u*x + (-3)*y;
    ydot = -5 + 3*y + (-9)*x*x + 7*x;
    zdot = 5/5 + 1*x + 5/2*x*z + 6*z;
    udot = -3/6 + 2*u + 1*z*u + (-3/5)*u;
}

kahan! {
    /// Of dimension 4: awkward spellings, and cubic terms that cancel.
    pub struct Spelled4;
    Tdot = (T + h)*(T - h) + T^2*h + 1.5e-3*x_ - T*h*T;
    hdot = -(-h*0.1*x_) + h^2*x_ + 12.50*x_^0 - h*x_*h;
    x_dot = -x_^2 + x_^2*in - T*1e2/0.7 - x_*in*x_;
    indot = in*(T - h)^1 + in^2*T + 1_000/3 - in*T*in;
}

kahan! {
    /// Of dimension 4: every monomial in every equation.
    pub struct Dense4;
    xdot = -3/2 + 6*x + (-9/6)*x*x + (-5)*x*y + 2*x*z + (-2)*x*u + 2/6*y + (-2)*y*y + (-2/4)*y*z + (-9)*y*u + (-3)*z + (-9/5)*z*z + (-7/2)*z*u + 6*u + 1*u*u;
    ydot = 5 + 4/5*x + (-8)*x*x + (-7)*x*y + (-6/3)*x*z + 2/3*x*u + (-2)*y + (-6)*y*y + 8*y*z + (-6/3)*y*u + (-6)*z + 5/3*z*z + (-9/7)*z*u + 5/5*u + (-7/7)*u*u;
    zdot = 4 + 8*x + (-8)*x*x + 9*x*y + (-2)*x*z + (-2)*x*u + (-3)*y + (-7)*y*y + 9*y*z + (-7)*y*u + (-3/5)*z + 6*z*z + 9/5*z*u + (-9/5)*u + (-2/5)*u*u;
    udot = -9 + 3*x + 7*x*x + (-7/7)*x*y + 6*x*z + (-9)*x*u + 7*y + 4*y*y + 4/7*y*z + 2*y*u + 3/2*z + 7*z*z + (-8)*z*u + 8*u + 8/6*u*u;
}

kahan! {
    /// Of dimension 5: one or two quadratic terms an equation.
    pub struct Sparse5;
    xdot = (-5)*u*x + 5*y*v;
    ydot = (-3)*u*y;
    zdot = (-7)*z*y + 3*u*z;
    udot = 2/2*x*y + 5*x*v;
    vdot = 8*u*x + (-4)*u*v;
}

kahan! {
    /// Of dimension 5: parameters, and divisors of them.
    pub struct Scaled5 { a, b, k }
    xdot = a*x*z + v*((a - k)/(3*k))/k + (a - b);
    ydot = a*z*z + u*(a*b)/k;
    zdot = 1/(a - b)*y*y + v*a/k;
    udot = (-b)*v*u + z*(a*b)/k;
    vdot = (-b)*y*v + y*(a*b)/k;
}

kahan! {
    /// Of dimension 5: awkward spellings, and cubic terms that cancel.
    pub struct Spelled5;
    Tdot = -x_^2 + x_^2*in + 12.50*in^0 - x_*in*x_;
    hdot = in*(N - T)^1 + in^2*N - T*1e2/0.7 - in*N*in;
    x_dot = (N + 2*T)^2/3 + N^2*T + 1_000/3 - N*T*N;
    indot = (T + h)*(T - h) + T^2*h + 1.5e-3*x_ - T*h*T;
    Ndot = -(-h*0.1*x_) + h^2*x_ + 12.50*x_^0 - h*x_*h;
}

kahan! {
    /// Of dimension 5: every monomial in every equation.
    pub struct Dense5;
    xdot = -6 + (-9)*x + (-3)*x*x + (-1/3)*x*y + 6*x*z + (-1/4)*x*u + (-9)*x*v + 3*y + 8/4*y*y + (-3)*y*z + 6*y*u + 6*y*v + 2*z + 2/6*z*z + (-9/7)*z*u + (-3/6)*z*v + (-2/7)*u + (-3)*u*u + 2/4*u*v + 9*v + 8*v*v;
    ydot = -1 + (-2)*x + 2*x*x + 2*x*y + (-6)*x*z + (-6/7)*x*u + 6*x*v + (-9/2)*y + (-5)*y*y + 8*y*z + 6*y*u + 5/4*y*v + (-3)*z + (-6)*z*z + (-7)*z*u + 5*z*v + (-5/2)*u + (-7/2)*u*u + (-4/5)*u*v + (-3)*v + 9/2*v*v;
    zdot = -6 + 1*x + (-6/5)*x*x + 6*x*y + 2*x*z + 6*x*u + 5/5*x*v + 5/3*y + (-3)*y*y + (-5)*y*z + 5*y*u + 4*y*v + (-7)*z + 1*z*z + 2*z*u + (-6)*z*v + (-9/2)*u + (-1/7)*u*u + 7*u*v + 3*v + 4*v*v;
    udot = 6 + 1/7*x + 8/7*x*x + 1*x*y + 1*x*z + 8*x*u + 1*x*v + (-3)*y + 7/6*y*y + 8/3*y*z + (-4)*y*u + (-4)*y*v + 4*z + (-4/5)*z*z + 8/6*z*u + 8*z*v + 1*u + 4/3*u*u + 3/7*u*v + 8*v + (-1)*v*v;
    vdot = -8/2 + (-6/5)*x + 9*x*x + (-1/4)*x*y + 5*x*z + (-9)*x*u + 5*x*v + 6/4*y + (-1)*y*y + 1*y*z + 3/6*y*u + (-1)*y*v + 4/2*z + 3/5*z*z + 9*z*u + (-7/5)*z*v + (-9/6)*u + 6/4*u*u + (-6)*u*v + (-3/7)*v + 9*v*v;
}

kahan! {
    /// Of dimension 6: constant, linear and quadratic terms.
    pub struct Affine6;
    xdot = 5 + 3*z + (-2)*v*v + 6*v;
    ydot = -6/4 + 6/7*y + 9*v*w + 4/3*v;
    zdot = 4/4 + (-8)*y + (-5)*w*y + 9*u;
    udot = -5 + 7*z + 5/4*z*z + 3*x;
    vdot = -9 + 3*z + (-1/3)*u*z + (-9)*w;
    wdot = -6 + 3*y + 3*y*v + 4/6*y;
}

kahan! {
    /// Of dimension 6: parameters, and divisors of them.
    pub struct Scaled6 { a, b, k }
    xdot = a*b*x*z + v*(-b)/k + (a - b);
    ydot = a*b*w*u + y*((a - k)/(3*k))/k;
    zdot = a*b*y*z + z*((a - k)/(3*k))/k;
    udot = b/(1 + k^2)*w*z + z*(1/(a - b))/k;
    vdot = 1/(a - b)*z*z + y*(a*b)/k;
    wdot = a*b*x*x + y*(b/(1 + k^2))/k;
}

kahan! {
    /// Of dimension 6: awkward spellings, and cubic terms that cancel.
    pub struct Spelled6;
    Tdot = (h + 2*x_)^2/3 + h^2*x_ - in*1e2/0.7 - h*x_*h;
    hdot = (x_ + in)*(x_ - in) + x_^2*in + 1_000/3 - x_*in*x_;
    x_dot = -(-in*0.1*N) + in^2*N + 1.5e-3*Vec - in*N*in;
    indot = -N^2 + N^2*Vec + 12.50*Vec^0 - N*Vec*N;
    Ndot = Vec*(T - h)^1 + Vec^2*T - h*1e2/0.7 - Vec*T*Vec;
    Vecdot = (T + 2*h)^2/3 + T^2*h + 1_000/3 - T*h*T;
}

/// Calls a macro with every field, `Name: dimension { parameter = p / d, … }`: those that are
/// compiled over floats, too, and the others.
#[macro_export]
macro_rules! with_random_systems {
    ($callback:ident) => {
        $callback! {
            in_floats {
                Affine1: 1 {},
                Scaled1: 1 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Sparse2: 2 {},
                Scaled2: 2 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Spelled2: 2 {},
                Dense2: 2 {},
                Sparse3: 3 {},
                Affine3: 3 {},
                Spelled3: 3 {},
                Scaled4: 4 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Affine5: 5 {},
                Sparse6: 6 {},
                Dense6: 6 {},
            }
            over_rationals {
                Sparse1: 1 {},
                Spelled1: 1 {},
                Dense1: 1 {},
                Affine2: 2 {},
                Scaled3: 3 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Dense3: 3 {},
                Sparse4: 4 {},
                Affine4: 4 {},
                Spelled4: 4 {},
                Dense4: 4 {},
                Sparse5: 5 {},
                Scaled5: 5 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Spelled5: 5 {},
                Dense5: 5 {},
                Affine6: 6 {},
                Scaled6: 6 { a = 3 / 2, b = -3 / 8, k = 9 / 4 },
                Spelled6: 6 {},
            }
        }
    };
}
