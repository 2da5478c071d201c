//! Steps of Clebsch's case. Its six variables are the vectors m and p, each with three components.
//!
//! # Formulas
//!
//! Let w₁, w₂, w₃ be the parameters, W = diag(w₁, w₂, w₃), c = (w₃−w₂, w₁−w₃, w₂−w₁), P = εp and a
//! = εm + P × WP. Eliminating m̃ leaves a linear system for p̃ with the matrix diag(d) + \[a\]×,
//! where \[a\]× is the matrix of the cross product with a. The vector d has d₁ = 1 − c₃P₂² + c₂P₃²,
//! and d₂, d₃ follow cyclically. Let S = Σdᵢaᵢ² and D = d₁d₂d₃ + S. The step is:
//!
//! - p̃ = p + 2(q + (Σdᵢaᵢpᵢ)a − Sp)/D, where q₁ = d₂d₃(p × a)₁, and q₂, q₃ follow cyclically,
//! - m̃₁ = m₁ + εc₁(p₂p̃₃ + p₃p̃₂), and m̃₂, m̃₃ follow cyclically.

use kahan_bench_fields::Clebsch;

use crate::contender::{Contender, Role};

pub(crate) fn contenders(map: Clebsch<f64>, start: [f64; 6], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, skew part", Role::ByHand, start, skew_part(map, eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(map, eps)),
        Contender::new("by hand, m beside p", Role::ByHand, start, m_beside_p(map, eps)),
    ]
}

pub(crate) fn skew_part(map: Clebsch<f64>, eps: f64) -> impl Fn([f64; 6]) -> [f64; 6] {
    let (c1, c2, c3) = (map.w3 - map.w2, map.w1 - map.w3, map.w2 - map.w1);
    let (e1, e2, e3) = (eps * c1, eps * c2, eps * c3);
    move |[m1, m2, m3, p1, p2, p3]| {
        let (q1, q2, q3) = (eps * p1, eps * p2, eps * p3);
        let (f1, f2, f3) = (e1 * p2, e2 * p3, e3 * p1);
        let (g1, g2, g3) = (e1 * p3, e2 * p1, e3 * p2);
        let (a1, a2, a3) = (eps * m1 + f1 * q3, eps * m2 + f2 * q1, eps * m3 + f3 * q2);
        let d1 = 1.0 + (q3 * f2 - q2 * g3);
        let d2 = 1.0 + (q1 * f3 - q3 * g1);
        let d3 = 1.0 + (q2 * f1 - q1 * g2);
        let (b1, b2, b3) = (d1 * a1, d2 * a2, d3 * a3);
        let s = b1 * a1 + (b2 * a2 + b3 * a3);
        let e = d2 * d3;
        let i = 2.0 / (d1 * e + s);
        let q = b1 * p1 + (b2 * p2 + b3 * p3);
        let n1 = e * (p2 * a3 - p3 * a2) + (a1 * q - p1 * s);
        let n2 = (d3 * d1) * (p3 * a1 - p1 * a3) + (a2 * q - p2 * s);
        let n3 = (d1 * d2) * (p1 * a2 - p2 * a1) + (a3 * q - p3 * s);
        let (x1, x2, x3) = (p1 + n1 * i, p2 + n2 * i, p3 + n3 * i);
        [m1 + (f1 * x3 + g1 * x2), m2 + (f2 * x1 + g2 * x3), m3 + (f3 * x2 + g3 * x1), x1, x2, x3]
    }
}

pub(crate) fn short_chain(map: Clebsch<f64>, eps: f64) -> impl Fn([f64; 6]) -> [f64; 6] {
    let (c1, c2, c3) = (map.w3 - map.w2, map.w1 - map.w3, map.w2 - map.w1);
    let (e1, e2, e3) = (eps * c1, eps * c2, eps * c3);
    move |[m1, m2, m3, p1, p2, p3]| {
        let (q1, q2, q3) = (eps * p1, eps * p2, eps * p3);
        let (f1, f2, f3) = (e1 * p2, e2 * p3, e3 * p1);
        let (g1, g2, g3) = (e1 * p3, e2 * p1, e3 * p2);
        let (a1, a2, a3) = (eps * m1 + f1 * q3, eps * m2 + f2 * q1, eps * m3 + f3 * q2);
        let d1 = 1.0 + (q3 * f2 - q2 * g3);
        let d2 = 1.0 + (q1 * f3 - q3 * g1);
        let d3 = 1.0 + (q2 * f1 - q1 * g2);
        let (s1, s2, s3) = (d1 * (a1 * a1), d2 * (a2 * a2), d3 * (a3 * a3));
        let i = 1.0 / ((d1 * (d2 * d3) + s1) + (s2 + s3));
        let s = s1 + (s2 + s3);
        let q = (d1 * a1) * p1 + ((d2 * a2) * p2 + (d3 * a3) * p3);
        let (q, s) = (q + q, s + s);
        let (dd2, dd3) = (d2 + d2, d3 + d3);
        let n1 = (d2 * dd3) * (p2 * a3 - p3 * a2) + (a1 * q - p1 * s);
        let n2 = (dd3 * d1) * (p3 * a1 - p1 * a3) + (a2 * q - p2 * s);
        let n3 = (d1 * dd2) * (p1 * a2 - p2 * a1) + (a3 * q - p3 * s);
        let (x1, x2, x3) = (p1 + n1 * i, p2 + n2 * i, p3 + n3 * i);
        [m1 + (f1 * x3 + g1 * x2), m2 + (f2 * x1 + g2 * x3), m3 + (f3 * x2 + g3 * x1), x1, x2, x3]
    }
}

/// Computes a step, in which the numerators of m̃ need not wait for the quotient 2/D.
pub(crate) fn m_beside_p(map: Clebsch<f64>, eps: f64) -> impl Fn([f64; 6]) -> [f64; 6] {
    let (c1, c2, c3) = (map.w3 - map.w2, map.w1 - map.w3, map.w2 - map.w1);
    let (e1, e2, e3) = (eps * c1, eps * c2, eps * c3);
    move |[m1, m2, m3, p1, p2, p3]| {
        let (f1, f2, f3) = (e1 * p3, e2 * p1, e3 * p2);
        let (g1, g2, g3) = (e1 * p2, e2 * p3, e3 * p1);
        let (h1, h2, h3) = (f1 * p2, f2 * p3, f3 * p1);
        let (a1, a2, a3) = (eps * (m1 + h1), eps * (m2 + h2), eps * (m3 + h3));
        let (q1, q2, q3) = (eps * p1, eps * p2, eps * p3);
        let d1 = 1.0 - (q2 * f3 - q3 * g2);
        let d2 = 1.0 - (q3 * f1 - q1 * g3);
        let d3 = 1.0 - (q1 * f2 - q2 * g1);
        let (x1, x2, x3) = (p2 * a3 - p3 * a2, p3 * a1 - p1 * a3, p1 * a2 - p2 * a1);
        let (b1, b2, b3) = (d1 * a1, d2 * a2, d3 * a3);
        let e = d2 * d3;
        let i = 2.0 / ((d1 * e + a1 * b1) + (a2 * b2 + a3 * b3));
        let n1 = e * x1 - (b2 * x3 - b3 * x2);
        let n2 = d3 * (d1 * x2) - (b3 * x1 - b1 * x3);
        let n3 = (d1 * d2) * x3 - (b1 * x2 - b2 * x1);
        [
            m1 + ((h1 + h1) + (g1 * n3 + f1 * n2) * i),
            m2 + ((h2 + h2) + (f2 * n3 + g2 * n1) * i),
            m3 + ((h3 + h3) + (g3 * n2 + f3 * n1) * i),
            p1 + n1 * i,
            p2 + n2 * i,
            p3 + n3 * i,
        ]
    }
}
