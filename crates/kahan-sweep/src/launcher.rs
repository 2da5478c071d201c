//! Determines the shard to compute from the environment of a known launcher.

use std::env::VarError;

use crate::run::Shard;

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct RecognisedLauncher {
    pub(crate) shard: Shard,
    pub(crate) sentence: String,
    /// The number of processes of this sweep on this machine; 1 if unknown.
    pub(crate) beside: usize,
}

/// The environment variable for the number of shards, for launchers that do not provide it.
const SHARDS_VARIABLE: &str = "KAHAN_SHARDS";
/// The environment variable for the index of this shard, counted from 0, for unknown launchers.
const SHARD_INDEX_VARIABLE: &str = "KAHAN_SHARD_INDEX";

/// Launchers of task arrays, with the variables for task, first task, last task and stride.
const ARRAY_LAUNCHERS: [(&str, [&str; 4]); 5] = [
    (
        "Slurm",
        ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP"],
    ),
    ("Grid Engine", ["SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE"]),
    ("LSF", ["LSB_JOBINDEX", "", "LSB_JOBINDEX_END", "LSB_JOBINDEX_STEP"]),
    ("PBS", ["PBS_ARRAY_INDEX", "", "", ""]),
    ("Kubernetes", ["JOB_COMPLETION_INDEX", "", "", ""]),
];

/// Launchers that number processes from 0, with the variables for number and count.
const RANK_LAUNCHERS: [(&str, &str, &str); 3] = [
    ("Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
    ("MPI", "PMI_RANK", "PMI_SIZE"),
    ("MPI", "MV2_COMM_WORLD_RANK", "MV2_COMM_WORLD_SIZE"),
];

/// A job launcher that started `of` tasks. This process is the task with the number `index`.
#[derive(Clone, Debug)]
struct LaunchLevel {
    launcher: &'static str,
    variable: &'static str,
    index: u64,
    of: u64,
}

/// Reads the environment; `None` if no launcher is recognised. If the tasks of an array start MPI
/// processes, each of these processes computes one shard.
pub(crate) fn detect(
    get: &dyn Fn(&str) -> Result<String, VarError>,
) -> Result<Option<RecognisedLauncher>, String> {
    let number = |name: &str| get(name).ok()?.trim().parse::<u64>().ok();
    let places: Vec<LaunchLevel> = match number(SHARD_INDEX_VARIABLE) {
        Some(own) => {
            vec![LaunchLevel::new("a launcher", SHARD_INDEX_VARIABLE, Some(own), number(SHARDS_VARIABLE))?]
        }
        None => {
            let task = ARRAY_LAUNCHERS.iter().find_map(|array| task(array, &number));
            let rank = rank(get("SLURM_STEP_ID").is_ok(), &number);
            task.into_iter().chain(rank).collect::<Result<_, _>>()?
        }
    };
    if places.is_empty() {
        return Ok(None);
    }
    // The index of the innermost launcher varies fastest.
    let shard = places.iter().fold(Shard::WHOLE, |Shard { index, of }, place| Shard {
        index: index * place.of + place.index,
        of: of * place.of,
    });
    let words = |LaunchLevel { launcher, variable, index, of }: &LaunchLevel| {
        format!("{launcher} started this as task {} of {of} ({variable})", index + 1)
    };
    let words = places.iter().map(words).collect::<Vec<_>>().join(", and within it ");
    let sentence = format!("{words}: it computes shard {} of {}", shard.index + 1, shard.of);
    let beside = number("OMPI_COMM_WORLD_LOCAL_SIZE").or_else(|| number("MPI_LOCALNRANKS")).unwrap_or(1);
    Ok(Some(RecognisedLauncher { shard, sentence, beside: beside.max(1) as usize }))
}

fn task(
    (launcher, [task, first, last, step]): &(&'static str, [&'static str; 4]),
    number: &dyn Fn(&str) -> Option<u64>,
) -> Option<Result<LaunchLevel, String>> {
    // Outside of task arrays, Grid Engine sets its task variable to `undefined`, and LSF to 0.
    let id = number(task).filter(|id| *launcher != "LSF" || *id > 0)?;
    // Kubernetes counts tasks from 0; PBS and LSF count them from 1.
    let usual = if *launcher == "Kubernetes" { 0 } else { 1 };
    let (first, step) = (number(first).unwrap_or(usual), number(step).unwrap_or(1).max(1));
    let count = number(last).filter(|last| *last >= first).map(|last| (last - first) / step + 1);
    let index = id.checked_sub(first).map(|place| place / step);
    Some(LaunchLevel::new(launcher, task, index, number(SHARDS_VARIABLE).or(count)))
}

fn rank(is_step_of_slurm: bool, number: &dyn Fn(&str) -> Option<u64>) -> Option<Result<LaunchLevel, String>> {
    for (launcher, rank, size) in RANK_LAUNCHERS {
        if let Some(index) = number(rank) {
            return Some(LaunchLevel::new(launcher, rank, Some(index), number(size)));
        }
    }
    // Slurm is tried last, because MPI may start its processes through Slurm tasks.
    let size = number("SLURM_NTASKS").filter(|size| is_step_of_slurm && *size > 1)?;
    Some(LaunchLevel::new("Slurm", "SLURM_PROCID", Some(number("SLURM_PROCID")?), Some(size)))
}

impl LaunchLevel {
    fn new(
        launcher: &'static str,
        variable: &'static str,
        index: Option<u64>,
        of: Option<u64>,
    ) -> Result<Self, String> {
        let of = of.ok_or_else(|| {
            format!("{launcher} says by {variable} which task this is, and not how many there are; set {SHARDS_VARIABLE} to their number, or give --shard i/n")
        })?;
        let index = index.filter(|index| *index < of).ok_or_else(|| {
            format!("{launcher} says by {variable} that this is a task beyond the {of} that there are; give --shard i/n")
        })?;
        Ok(LaunchLevel { launcher, variable, index, of })
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
        detect(&get).transpose().map(|found| found.map(|launched| (launched.shard.index, launched.shard.of)))
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
        // A Slurm batch script is a single process. It has the last two of these variables.
        assert_eq!(found(&srun[1..]), None);
        assert_eq!(found(&[("KAHAN_SHARD_INDEX", "5"), ("KAHAN_SHARDS", "6"), slurm[0]]), Some(Ok((5, 6))));
        let grid_engine = [("SGE_TASK_ID", "undefined"), ("SGE_TASK_FIRST", "undefined")];
        assert_eq!(found(&grid_engine), None);
    }

    /// Tests that each shard is computed once if each task of a job array starts several processes.
    #[test]
    fn ranks_within_tasks_are_shards_of_their_own() {
        let mut shards = Vec::new();
        for task in ["2", "4", "6"] {
            for rank in ["0", "1"] {
                // The processes inherit the environment variables of the process that started them.
                let started = [("SLURM_STEP_ID", "0"), ("SLURM_PROCID", "0"), ("SLURM_NTASKS", "2")];
                let array = [
                    ("SLURM_ARRAY_TASK_ID", task),
                    ("SLURM_ARRAY_TASK_MIN", "2"),
                    ("SLURM_ARRAY_TASK_MAX", "6"),
                    ("SLURM_ARRAY_TASK_STEP", "2"),
                ];
                let ranks = [("OMPI_COMM_WORLD_RANK", rank), ("OMPI_COMM_WORLD_SIZE", "2")];
                shards.push(found(&[&started[..], &array, &ranks].concat()));
            }
        }
        assert_eq!(shards, (0..6).map(|index| Some(Ok((index, 6)))).collect::<Vec<_>>());
        let pod =
            [("JOB_COMPLETION_INDEX", "2"), ("KAHAN_SHARDS", "3"), ("PMI_RANK", "1"), ("PMI_SIZE", "4")];
        assert_eq!(found(&pod), Some(Ok((9, 12))));
    }

    #[test]
    fn what_a_launcher_does_not_say_is_asked_for() {
        let said = found(&[("JOB_COMPLETION_INDEX", "5")]).unwrap().unwrap_err();
        assert!(said.contains("KAHAN_SHARDS") && said.contains("--shard"), "{said}");
        assert!(found(&[("PMI_RANK", "2"), ("PMI_SIZE", "2")]).unwrap().is_err());
    }
}
