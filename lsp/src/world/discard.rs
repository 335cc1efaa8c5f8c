//! Where designs go that were worked out and that nobody needs any more: taking thousands of boards apart is done on a thread
//! of its own, not between a keystroke and its answer.

use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::thread;

use ifs_compiler::analysis::Analysis;

/// Takes analyses apart beside everything else.
pub(super) struct Discard {
    sender: Sender<Arc<Analysis>>,
}

impl Discard {
    /// Starts the thread, whose stack has so many bytes: trees are taken apart as deep as they are.
    ///
    /// # Errors
    /// The system has no thread left.
    pub(super) fn start(stack: usize) -> std::io::Result<Discard> {
        let (sender, receiver) = channel();
        thread::Builder::new()
            .stack_size(stack)
            .spawn(move || receiver.iter().for_each(drop::<Arc<Analysis>>))?;
        Ok(Discard { sender })
    }

    /// Lets go of an analysis; who still has it keeps it.
    pub(super) fn put(&self, analysis: Arc<Analysis>) {
        // Where the thread is gone it comes back, and ends here.
        let _ = self.sender.send(analysis);
    }
}
