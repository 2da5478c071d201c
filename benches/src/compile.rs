//! Measures the times that the macro and the compiler need for a block.
//!
//! Each block is built in a temporary library with one call of its step. Builds of different blocks
//! alternate, and the least time of each block counts.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};
use kahan_bench_fields::{SOURCES, block_of};
use tempfile::TempDir;

use crate::progress::Progress;

/// Files of the catalog, whose blocks have claims.
const CATALOG: [(&str, &str); 6] = [
    ("LotkaVolterra", include_str!("../../systems/src/catalog/lotka_volterra.rs")),
    ("EulerTop", include_str!("../../systems/src/catalog/euler.rs")),
    ("E1", include_str!("../../systems/src/catalog/e1.rs")),
    ("E3", include_str!("../../systems/src/catalog/e3.rs")),
    ("E5", include_str!("../../systems/src/catalog/e5.rs")),
    ("E6", include_str!("../../systems/src/catalog/e6.rs")),
];

/// The figures of an earlier commit for comparison. The first lines name that commit.
pub(crate) const BEFORE: &str = include_str!("../before.tsv");

/// The time for one block, in milliseconds of processor time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cost {
    /// The name of the system, and whether the block has claims.
    pub(crate) block: String,
    pub(crate) expansion: f64,
    /// The compiler time of the block in an unoptimised build, minus that of an empty crate.
    pub(crate) debug: f64,
    /// The compiler time of the block in an optimised build, minus that of an empty crate.
    pub(crate) release: f64,
}

struct Probe {
    block: String,
    source: String,
}

/// Measures every block with the `kahan-core` of a checkout. An empty crate is built in each round,
/// too, for comparison.
pub(crate) fn measure(checkout: &Path, quick: bool) -> Result<Vec<Cost>> {
    let core = fs::canonicalize(checkout.join("kahan-core"))
        .with_context(|| format!("{} has no folder kahan-core; is it a checkout?", checkout.display()))?;
    let folder = Folder::new(&core)?;
    let empty = Probe {
        block: String::new(),
        source: "//! Nothing.\n\npub use kahan_core::prelude::*;\n".to_owned(),
    };
    let probes: Vec<Probe> = std::iter::once(empty).chain(probes()?).collect();
    let rounds = if quick { 2 } else { 9 };
    let progress = Progress::new(rounds * probes.len());
    progress.begin("compiling: dependencies");
    for release in PROFILES {
        folder.build(&probes[0].source, release)?;
    }
    let mut least = vec![[Build { build: f64::INFINITY, expansion: f64::INFINITY }; 2]; probes.len()];
    for _ in 0..rounds {
        for (probe, least) in probes.iter().zip(&mut least) {
            progress.begin(format!("compiling: {}", probe.block));
            for (release, least) in PROFILES.into_iter().zip(least) {
                let Build { build, expansion } = folder.build(&probe.source, release)?;
                least.build = least.build.min(build);
                least.expansion = least.expansion.min(expansion);
            }
            progress.advance();
        }
    }
    let [base_debug, base_release] = least[0];
    let costs = probes.into_iter().zip(least).skip(1).map(|(probe, [debug, release])| Cost {
        block: probe.block,
        expansion: debug.expansion.min(release.expansion),
        debug: debug.build - base_debug.build,
        release: release.build - base_release.build,
    });
    Ok(costs.collect())
}

const PROFILES: [bool; 2] = [false, true];

fn probes() -> Result<Vec<Probe>> {
    let mut probes = Vec::new();
    for source in SOURCES {
        let step = |text: &str| {
            format!(
                "//! One block.\n\n{text}\n/// Keeps the step.\npub fn step(x: [f64; {n}], eps: f64) -> [f64; {n}] {{\n    \
                 {value}.step(&SVector::from(x), eps).into()\n}}\n",
                n = source.dimension,
                value = source.value,
            )
        };
        probes.push(Probe { block: source.name.to_owned(), source: step(source.text) });
        if let Some((_, file)) = CATALOG.iter().find(|(name, _)| *name == source.name) {
            let block = block_of(file).context("a file of the catalog without a block")?;
            let text = format!("use kahan_core::prelude::*;\n\nkahan! {{{block}\n}}\n");
            probes.push(Probe {
                block: format!("{}, with the catalog's claims", source.name),
                source: step(&text),
            });
        }
    }
    Ok(probes)
}

#[derive(Clone, Copy)]
struct Build {
    build: f64,
    expansion: f64,
}

struct Folder(TempDir);

impl Folder {
    fn new(core: &Path) -> Result<Self> {
        let folder = tempfile::tempdir().context("there is no place for temporary files")?;
        fs::create_dir(folder.path().join("src")).context("the temporary folder cannot be filled")?;
        let manifest = format!(
            "[package]\nname = \"probe\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
             [dependencies]\nkahan-core = {{ path = {core:?} }}\n"
        );
        fs::write(folder.path().join("Cargo.toml"), manifest)
            .context("the temporary folder cannot be filled")?;
        let lock = core.with_file_name("Cargo.lock");
        if lock.is_file() {
            fs::copy(lock, folder.path().join("Cargo.lock"))
                .context("the temporary folder cannot be filled")?;
        }
        Ok(Self(folder))
    }

    fn build(&self, source: &str, release: bool) -> Result<Build> {
        fs::write(self.0.path().join("src/lib.rs"), source)
            .context("the temporary folder cannot be filled")?;
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.arg("build").current_dir(self.0.path());
        command.env("CARGO_TARGET_DIR", self.0.path().join("target"));
        command.env("CARGO_INCREMENTAL", "0").env("KAHAN_TIMING", "1").env_remove("RUSTFLAGS");
        if release {
            command.arg("--release");
        }
        let before = processor_time();
        let output = command.output().context("cargo does not run")?;
        let build = (processor_time() - before) * 1e3;
        let messages = String::from_utf8_lossy(&output.stderr);
        if !output.status.success() {
            bail!("a crate with this source does not build:\n{source}\n{messages}");
        }
        let expansion = messages.lines().find_map(expansion_time).unwrap_or(f64::INFINITY);
        Ok(Build { build, expansion })
    }
}

/// Returns the processor time in seconds of child processes that have ended.
#[cfg(unix)]
fn processor_time() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;

    // The call cannot fail for valid arguments.
    getrusage(UsageWho::RUSAGE_CHILDREN).map_or(f64::NAN, |usage| {
        let microseconds = usage.user_time().num_microseconds() + usage.system_time().num_microseconds();
        microseconds as f64 * 1e-6
    })
}

/// Returns wall-clock time, because this system reports no processor time of child processes.
#[cfg(not(unix))]
fn processor_time() -> f64 {
    use std::sync::LazyLock;
    use std::time::Instant;

    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGUN.elapsed().as_secs_f64()
}

/// Reads the milliseconds from `kahan!: NAME expanded in 1.23 ms`.
fn expansion_time(line: &str) -> Option<f64> {
    let (_, rest) = line.split_once(" expanded in ")?;
    rest.strip_suffix(" ms")?.parse().ok()
}

pub(crate) fn to_text(costs: &[Cost]) -> String {
    let lines = costs.iter().map(|cost| {
        format!("{}\t{:.2}\t{:.1}\t{:.1}\n", cost.block, cost.expansion, cost.debug, cost.release)
    });
    lines.collect()
}

pub(crate) fn from_text(text: &str) -> Result<Vec<Cost>> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let cost = |line: &str| {
        let mut fields = line.split('\t');
        let block = fields.next()?.to_owned();
        let mut number = || fields.next()?.parse().ok();
        Some(Cost { block, expansion: number()?, debug: number()?, release: number()? })
    };
    lines.map(|line| cost(line).with_context(|| format!("not a line of figures: {line:?}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_survive_being_written() {
        let cost = Cost { block: "E3, with claims".to_owned(), expansion: 4.25, debug: 60.5, release: 71.0 };
        assert_eq!(from_text(&to_text(std::slice::from_ref(&cost))).unwrap(), [cost]);
        assert!(from_text("E3\t1\t2\n").is_err());
    }

    #[test]
    fn blocks_end_where_they_do() {
        assert_eq!(block_of("//! A\nkahan! {\n    a {\n    }\n}\n\nfn b() {\n}\n"), Some("\n    a {\n    }"));
        assert!(from_text(BEFORE).is_ok_and(|costs| costs.len() == probes().unwrap().len()));
    }

    #[test]
    fn the_macros_line_is_read() {
        assert_eq!(expansion_time("kahan!: E3 expanded in 4.21 ms"), Some(4.21));
        assert_eq!(expansion_time("   Compiling probe"), None);
    }
}
