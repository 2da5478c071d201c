//! Writes sentences on maps of the plane.

use crate::orbits::growth::Growth;
use crate::orbits::plane::GrowthProof;
use crate::report::Report;

pub(super) const GROWTH_ENDS: &str = "A birational map of the plane whose degrees grow exponentially permutes the curves of no pencil, so it has no rational integral (Diller and Favre 2001): nothing can be missing, and the search ended.";

pub(super) fn growth(proof: GrowthProof, entropy: f64) -> String {
    match proof {
        GrowthProof::Stable { prime } => format!(
            "The n-th iterate has the degree 2^n, proved: modulo {prime} no image of a contracted line comes to a point of indeterminacy. So the degrees grow exponentially, and the algebraic entropy is log 2 = {entropy:.4}."
        ),
        GrowthProof::Degree { iterate, degree } => {
            let most = iterate * iterate + 1;
            let about = match entropy {
                0.0 => String::new(),
                entropy => format!(", with an algebraic entropy of about {entropy:.4}"),
            };
            format!(
                "The degrees of the iterates grow exponentially, proved{about}: iterate {iterate} has a degree of {degree} at least, and of {most} at most where growth is not exponential."
            )
        }
    }
}

pub(super) fn quadratic(report: &Report) -> Option<String> {
    let degree = report.hilbert.as_ref()?.degree();
    let is_open = report.variables.len() == 2 && report.independent == 0;
    (is_open && report.growth.growth == Growth::Quadratic).then(|| format!(
        "Where growth is quadratic, as observed, the map permutes the curves of an elliptic fibration (Diller and Favre 2001). If with a finite order, an integral exists, of a degree above {degree}."
    ))
}

pub(super) fn linear_ends(report: &Report) -> Option<String> {
    let (iterates, drift) = (report.linear_iterates?, report.drifts.first()?);
    Some(format!(
        "Linear growth is observed over {iterates} iterates, not proved. Where it goes on, {} is constant on the curves of the only pencil that the map permutes (Diller and Favre 2001), a general one of them has infinitely many images, and no rational integral exists. That ended the search.",
        drift.claim.name.text
    ))
}
