//! Reads the answer of the command `kahan trade`.

use std::process::Command;

use anyhow::{Context, Result, ensure};
use kahan_core::Composition;
use kahan_dynamics::{Need, Precision, Scheme};
use serde_json::Value;

use super::price::pace;
use super::scene::Setting;

pub(crate) struct TradeAnswer {
    pub(crate) choice: Setting,
    /// The price of one setting of each `Scheme`, in nanoseconds per unit of simulated time. The
    /// setting is the one with the smallest ε in the command's answer.
    pub(crate) prices: Vec<(Setting, f64)>,
    /// The seconds of a fixed loop, which measure the machine's speed before and after the command.
    pub(crate) pace: f64,
}

pub(crate) fn choice(field: &str, start: &[&str], horizon: f64, tolerance: f64) -> Result<TradeAnswer> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let before = pace();
    let output = Command::new(cargo)
        .args(["run", "--release", "--quiet", "--manifest-path"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml"))
        .args(["--", "trade", "--json", "--field", field, "--at", &start.join(",")])
        .args(["--horizon", &horizon.to_string(), "--tolerance", &tolerance.to_string()])
        .output()
        .context("cargo does not run")?;
    let pace = pace().min(before);
    ensure!(output.status.success(), "{field}: {}", String::from_utf8_lossy(&output.stderr));
    let object: Value = serde_json::from_slice(&output.stdout).context("`kahan trade --json` is no JSON")?;
    let mut prices: Vec<(Setting, f64)> = Vec::new();
    for known in object["settings"].as_array().context("no settings")? {
        let (setting, price) = (setting(known)?, price(known)?);
        match prices.iter_mut().find(|(other, _)| other.scheme == setting.scheme) {
            Some(other) if other.0.eps <= setting.eps => {}
            Some(other) => *other = (setting, price),
            None => prices.push((setting, price)),
        }
    }
    Ok(TradeAnswer { choice: setting(&object["choice"])?, prices, pace })
}

fn price(object: &Value) -> Result<f64> {
    object["nanoseconds_per_unit_time"].as_f64().context("no price")
}

fn setting(object: &Value) -> Result<Setting> {
    let precision = Precision::ALL.into_iter().find(|known| object["scalar"] == known.name());
    let precision = precision.context("no scalar")?;
    let order = object["order"].as_u64().context("no order")?;
    let composition = Composition::of_order(u32::try_from(order)?).context("no such order")?;
    let compensated = object["compensated"] == true;
    // Take the nearest number of the scalar type, because reading JSON may change the last bit.
    let eps = precision.eps_near(object["eps"].as_f64().context("no eps")?, Need::Trajectory);
    Ok(Setting { scheme: Scheme { precision, composition, compensated }, eps })
}
