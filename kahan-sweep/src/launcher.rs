//! Which shard this process is, as the launcher's environment says it.

use std::env::VarError;

use crate::run::Shard;

/// What was recognised.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Launched {
    pub(crate) shard: Shard,
    /// In words, for the user.
    pub(crate) sentence: String,
    /// Processes of the sweep on this machine, where the launcher says it.
    pub(crate) beside: usize,
}

/// How many shards there are, where a launcher does not say it.
pub(crate) const SHARDS: &str = "KAHAN_SHARDS";

/// Launchers that number their tasks from 0, or from a first one, and say how many there are:
/// name, task, how many.
const RANKS: [(&str, &str, &str); 5] = [
    ("Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
    ("MPI", "PMI_RANK", "PMI_SIZE"),
    ("MPI", "MV2_COMM_WORLD_RANK", "MV2_COMM_WORLD_SIZE"),
    ("Kubernetes", "JOB_COMPLETION_INDEX", SHARDS),
    ("a launcher", "KAHAN_SHARD_INDEX", SHARDS),
];

/// Launchers of arrays: name, task, first, last, distance.
const ARRAYS: [(&str, [&str; 4]); 4] = [
    (
        "Slurm",
        ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP"],
    ),
    ("Grid Engine", ["SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE"]),
    ("LSF", ["LSB_JOBINDEX", "", "LSB_JOBINDEX_END", "LSB_JOBINDEX_STEP"]),
    ("PBS", ["PBS_ARRAY_INDEX", "", "", ""]),
];

/// Looks at an environment; `None` where no launcher is recognised, a sentence where one says too
/// little.
pub(crate) fn detect(get: &dyn Fn(&str) -> Result<String, VarError>) -> Option<Result<Launched, String>> {
    let number = |name: &str| get(name).ok()?.trim().parse::<u64>().ok();
    for (launcher, [task, first, last, step]) in ARRAYS {
        // Grid Engine says `undefined` outside of arrays, and LSF 0.
        let Some(id) = number(task).filter(|id| launcher != "LSF" || *id > 0) else { continue };
        let (first, step) = (number(first).unwrap_or(1), number(step).unwrap_or(1).max(1));
        let count = number(last).filter(|last| *last >= first).map(|last| (last - first) / step + 1);
        return Some(launched(
            launcher,
            task,
            id.checked_sub(first).map(|place| place / step),
            number(SHARDS).or(count),
            1,
        ));
    }
    if get("SLURM_STEP_ID").is_ok()
        && let (Some(rank), Some(size)) = (number("SLURM_PROCID"), number("SLURM_NTASKS"))
        && size > 1
    {
        return Some(launched("Slurm", "SLURM_PROCID", Some(rank), Some(size), 1));
    }
    for (launcher, task, size) in RANKS {
        let Some(rank) = number(task) else { continue };
        let beside = number("OMPI_COMM_WORLD_LOCAL_SIZE").or_else(|| number("MPI_LOCALNRANKS")).unwrap_or(1);
        return Some(launched(launcher, task, Some(rank), number(size), beside.max(1) as usize));
    }
    None
}

fn launched(
    launcher: &str,
    variable: &str,
    index: Option<u64>,
    of: Option<u64>,
    beside: usize,
) -> Result<Launched, String> {
    let Some(of) = of else {
        return Err(format!(
            "{launcher} says by {variable} which task this is, and not how many there are; set {SHARDS} to their number, or give --shard i/n"
        ));
    };
    match index.filter(|index| *index < of) {
        Some(index) => {
            let sentence = format!(
                "{launcher} started this as task {} of {of} ({variable}): it computes that shard",
                index + 1
            );
            Ok(Launched { shard: Shard { index, of }, sentence, beside })
        }
        None => Err(format!(
            "{launcher} says by {variable} that this is a task beyond the {of} that there are; give --shard i/n"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(variables: &[(&str, &str)]) -> Option<Result<(u64, u64), String>> {
        let get = |name: &str| {
            let value = variables.iter().find(|(known, _)| *known == name);
            value.map(|(_, value)| (*value).to_owned()).ok_or(VarError::NotPresent)
        };
        detect(&get).map(|found| found.map(|launched| (launched.shard.index, launched.shard.of)))
    }

    #[test]
    fn launchers_are_recognised() {
        assert_eq!(found(&[("HOME", "/root")]), None);
        let slurm = [
            ("SLURM_ARRAY_TASK_ID", "7"),
            ("SLURM_ARRAY_TASK_MIN", "1"),
            ("SLURM_ARRAY_TASK_MAX", "9"),
            ("SLURM_ARRAY_TASK_STEP", "2"),
        ];
        assert_eq!(found(&slurm), Some(Ok((3, 5))));
        assert_eq!(found(&[("OMPI_COMM_WORLD_RANK", "3"), ("OMPI_COMM_WORLD_SIZE", "4")]), Some(Ok((3, 4))));
        assert_eq!(found(&[("PMI_RANK", "0"), ("PMI_SIZE", "2")]), Some(Ok((0, 2))));
        assert_eq!(found(&[("JOB_COMPLETION_INDEX", "5"), ("KAHAN_SHARDS", "6")]), Some(Ok((5, 6))));
        assert_eq!(found(&[("PBS_ARRAY_INDEX", "2"), ("KAHAN_SHARDS", "6")]), Some(Ok((1, 6))));
        let srun = [("SLURM_STEP_ID", "0"), ("SLURM_PROCID", "1"), ("SLURM_NTASKS", "3")];
        assert_eq!(found(&srun), Some(Ok((1, 3))));
        // A batch script has these, too, and is one process.
        assert_eq!(found(&srun[1..]), None);
        let grid_engine = [("SGE_TASK_ID", "undefined"), ("SGE_TASK_FIRST", "undefined")];
        assert_eq!(found(&grid_engine), None);
    }

    #[test]
    fn what_a_launcher_does_not_say_is_asked_for() {
        let said = found(&[("JOB_COMPLETION_INDEX", "5")]).unwrap().unwrap_err();
        assert!(said.contains("KAHAN_SHARDS") && said.contains("--shard"), "{said}");
        assert!(found(&[("PMI_RANK", "2"), ("PMI_SIZE", "2")]).unwrap().is_err());
    }
}
