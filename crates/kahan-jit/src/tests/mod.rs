//! Random programs, and an interpreter as the reference for the allocation and the code.

mod allocation;
mod code;
mod draw;
#[cfg(unix)]
mod hostile;
mod refused;
mod run;

/// Returns whether this test binary can run itself as a child process. An emulator prevents this.
#[cfg(target_os = "linux")]
pub(crate) fn starts_itself() -> bool {
    let program = std::env::current_exe().expect("this program has a name");
    let listed = std::process::Command::new(program).arg("--list").output();
    let starts = listed.is_ok_and(|listed| listed.status.success());
    if !starts {
        println!("not run: this program cannot start itself");
    }
    starts
}

pub(crate) use draw::{Draw, random_program};
pub(crate) use run::{run, same, subtract_product};
