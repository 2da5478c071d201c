//! On what something was measured.

use std::fs;
use std::process::Command;
use std::thread::available_parallelism;

/// One line a fact.
pub(crate) fn description() -> String {
    let cores = available_parallelism().map_or_else(|_| "unknown".to_owned(), |cores| cores.to_string());
    let flags = std::env::var("RUSTFLAGS").ok().filter(|flags| !flags.is_empty());
    let fused = if cfg!(target_feature = "fma") { "with" } else { "without" };
    format!(
        "- Processor: {}, {cores} cores to use\n\
         - Compiler: {}, profile `release`, `RUSTFLAGS`: {}\n\
         - Target: {}-{}, {fused} fused multiply-adds outside ensembles\n",
        processor(),
        compiler(),
        flags.as_deref().map_or("none".to_owned(), |flags| format!("`{flags}`")),
        std::env::consts::ARCH,
        std::env::consts::OS,
    )
}

/// The model as the system names it, with the vector instructions that matter here.
fn processor() -> String {
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

fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "rustc, version unknown".to_owned())
}
