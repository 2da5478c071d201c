//! Describes the machine, compiler and commit of a measurement.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread::available_parallelism;

/// Returns the name of the processor, its vector instructions, and the number of cores.
pub(crate) fn processor() -> String {
    let cores = available_parallelism().map_or_else(|_| "unknown".to_owned(), |cores| cores.to_string());
    format!("{}, {cores} cores to use", model())
}

pub(crate) fn compiler() -> String {
    let flags = std::env::var("RUSTFLAGS").ok().filter(|flags| !flags.is_empty());
    let flags = flags.map_or_else(String::new, |flags| format!(", RUSTFLAGS {flags}"));
    told(Command::new("rustc").arg("--version")) + &flags
}

pub(crate) fn commit(root: &Path) -> String {
    told(Command::new("git").args(["rev-parse", "--short", "HEAD"]).current_dir(root))
}

fn told(command: &mut Command) -> String {
    let text = command.output().map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "unknown".to_owned())
}

fn model() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name))?;
        line.split_once(':').map(|(_, value)| value.trim().to_owned())
    };
    let Some(name) = field("model name") else { return "unknown".to_owned() };
    let (family, model) = (field("cpu family").unwrap_or_default(), field("model\t").unwrap_or_default());
    let flags = field("flags").unwrap_or_default();
    let has = |flag: &&str| flags.split(' ').any(|have| have == *flag);
    let vectors: Vec<&str> = ["avx2", "fma", "avx512f"].into_iter().filter(has).collect();
    format!("{name} (family {family}, model {model}; {})", vectors.join(", "))
}
