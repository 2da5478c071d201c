//! The findings of `discover` for a published case, compared with the known facts.

use std::collections::BTreeMap;
use std::fmt;

use kahan_algebra::render::Text;
use kahan_discover::report::ModifiedPlace;
use kahan_discover::{Options, Report, discover};

use crate::case::Case;
use crate::clock::Clock;

pub(crate) struct Outcome<'a> {
    case: &'a Case,
    /// The cells of a row of the table under the headings `integrals` to `ranks`.
    counts: [String; 5],
    last_finding: f64,
    total: f64,
    pub(crate) printed: Vec<String>,
    /// The total length of the printed claims, divided by that of the shortest known claims.
    pub(crate) ratio: Option<f64>,
    pub(crate) differences: Vec<String>,
}

impl<'a> Outcome<'a> {
    pub(crate) const HEAD: &'static str = "\
case             integrals written growth      densities drifts ranks          last     all  ratio";

    pub(crate) fn of(case: &'a Case, seconds: f64) -> Self {
        let options = Options { parameters: case.parameters.clone(), seconds, ..Options::default() };
        let clock = Clock::start();
        let report = discover(&case.system, &options, &clock);
        let (total, found) = clock.stop();
        let last_finding = found.last().map_or(0.0, |(at, _)| at.as_secs_f64());
        let mut outcome = Outcome {
            case,
            counts: Default::default(),
            last_finding,
            total: total.as_secs_f64(),
            printed: Vec::new(),
            ratio: None,
            differences: Vec::new(),
        };
        let claims = found.into_iter().map(|(_, finding)| finding.text).collect();
        match report {
            Ok(report) => outcome.compare(&report, claims),
            Err(error) => outcome.differences.push(error.to_string()),
        }
        outcome
    }

    fn compare(&mut self, report: &Report, found: Vec<String>) {
        let known = &self.case.known;
        self.printed = printed(report, found);
        let printed = by_kind(&self.printed);
        let written = printed.get("integral").map_or(0, Vec::len);
        let drifts = printed.get("drift").map_or(0, Vec::len);
        let mut differences = Vec::new();
        let mut differs = |is_so: bool, text: String| differences.extend(is_so.then_some(text));
        let independent = report.independent_integrals();
        if let Some(known) = known.independent_integrals {
            differs(independent != known, format!("{independent} independent integrals, known {known}"));
        }
        differs(report.not_reached() > 0, format!("{} integrals not reached", report.not_reached()));
        let growth = report.growth.growth.word();
        if let Some(known) = &known.growth {
            differs(growth != known, format!("growth {growth}, known {known}"));
        }
        for (found, known, what) in
            [(report.densities.len(), known.densities, "densities"), (drifts, known.drifts, "drifts")]
        {
            differs(found < known, format!("{found} {what}, known {known}"));
        }
        let mut ranks: Vec<usize> = report.brackets.iter().map(|bracket| bracket.rank).collect();
        let missing = known.bracket_ranks.iter().filter(|rank| !ranks.contains(rank));
        for rank in missing {
            differs(true, format!("no bracket of rank {rank}"));
        }
        if let Some(most) = known.seconds {
            differs(self.total > most, format!("{:.1} s, at most {most} s wanted", self.total));
        }
        let [mut all, mut least] = [0; 2];
        for (kind, shortest) in by_kind(&self.case.shortest) {
            let found = printed.get(kind).map_or(&[][..], Vec::as_slice);
            let (count, wanted) = (found.len(), shortest.len());
            differs(count < wanted, format!("{count} of {wanted} claims `{kind}` written"));
            all += found.iter().take(wanted).sum::<usize>();
            least += shortest.iter().sum::<usize>();
            if count < wanted {
                least = 0;
                break;
            }
        }
        self.ratio = (least > 0).then(|| all as f64 / least as f64);
        ranks.dedup();
        self.counts = [
            format!("{independent:>9} {written:>7}"),
            format!("{growth:11}"),
            format!("{:>9}", report.densities.len()),
            format!("{drifts:>6}"),
            format!("{:12}", format!("{ranks:?}")),
        ];
        self.differences = differences;
    }
}

/// Collects all printed claims and the compact forms of modified Hamiltonians.
fn printed(report: &Report, found: Vec<String>) -> Vec<String> {
    let mut printed: Vec<String> = report.integrals.iter().map(|formula| formula.text.clone()).collect();
    for hamiltonian in report.compact() {
        let compact = format!("integral H~ = {};", hamiltonian.modified(&Text));
        match hamiltonian.place {
            ModifiedPlace::InsteadOf(index) => printed[index] = compact,
            _ => printed.push(compact),
        }
    }
    printed.extend(report.densities.iter().map(|formula| formula.text.clone()));
    printed.extend(report.brackets.iter().map(|bracket| bracket.text.clone()));
    printed
        .extend(found.into_iter().filter(|text| !["integral", "density", "bracket"].contains(&kind(text))));
    printed
}

fn kind(claim: &str) -> &str {
    claim.split_whitespace().next().unwrap_or_default()
}

/// Returns the lengths of the claims by kind, without names and spaces.
fn by_kind(claims: &[String]) -> BTreeMap<&str, Vec<usize>> {
    let mut lengths: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for claim in claims {
        let formula = claim.split_once(['=', '{']).map_or("", |(_, formula)| formula);
        lengths.entry(kind(claim)).or_default().push(formula.chars().filter(|c| !c.is_whitespace()).count());
    }
    lengths.values_mut().for_each(|lengths| lengths.sort_unstable());
    lengths
}

impl fmt::Display for Outcome<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ratio = match (self.ratio, self.case.shortest.is_empty()) {
            (Some(ratio), _) => format!("{ratio:.2}"),
            (None, true) => "-".to_owned(),
            (None, false) => "inf".to_owned(),
        };
        let counts = self.counts.join(" ");
        write!(
            f,
            "{:16} {counts} {:>6.1} {:>7.1} {ratio:>6}",
            self.case.name, self.last_finding, self.total
        )?;
        match (&self.differences[..], &self.case.limit) {
            ([], _) => Ok(()),
            (differences, Some(limit)) => write!(f, "  known limit ({limit}): {}", differences.join("; ")),
            (differences, None) => write!(f, "  DISAGREES: {}", differences.join("; ")),
        }
    }
}
