//! From the shape of a figure's value to that of the plan: states for its ifs, levels for its curves.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::placed::{self, Arm, SweptPath, SweptRule};
use crate::hir::value::{self, Level};
use crate::plan::chain::ChainPlan;
use crate::plan::figure::{Dimension, Shape, SheetPlan};
use crate::plan::net::NetPlan;
use crate::plan::swept::{Path, Rule, SweptPlan, Turn};
use crate::source::Span;

impl Lowering<'_, '_> {
    /// The shape of a figure, every level moved by `shift`, with the place its level is said at; `None` after a report.
    pub(super) fn shape(&mut self, name: &str, figure: &value::Figure, shift: i32) -> Option<(Shape, Span)> {
        if let value::Shape::Swept(swept) = &figure.shape {
            return self.swept(name, swept, figure.level, shift);
        }
        let Some(level) = figure.level else {
            self.level_missing(format!("the figure `{name}` has no level"), figure.span);
            return None;
        };
        let (u, v) = (shifted(level.u, shift), shifted(level.v.unwrap_or(level.u), shift));
        let shape = match &figure.shape {
            value::Shape::Curve { ifs, points, dimension } => Shape::Curve {
                state: self.state(ifs)?,
                points: points.clone(),
                level: u,
                dimension: dimension_of(*dimension),
            },
            value::Shape::Sheet { u: first, v: second, net, rows, columns, windows } => {
                Shape::Sheet(SheetPlan {
                    u: self.state(first)?,
                    v: self.state(second)?,
                    net_rows: *rows,
                    net_columns: *columns,
                    net: net.clone(),
                    levels: (u, v),
                    windows: *windows,
                })
            }
            value::Shape::Chain(chain) => Shape::Chain(self.chain(chain, u)?),
            value::Shape::Net(net) => Shape::Net(NetPlan {
                sheet: SheetPlan {
                    u: self.state(&net.u)?,
                    v: self.state(&net.v)?,
                    net_rows: net.grid.rows,
                    net_columns: net.grid.columns,
                    net: net.grid.points.clone(),
                    levels: (u, v),
                    windows: net.windows,
                },
                closed: net.closed,
                weights: net.grid.weights.clone(),
            }),
            value::Shape::Swept(_) => return None,
        };
        Some((shape, level.span))
    }

    fn chain(&mut self, chain: &placed::Chain, level: u32) -> Option<ChainPlan> {
        Some(ChainPlan {
            state: self.state(&chain.ifs)?,
            points: chain.points.clone(),
            weights: chain.weights.clone(),
            level,
            dimension: dimension_of(chain.dimension),
            windows: chain.windows,
            closed: chain.closed,
        })
    }

    fn swept(
        &mut self,
        name: &str,
        swept: &placed::Swept,
        level: Option<Level>,
        shift: i32,
    ) -> Option<(Shape, Span)> {
        let along_profile = level.map(|level| Level { u: level.v.unwrap_or(level.u), ..level });
        let (path, at) = match &swept.path {
            SweptPath::Rail(rail, rule) => {
                let (rail, at) = self.arm(name, rail, level, shift)?;
                let rule = match rule {
                    SweptRule::Sum => Rule::Sum,
                    SweptRule::Scaled(scale) => Rule::Scaled(scale.clone()),
                    SweptRule::Projective => Rule::Projective,
                };
                (Path::Rail(rail, rule), Some(at))
            }
            SweptPath::Turn { point, direction, angle, full, segments } => {
                let (point, direction) = (*point, *direction);
                let turn = Turn { point, direction, angle: *angle, segments: *segments, full: *full };
                (Path::Turn(turn), None)
            }
            SweptPath::Straight { vector, pieces } => {
                (Path::Straight { vector: *vector, pieces: *pieces }, None)
            }
        };
        let (profile, profile_at) = self.arm(name, &swept.profile, along_profile, shift)?;
        Some((Shape::Swept(SweptPlan { profile, path }), at.unwrap_or(profile_at)))
    }

    /// A curve of a surface at the surface's level, else at its own, with the place where that is said.
    fn arm(&mut self, name: &str, arm: &Arm, level: Option<Level>, shift: i32) -> Option<(ChainPlan, Span)> {
        let Some(level) = level.or(arm.level) else {
            self.level_missing(format!("the {} of `{name}` has no level", arm.role), arm.span);
            return None;
        };
        if level.until.is_some() && arm.level == Some(level) {
            let message = format!(
                "the level of the {} of `{name}` is found by size, before there is a surface",
                arm.role
            );
            let diagnostic = Diagnostic::new(Code::E0801, level.span, message).label("which level is it?");
            self.diagnostics.push(diagnostic.hint("give it a number, or put `until` on the surface"));
            return None;
        }
        Some((self.chain(&arm.chain, shifted(level.u, shift))?, level.span))
    }

    fn level_missing(&mut self, message: String, at: Span) {
        let diagnostic = Diagnostic::new(Code::E0801, at, message).label("how deep does it go?");
        self.diagnostics.push(diagnostic.fix("add a level: `… at level 3`", at.after(), " at level 3"));
    }
}

fn shifted(level: u32, shift: i32) -> u32 {
    level.saturating_add_signed(shift)
}

fn dimension_of(coordinates: u8) -> Dimension {
    if coordinates == 2 { Dimension::Plane } else { Dimension::Space }
}
