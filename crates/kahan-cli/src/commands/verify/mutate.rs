//! `kahan verify --mutate`: no claim may survive the change of a coefficient or a sign.

use kahan_study::{Mutated, Mutations};

use super::NO_CLAIMS;

pub(super) fn text(answer: &Mutations) -> String {
    let claims = answer.mutations.len();
    if claims == 0 {
        return format!("{NO_CLAIMS}\n");
    }
    let is_at_once = |mutated: &&Mutated| mutated.failed.is_some() && mutated.tried == 1;
    format!(
        "{claims} {} mutated: {} failed, {} of them at their first mutation; {} survived; {:.2} s\n",
        if claims == 1 { "claim" } else { "claims" },
        claims - answer.survived,
        answer.mutations.iter().filter(is_at_once).count(),
        answer.survived,
        answer.seconds.unwrap_or_default()
    )
}

pub(super) fn complaint(answer: &Mutations) -> Option<String> {
    let survivors = answer.mutations.iter().filter(|mutated| mutated.failed.is_none());
    let survivors: Vec<&str> = survivors.map(|mutated| mutated.id.as_str()).collect();
    let (survived, claims) = (answer.survived, answer.mutations.len());
    (survived > 0)
        .then(|| format!("{survived} of {claims} claims survive every mutation: {}", survivors.join(", ")))
}
