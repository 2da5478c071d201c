//! Writes the summary of all claims on one screen.

use kahan_algebra::render::{aligned, lines, shorten, widths};

use crate::claim::{Claim, Outcome};
use crate::section::Section;
use crate::verdict::{Verdict, Verdicts};

const MOST_LINES: usize = 40;

/// The headings of the columns, in the order of [`Outcome::place`].
const OUTCOMES: [&str; Outcome::KINDS] = ["proved", "mod p", "exact", "numerical", "misprint", "failed"];

const MORE_HINT: &str = "\
kahan verify --all      every claim with its statement, its place in the paper and its time
kahan verify SYSTEM     the claims about one system, a line each
kahan atlas --out DIR   the same as a page with formulas and figures";

impl Verdicts {
    /// Writes one line for each section, then the failures, or the misprints if nothing failed. The
    /// text has at most 40 lines of about `width` characters.
    #[must_use]
    pub fn summary(&self, width: usize) -> String {
        let mut text = sections(self);
        text.push(String::new());
        let more: Vec<String> = MORE_HINT.lines().map(str::to_owned).collect();
        let room = MOST_LINES - text.len() - more.len() - 1;
        text.extend(if self.failed > 0 { failures(self, room, width) } else { misprints(self, width) });
        text.push(String::new());
        [text, more].concat().join("\n") + "\n"
    }
}

fn sections(verdicts: &Verdicts) -> Vec<String> {
    let count = |keep: &dyn Fn(&Claim) -> bool| {
        let kept = verdicts.claims.iter().filter(|row| row.claim.as_ref().is_some_and(keep));
        Outcome::counts(kept.map(|row| row.outcome))
    };
    let total = count(&|_| true);
    let shown = OUTCOMES.len() - usize::from(total[Outcome::Failed.place()] == 0);
    let row = |place: &str, subject: &str, counts: [usize; OUTCOMES.len()]| {
        let numbers = counts.iter().zip(OUTCOMES).map(|(count, heading)| {
            let count = if *count == 0 { "·".to_owned() } else { count.to_string() };
            format!("{count:>width$}", width = heading.len())
        });
        [place.to_owned(), subject.to_owned()].into_iter().chain(numbers).take(2 + shown).collect()
    };
    let headings = ["", ""].iter().chain(&OUTCOMES[..shown]).map(|heading| (*heading).to_owned());
    let of_section =
        |section: Section| row(section.place(), section.subject(), count(&|claim| claim.section == section));
    let all = row("All", &format!("{} claims", verdicts.claims.len()), total);
    aligned(&[vec![headings.collect()], Section::ALL.map(of_section).to_vec(), vec![all]].concat())
}

fn failures(verdicts: &Verdicts, room: usize, width: usize) -> Vec<String> {
    let mut text = vec!["What failed".to_owned()];
    let failed = verdicts.claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed);
    let failed: Vec<&Verdict> = failed.collect();
    for (index, row) in failed.iter().enumerate() {
        let said = [format!("{}: {}", row.source, row.statement), row.detail.clone()];
        let said = said.iter().flat_map(|line| lines(line, width - 2)).map(|line| format!("  {line}"));
        let full: Vec<String> = std::iter::once(row.id.clone()).chain(said).collect();
        // Reserve a line for the number of failures that are not described.
        if text.len() + full.len() + 1 > room {
            text.push(format!("and {} more, which --all shows", failed.len() - index));
            break;
        }
        text.extend(full);
    }
    text
}

fn misprints(verdicts: &Verdicts, width: usize) -> Vec<String> {
    let corrected = verdicts.claims.iter().filter(|row| row.outcome == Outcome::Misprint);
    let mut corrected: Vec<&Claim> = corrected.filter_map(|row| row.claim.as_ref()).collect();
    corrected.sort_by_key(|claim| claim.erratum);
    let place = |claim: &&Claim| {
        let number = claim.erratum.map_or_else(String::new, |erratum| erratum.to_string());
        vec![number, claim.section.place().to_owned()]
    };
    let mut rows: Vec<Vec<String>> = corrected.iter().map(place).collect();
    let room = width.saturating_sub(widths(&rows).iter().map(|width| width + 2).sum());
    for (claim, row) in corrected.iter().zip(&mut rows) {
        let (printed, right) = claim.correction().expect("the claim corrects a misprint");
        row.push(replaced(&printed, &right, room));
    }
    [vec!["Misprints: what is printed → what is right".to_owned()], aligned(&rows)].concat()
}

/// Writes `printed → right`, without the common words if this would exceed `room` characters.
fn replaced(printed: &str, right: &str, room: usize) -> String {
    let (printed, right): (Vec<&str>, Vec<&str>) = (printed.split(' ').collect(), right.split(' ').collect());
    let first = printed.iter().zip(&right).take_while(|(a, b)| a == b).count();
    let least = printed.len().min(right.len()) - first;
    let last = printed.iter().rev().zip(right.iter().rev()).take(least).take_while(|(a, b)| a == b).count();
    let left_side = printed[..first]
        .iter()
        .rposition(|word| [":=", "=", "~", "!="].contains(word))
        .map_or(0, |at| at + 1);
    let cut = |words: &[&str], first: usize, last: usize, before: bool| {
        let before = if before && first > 0 { "… " } else { "" };
        let after = if last > 0 { " …" } else { "" };
        format!("{before}{}{after}", words[first..words.len() - last].join(" "))
    };
    let shown = [
        (cut(&printed, 0, 0, true), cut(&right, left_side, 0, false)),
        (cut(&printed, 0, last, true), cut(&right, left_side, last, false)),
        (cut(&printed, first, last, true), cut(&right, first, last, true)),
    ];
    let shown = shown.map(|(printed, right)| format!("{printed} → {right}"));
    let fits = shown.iter().find(|shown| shown.chars().count() <= room);
    shorten(fits.unwrap_or(&shown[2]), room)
}

#[cfg(test)]
mod tests {
    use super::{MOST_LINES, replaced};
    use crate::{Claim, Outcome, Paper, Verdict, Verdicts};

    fn screen(paper: &Paper, outcome: impl Fn(&Claim) -> Outcome) -> String {
        let claims = paper.claims().iter().map(|claim| Verdict {
            id: claim.id.to_string(),
            system: claim.system.to_owned(),
            source: claim.source(),
            statement: claim.statement.clone(),
            outcome: outcome(claim),
            detail: "given".to_owned(),
            seconds: None,
            claim: Some(claim.clone()),
        });
        let screen = Verdicts::of(claims.collect(), &[], None).summary(100);
        assert!(screen.lines().count() <= MOST_LINES, "{screen}");
        assert!(screen.lines().all(|line| line.chars().count() <= 100), "{screen}");
        screen
    }

    fn good(claim: &Claim) -> Outcome {
        if claim.printed().is_some() { Outcome::Misprint } else { Outcome::Proved }
    }

    #[test]
    fn all_is_said_on_one_screen() {
        let paper = Paper::new();
        let screen = screen(&paper, good);
        for line in [
            "A3   Section 6   Z(n) := solution(n, 2) → solution(n, 4)",
            "A9   Section 6   d(L, s) != 1/(s*sqrt(R)) → d(L, s) = 1/(s*sqrt(R))",
            "Section 4   brackets from integrals        1      ·      ·          ·         ·",
        ] {
            assert!(screen.lines().any(|shown| shown == line), "{line} is not in\n{screen}");
        }
        assert!(!screen.contains("failed") && screen.contains("kahan verify --all"));
    }

    #[test]
    fn failures_are_shown_in_full_while_there_is_room() {
        let paper = Paper::new();
        let limit = |claim: &Claim| claim.id.to_string() == "table2.e1.limit";
        let one = screen(&paper, |claim| if limit(claim) { Outcome::Failed } else { good(claim) });
        let in_full = "table2.e1.limit\n  Table 2, i = 1, at eps = 0: at(H_eps, eps, 0) = H; at(K_eps, eps, 0) = K\n  given\n";
        assert!(one.contains(in_full) && !one.contains(" more,"), "{one}");
        let all = screen(&paper, |_| Outcome::Failed);
        let shown = all.lines().filter(|line| *line == "  given").count();
        assert!(all.contains(&format!("and {} more, which", paper.claims().len() - shown)), "{all}");
    }

    #[test]
    fn what_is_long_loses_what_both_have_in_common() {
        let (printed, right) = ("aaaa := bbbb + cccc + dddd", "aaaa := bbbb + 2*cccc + dddd");
        for (room, shown) in [
            (60, "aaaa := bbbb + cccc + dddd → bbbb + 2*cccc + dddd"),
            (40, "aaaa := bbbb + cccc … → bbbb + 2*cccc …"),
            (30, "… cccc … → … 2*cccc …"),
            (12, "… cccc … →…"),
        ] {
            assert_eq!(replaced(printed, right, room), shown);
        }
    }
}
