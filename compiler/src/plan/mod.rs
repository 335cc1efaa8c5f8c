//! The plan of a design: its automaton and its figures on placed points, checked, counted and evaluated.
//!
//! Here live the plan and its checks, budgets, evaluation in doubles, addresses and the printed form. No syntax, no
//! planarity, no boards. Vertices are shared only where `ifs` has proved that pieces meet, never by distance.

pub mod address;
pub mod budget;
mod chain;
pub mod evaluate;
pub mod extent;
mod figure;
pub mod lower;
mod net;
mod print;
mod reach;
pub mod size;
mod swept;
pub mod until;
mod uses;

pub use chain::ChainPlan;
pub use figure::{
    Depth, Dimension, Each, FigurePlan, PatchworkPlan, PiecesPlan, Plan, PlanError, Shape, SheetPlan,
};
pub use net::NetPlan;
pub use swept::{Path, Rule, SweptPlan, Turn};
pub use uses::StateUse;

#[cfg(test)]
mod tests;
