//! The plan of a design: its automaton and its figures on placed points, checked, counted and evaluated.
//!
//! Here live the plan and its checks, budgets, evaluation in doubles, addresses and the printed form. No syntax, no
//! planarity, no boards. Vertices are shared only where `ifs` has proved that pieces meet, never by distance.

pub mod address;
pub mod budget;
pub mod evaluate;
pub mod extent;
mod figure;
pub mod lower;
mod print;
pub mod size;
pub mod until;

pub use figure::{
    Depth, Dimension, Each, FigurePlan, PatchworkPlan, PiecesPlan, Plan, PlanError, Shape, SheetPlan,
};

#[cfg(test)]
mod tests;
