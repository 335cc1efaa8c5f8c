//! What the races share: the program as it is released, whole processes, and medians of repeated runs. What is raced is
//! not said here.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The top folder of the tree.
///
/// # Panics
/// The crate does not lie in the tree.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate lies in the tree")
}

/// Builds the `ifs` program as it is released, and says where it lies.
///
/// # Panics
/// It cannot be built.
pub fn build_release() -> PathBuf {
    let status = Command::new(env!("CARGO"))
        .args(["build", "--release", "--quiet", "-p", "ifs-cli"])
        .current_dir(root())
        .status();
    assert!(status.expect("cargo can be started").success(), "the program cannot be built");
    root().join("target/release/ifs")
}

/// Runs a program to its end; what it prints is thrown away.
///
/// # Panics
/// It cannot be started, or ends badly.
pub fn run(command: &mut Command) {
    let silent = command.stdout(Stdio::null()).stderr(Stdio::null());
    let status = silent.status().expect("the program can be started");
    assert!(status.success(), "{command:?}");
}

/// How long something takes.
pub fn time(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}

/// What the processor did for this process meanwhile: what others do on the machine counts little for it.
pub fn cpu_time(work: impl FnOnce()) -> Duration {
    let now = || {
        let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        Duration::try_from(now).unwrap_or_default()
    };
    let start = now();
    work();
    now().saturating_sub(start)
}

/// The middle one of some times; of none, nothing.
pub fn middle(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times.get(times.len() / 2).copied().unwrap_or_default()
}

/// The middle time of so many runs.
pub fn median(runs: usize, mut work: impl FnMut()) -> Duration {
    middle((0..runs).map(|_| time(&mut work)).collect())
}

/// As milliseconds.
pub fn millis(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
