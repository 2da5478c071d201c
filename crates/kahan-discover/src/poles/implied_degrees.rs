//! Computes the degrees dₙ of iterates from singularity patterns, which need not be confined.
//!
//! Let a point of a followed curve B be moved by δ off B. After k steps, its image meets a curve C
//! to the order mₖ(B, C) in δ. In step k, the power sₖ(B) of δ cancels from its homogeneous
//! coordinates. A generic line has Zₙ(C) points that reach C at step n before any other followed
//! curve. Then (degree of C)·dₙ = Zₙ(C) + Σ Zₙ₋ₖ(B)·mₖ(B, C), and dₙ₊₁ = d·dₙ − Σ Zₙ₊₁₋ₖ(B)·sₖ(B)
//! for a map of degree d. The sums are over B and k (Halburd, Proc. R. Soc. A 473, 2017, in two
//! variables).

use super::jet::Image;

/// Returns the degrees d₀, d₁, … of the iterates of a map of this degree. Each entry of `curves` is
/// the degree of a curve, with the images of this curve after 1, 2, … steps.
pub(crate) fn degrees(degree: usize, curves: &[(usize, &[Image])]) -> Option<Vec<usize>> {
    let steps = curves.iter().map(|(_, images)| images.len()).min()?;
    let mut degrees = vec![1usize];
    let mut first_times: Vec<Vec<usize>> = Vec::new();
    for n in 0..steps {
        let last = degrees[n];
        let met = curves.iter().enumerate().map(|(c, (of_curve, _))| {
            (of_curve * last).checked_sub(later(&first_times, curves, n, |image| image.contacts[c]))
        });
        let met: Vec<usize> = met.collect::<Option<_>>()?;
        first_times.push(met);
        degrees.push((degree * last).checked_sub(later(&first_times, curves, n + 1, |image| image.shared))?);
    }
    Some(degrees)
}

/// Returns Σ Zₘ(B)·`weight`(image of B after n − m steps) over all curves B and steps m below n. A
/// generic line has Zₘ(B) points that first reach B at step m.
fn later(
    first_times: &[Vec<usize>],
    curves: &[(usize, &[Image])],
    n: usize,
    weight: impl Fn(&Image) -> usize,
) -> usize {
    let of_step = |m: usize| {
        let counts = first_times[m].iter().zip(curves);
        counts.map(|(count, (_, images))| count * weight(&images[n - m - 1])).sum::<usize>()
    };
    (0..n).map(of_step).sum()
}
