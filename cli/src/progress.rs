//! One line on the terminal that says what a long build is doing. It is drawn on stderr from the first second on, with
//! carriage returns and spaces alone, and is gone before anything else is printed. Where stderr is no terminal there is
//! none.

use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use ifs_compiler::analysis::Watch;
use ifs_compiler::outputs::Making;
use ifs_compiler::planarize;
use std::ops::ControlFlow;

/// What takes no longer than this is not spoken of.
const SILENT: Duration = Duration::from_secs(1);

/// How often the line is drawn anew.
const TICK: Duration = Duration::from_millis(100);

/// Characters of the bar.
const BAR: usize = 20;

static LINE: Mutex<Option<Line>> = Mutex::new(None);

#[derive(Debug)]
struct Line {
    begun: Instant,
    words: String,
    /// How many of how many are done.
    part: Option<(usize, usize)>,
    /// Characters that stand on the terminal.
    drawn: usize,
}

/// The line is there while this lives.
#[derive(Debug)]
pub struct Progress(());

impl Progress {
    /// Begins the line, where stderr is a terminal on which a line can be written over.
    pub fn begin() -> Option<Progress> {
        let plain = std::env::var_os("TERM").is_none_or(|term| term == "dumb");
        if !io::stderr().is_terminal() || plain {
            return None;
        }
        let words = "working the design out".to_owned();
        *line() = Some(Line { begun: Instant::now(), words, part: None, drawn: 0 });
        std::thread::spawn(|| {
            loop {
                std::thread::sleep(TICK);
                let mut line = line();
                let Some(line) = line.as_mut() else { return };
                line.draw(columns());
            }
        });
        Some(Progress(()))
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        hide();
        *line() = None;
    }
}

/// Takes the line off the terminal, so that something else can be printed.
pub fn hide() {
    if let Some(line) = line().as_mut() {
        line.hide();
    }
}

/// Says what is done now, and how many of how many are done where that can be counted.
pub fn say(words: impl FnOnce() -> String, part: Option<(usize, usize)>) {
    if let Some(line) = line().as_mut() {
        line.words = words();
        line.part = part;
    }
}

fn line() -> MutexGuard<'static, Option<Line>> {
    LINE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn columns() -> usize {
    let size = rustix::termios::tcgetwinsize(io::stderr()).map_or(0, |size| usize::from(size.ws_col));
    if size == 0 { 80 } else { size }
}

impl Line {
    fn draw(&mut self, columns: usize) {
        let elapsed = self.begun.elapsed();
        if elapsed < SILENT {
            return;
        }
        // A terminal breaks the line after the last column.
        let text: String = self.text(elapsed).chars().take(columns.saturating_sub(1)).collect();
        let length = text.chars().count();
        let spaces = " ".repeat(self.drawn.min(columns.saturating_sub(1)).saturating_sub(length));
        // If stderr is closed there is nobody to tell.
        let _ = write!(io::stderr().lock(), "\r{text}{spaces}");
        self.drawn = length;
    }

    fn text(&self, elapsed: Duration) -> String {
        let Line { words, part, .. } = self;
        let seconds = elapsed.as_secs();
        match *part {
            Some((done, of)) if of > 0 => {
                let full = (done * BAR / of).min(BAR);
                let bar = format!("{}{}", "#".repeat(full), ".".repeat(BAR - full));
                format!("[{bar}] {words}, {done} of {of}, {seconds} s")
            }
            _ => format!("{words}, {seconds} s"),
        }
    }

    fn hide(&mut self) {
        if self.drawn > 0 {
            let _ = write!(io::stderr().lock(), "\r{}\r", " ".repeat(self.drawn));
            self.drawn = 0;
        }
    }
}

/// Tells the line how far an analysis is.
#[derive(Debug)]
pub struct Watching;

impl Watch for Watching {
    fn planarizing(&mut self, figure: &str, progress: &planarize::Progress) -> ControlFlow<()> {
        let worst = progress.worst.map_or(String::new(), |worst| format!(", worst planarity {worst:.6}"));
        let (step, most) = (progress.iteration, progress.iterations);
        say(|| format!("planarizing {figure}, step {step} of at most {most}{worst}"), None);
        ControlFlow::Continue(())
    }

    fn planarized(&mut self, figure: &str) {
        say(|| format!("making boards of {figure}"), None);
    }
}

/// Tells the line how far the outputs are.
pub fn making(making: Making) {
    match making {
        Making::Programs { done, of } => {
            say(|| "programs made and read back".to_owned(), Some((done, of)));
        }
        Making::Sheets { done, of } => {
            say(|| "sheets made and read back".to_owned(), Some((done, of)));
        }
        Making::Nests => say(|| "nesting".to_owned(), None),
        Making::Lists => say(|| "making lists and drawings".to_owned(), None),
        Making::Reports => say(|| "making the report".to_owned(), None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_fills_with_what_is_done() {
        let line = |part| Line { begun: Instant::now(), words: "programs".to_owned(), part, drawn: 0 };
        let text = |part| line(part).text(Duration::from_millis(2900));
        assert_eq!(text(None), "programs, 2 s");
        assert_eq!(text(Some((0, 0))), "programs, 2 s");
        assert_eq!(text(Some((0, 40))), "[....................] programs, 0 of 40, 2 s");
        assert_eq!(text(Some((13, 40))), "[######..............] programs, 13 of 40, 2 s");
        assert_eq!(text(Some((40, 40))), "[####################] programs, 40 of 40, 2 s");
    }
}
