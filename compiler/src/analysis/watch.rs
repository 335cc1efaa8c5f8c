//! Watching an analysis that takes long: the one question it asks on its way.

use crate::planarize::Progress;
use std::ops::ControlFlow;

/// Is told how far planarizing is, and may stop it. It must not change what an analysis means.
pub trait Watch {
    /// Said before each step that planarizes the named figure. After a `Break` the block of that figure is left out of
    /// the analysis, without a diagnostic: whoever said so knows.
    fn planarizing(&mut self, figure: &str, progress: &Progress) -> ControlFlow<()>;

    /// Said when the named figure is done.
    fn planarized(&mut self, figure: &str);

    /// Said before each block and between its stages, and before each variant of the design in which remedies are looked
    /// for. After a `Break` the rest is left out of the analysis without a diagnostic, as above.
    fn step(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// Tells another of steps only: how a variant of the design is planarized is nobody's news.
pub(super) struct Quietly<'a>(pub(super) &'a mut dyn Watch);

impl Watch for Quietly<'_> {
    fn planarizing(&mut self, _: &str, _: &Progress) -> ControlFlow<()> {
        self.0.step()
    }

    fn planarized(&mut self, _: &str) {}

    fn step(&mut self) -> ControlFlow<()> {
        self.0.step()
    }
}

/// Looks away.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn planarizing(&mut self, _: &str, _: &Progress) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn planarized(&mut self, _: &str) {}
}
