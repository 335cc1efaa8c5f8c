//! The programs of `LANGUAGE.md`, the limits, and what holds for every text.

mod language;
