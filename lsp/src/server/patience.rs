//! How long designs that nobody has open are worked out, so that the editor is not kept waiting for them.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use ifs_compiler::analysis::Watch;
use ifs_compiler::planarize::Progress;

/// For how long one design after another is begun, once they are asked for.
const BEGIN: Duration = Duration::from_secs(1);

/// For how long one design is worked out.
const EACH: Duration = Duration::from_secs(2);

#[allow(clippy::disallowed_methods, reason = "patience is measured by the clock")]
fn now() -> Instant {
    Instant::now()
}

/// The time from which it is counted.
#[derive(Clone, Copy)]
pub(super) struct Patience(Instant);

impl Patience {
    pub(super) fn from_now() -> Patience {
        Patience(now())
    }

    /// Whether another design may be begun.
    pub(super) fn is_left(self) -> bool {
        now() - self.0 < BEGIN
    }
}

/// Stops the work on a design that takes too long.
pub(super) struct Limited {
    start: Instant,
    pub(super) stopped: bool,
}

impl Limited {
    pub(super) fn from_now() -> Limited {
        Limited { start: now(), stopped: false }
    }
}

impl Watch for Limited {
    fn planarizing(&mut self, _: &str, _: &Progress) -> ControlFlow<()> {
        self.step()
    }

    fn planarized(&mut self, _: &str) {}

    fn step(&mut self) -> ControlFlow<()> {
        self.stopped |= now() - self.start > EACH;
        if self.stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
