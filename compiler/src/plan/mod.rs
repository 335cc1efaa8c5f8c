//! The plan of a design: its automaton and its figures on placed points, checked, counted and evaluated.
//!
//! Here live the plan and its checks, budgets, evaluation in doubles, addresses and the printed form. No syntax, no
//! planarity, no boards. Vertices are shared only where `ifs` has proved that pieces meet, never by distance.

pub mod address;
pub mod budget;
pub mod evaluate;
mod figure;
pub mod lower;
mod print;

pub use figure::{Dimension, FigurePlan, PatchworkPlan, Plan, PlanError, Shape, SheetPlan};

#[cfg(test)]
mod tests;
