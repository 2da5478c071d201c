//! Writes the measured parts of `docs/reference/speed.md`. Results replace the text between the
//! markers `<!-- begin: NAME -->` and `<!-- end: NAME -->`.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::output::write_whole;
use crate::race::Effort;
use crate::report;
use crate::systems;
use crate::table::{Table, short};

const PICTURE: &str = "docs/reference/work_precision.svg";

const SCENE: [&str; 8] = ["trade", "e6", "--at", "1,1/2,1/3", "--horizon", "100", "--tolerance", "1e-10"];

const TRIALS: &str = "1000000";

/// The rows of the table of tiers, in order: the name in the timings, the call, and its guarantee.
const PROMISES: [(&str, &str, &str); 6] = [
    ("fast", "`step`, `orbit`", "a few u in short steps away from poles; nothing is looked at"),
    ("compensated", "`orbit(..).compensated()`", "the same, and the rounding of a step falls to O(ε)·u"),
    ("stable", "`try_step`", "within 64 u of the exact step, established for this very call, or an error"),
    (
        "accurate",
        "any of them with `Dd`",
        "half an ulp of `f64` from ordinary points, down to 1e-9 from a pole",
    ),
    ("f32 through f64", "`ThroughF64(map)`", "`f32`, rounded once"),
    ("f32", "`f32`", "the fast tier with u = 2⁻²⁴"),
];

/// The systems in the table of speed, each with its name in the code and its name in the table.
const NAMES: [(&str, &str); 8] = [
    ("LotkaVolterra", "Lotka–Volterra"),
    ("EulerTop", "Euler top"),
    ("E1", "E1"),
    ("E3", "E3"),
    ("E5", "E5"),
    ("E6", "E6"),
    ("Lorenz", "Lorenz"),
    ("Clebsch", "Clebsch, six variables"),
];

pub(crate) fn write(root: &Path, effort: Effort) -> Result<()> {
    let picture = root.join(PICTURE);
    let told = kahan(root, SCENE.iter().copied().chain(["--out", &picture.display().to_string()]))?;
    let trade = format!("```text\n$ kahan {}\n{}```\n", SCENE.join(" "), choice(&told));
    let tiers = tiers(effort)?.to_string();
    let speed = speed(effort)?.to_string();
    let judged = kahan(root, ["extremes", "--json", "--trials", TRIALS].into_iter())?;
    let judged: Value = serde_json::from_str(&judged).context("`kahan extremes --json` is no JSON")?;
    let extremes = extremes(&judged)?.to_string();
    let parts = [("trade", &trade), ("tiers", &tiers), ("speed", &speed), ("extremes", &extremes)];
    rewrite(&root.join("docs/reference/speed.md"), &parts)
}

fn rewrite(path: &Path, parts: &[(&str, &String)]) -> Result<()> {
    let page = path.display().to_string();
    let mut text = std::fs::read_to_string(path).with_context(|| format!("{page} cannot be read"))?;
    for (name, by) in parts {
        text = replaced(&text, name, by).with_context(|| format!("{page} stays as it is"))?;
    }
    write_whole(path, &text)
}

fn kahan<'a>(root: &Path, arguments: impl Iterator<Item = &'a str>) -> Result<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["run", "--release", "--quiet", "--manifest-path"])
        .arg(root.join("Cargo.toml"))
        .arg("--")
        .args(arguments)
        .output()
        .context("cargo does not run")?;
    if !output.status.success() {
        bail!("the command `kahan` failed: {}", String::from_utf8_lossy(&output.stderr));
    }
    String::from_utf8(output.stdout).context("the command `kahan` does not print text")
}

fn choice(told: &str) -> String {
    let lines = told.lines().skip_while(|line| !line.starts_with("choice")).take(2);
    lines.map(|line| format!("{line}\n")).collect()
}

fn replaced(text: &str, name: &str, by: &str) -> Result<String> {
    let (begin, end) = (format!("<!-- begin: {name} -->\n"), format!("<!-- end: {name} -->"));
    let from = text.find(&begin).with_context(|| format!("there is no {}", begin.trim()))? + begin.len();
    let to = text[from..].find(&end).with_context(|| format!("there is no {end}"))? + from;
    Ok(format!("{}\n{by}\n{}", &text[..from].trim_end_matches('\n').to_owned(), &text[to..]))
}

fn speed(effort: Effort) -> Result<Table> {
    let steps = report::step_times(&systems::all(), effort);
    let ensembles = report::ensemble_times(effort)?;
    let mut table = Table::new(&[
        "",
        "generated",
        "by hand",
        "nalgebra `SMatrix` LU",
        "implicit midpoint",
        "ensemble, a trajectory",
    ]);
    for (system, name) in NAMES {
        let times = steps.iter().find(|times| times.system == system);
        let times = times.with_context(|| format!("the steps of {system} were not timed"))?;
        let ensemble = ensembles.iter().find(|(of, _)| of == system).map(|(_, time)| *time);
        let mut row = vec![name.to_owned()];
        row.extend([times.generated, times.by_hand, times.lu, times.midpoint].map(|time| short(Some(time))));
        row.push(short(ensemble));
        table.push(row);
    }
    Ok(table)
}

fn tiers(effort: Effort) -> Result<Table> {
    let prices = report::tier_prices(effort)?;
    let mut table = Table::new(&["tier", "how", "promise", "price"]);
    for (name, how, promise) in PROMISES {
        let ratios: Vec<f64> =
            prices.iter().filter(|(what, _)| what == name).map(|(_, ratio)| *ratio).collect();
        let (least, most) = ratios.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &x| (a.min(x), b.max(x)));
        ensure!(most > 0.0, "the tier {name} was not timed");
        let price = if name == "fast" { "1".to_owned() } else { format!("{least:.2}–{most:.2}") };
        table.push(vec![name.to_owned(), how.to_owned(), promise.to_owned(), price]);
    }
    Ok(table)
}

fn extremes(judged: &Value) -> Result<Table> {
    let cells = judged["cells"].as_array().context("no cells in `kahan extremes --json`")?;
    let mut regimes: Vec<&str> = cells.iter().filter_map(|cell| cell["regime"].as_str()).collect();
    regimes.dedup();
    let mut table = Table::new(&[
        "",
        "fast `f32`",
        "fast `f64`",
        "fast `Dd`",
        "stable, all three",
        "largest error",
        "flagged",
    ]);
    for regime in regimes {
        let of = |tier: &str, scalar: &str| {
            cells
                .iter()
                .find(|cell| cell["regime"] == regime && cell["tier"] == tier && cell["scalar"] == scalar)
        };
        let number = |cell: &Value, key: &str| cell[key].as_f64().unwrap_or(0.0);
        let share = |tier: &str, scalar: &str| {
            of(tier, scalar).map_or("–".to_owned(), |cell| match number(cell, "silently_wrong") {
                0.0 => "0".to_owned(),
                wrong => format!("{:.2} %", 100.0 * wrong / number(cell, "trials")),
            })
        };
        let stable: Vec<&Value> =
            ["f32", "f64", "dd"].iter().filter_map(|scalar| of("stable", scalar)).collect();
        let sum = |key: &str| stable.iter().map(|cell| number(cell, key)).sum::<f64>();
        let largest = stable.iter().map(|cell| number(cell, "max_error_u")).fold(0.0, f64::max);
        let trials = sum("trials");
        table.push(vec![
            regime.to_owned(),
            share("fast", "f32"),
            share("fast", "f64"),
            share("accurate", "dd"),
            match sum("silently_wrong") {
                0.0 => format!("0 of {trials}"),
                wrong => format!("**{wrong}** of {trials}"),
            },
            if largest > 0.0 { format!("{largest:.1} u") } else { "–".to_owned() },
            format!("{:.2} %", 100.0 * sum("flagged") / trials),
        ]);
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::replaced;

    #[test]
    fn only_what_stands_between_the_markers_changes() {
        let text = "before\n<!-- begin: a -->\nold\n<!-- end: a -->\nafter\n";
        let new = replaced(text, "a", "new\n").expect("both markers are there");
        assert_eq!(new, "before\n<!-- begin: a -->\nnew\n\n<!-- end: a -->\nafter\n");
        assert_eq!(replaced(&new, "a", "new\n").expect("still there"), new);
        assert!(replaced(text, "b", "").is_err());
    }
}
