//! Species along a shore, which compete with their neighbours (Lotka and Volterra).

use kahan_core::prelude::*;

kahan! {
    /// Species that each grow at a rate of their own and compete with themselves and, by `mu`, with
    /// their neighbours.
    pub struct Species {
        /// The weight of a neighbour, where a species' own kind has weight 1.
        mu,
        /// The rate of growth of each species.
        r
    }
    for i in open { n[i]dot = n[i]*(r[i] - n[i] - mu*(n[i-1] + n[i+1])); }
}
