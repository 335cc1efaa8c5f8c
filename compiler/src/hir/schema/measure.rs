//! What `require` can ask for: the words, the dimension of the limit, and the blocks that may ask.
//!
//! How each is measured is in `fabricate::checks`.

use super::SchemaKind;
use crate::hir::dimension::Dimension;
use core::f64::consts::{FRAC_PI_2, PI};

/// A measure that `require` can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// The cosine of a quad's fold; 1 is flat.
    Planarity,
    /// The angle between the two triangles of a quad.
    Fold,
    /// The distance of a quad's diagonals by their mean length.
    DiagonalRatio,
    /// The length of a quad's edges.
    Edge,
    /// The length of a plank on its axis, or of a board along its grain.
    Length,
    /// The least width of a board.
    Width,
    /// The area of a board.
    Area,
    /// The angle at each corner of a board.
    Angle,
    /// The mitre at a plank's end.
    Mitre,
    /// The bevel of a board's edge.
    Bevel,
    /// The radius to which a board is bent.
    BendRadius,
    /// The distance of the joints of neighbouring curves.
    Overlap,
    /// The mass of a board or plank.
    Mass,
    /// How many boards or planks a figure has.
    Count,
}

impl Measure {
    /// All of them, in the order of the reference.
    pub const ALL: [Measure; 14] = [
        Measure::Planarity,
        Measure::Fold,
        Measure::DiagonalRatio,
        Measure::Edge,
        Measure::Length,
        Measure::Width,
        Measure::Area,
        Measure::Angle,
        Measure::Mitre,
        Measure::Bevel,
        Measure::BendRadius,
        Measure::Overlap,
        Measure::Mass,
        Measure::Count,
    ];

    /// The measure of these words.
    pub fn named(words: &str) -> Option<Measure> {
        Measure::ALL.into_iter().find(|measure| measure.words() == words)
    }

    /// The words.
    pub const fn words(self) -> &'static str {
        match self {
            Measure::Planarity => "planarity",
            Measure::Fold => "fold",
            Measure::DiagonalRatio => "diagonal ratio",
            Measure::Edge => "edge",
            Measure::Length => "length",
            Measure::Width => "width",
            Measure::Area => "area",
            Measure::Angle => "angle",
            Measure::Mitre => "mitre",
            Measure::Bevel => "bevel",
            Measure::BendRadius => "bend radius",
            Measure::Overlap => "overlap",
            Measure::Mass => "mass",
            Measure::Count => "count",
        }
    }

    /// The dimension of its limit.
    pub fn dimension(self) -> Dimension {
        match self {
            Measure::Planarity | Measure::DiagonalRatio | Measure::Count => Dimension::NUMBER,
            Measure::Fold | Measure::Angle | Measure::Mitre | Measure::Bevel => Dimension::ANGLE,
            Measure::Edge | Measure::Length | Measure::Width | Measure::Overlap | Measure::BendRadius => {
                Dimension::LENGTH
            }
            Measure::Area => Dimension::AREA,
            Measure::Mass => Dimension::MASS,
        }
    }

    /// A limit as one would write it, for messages.
    pub const fn example(self) -> &'static str {
        match self {
            Measure::Planarity => ">= 0.9998",
            Measure::Fold => "<= 1deg",
            Measure::DiagonalRatio => "<= 0.5%",
            Measure::Edge | Measure::Length => "in 300mm .. 1200mm",
            Measure::Width => ">= 80mm",
            Measure::Area => "<= 0.5m2",
            Measure::Angle => "in 60deg .. 120deg",
            Measure::Mitre => "<= 45deg",
            Measure::Bevel => "<= 30deg",
            Measure::BendRadius => ">= material.min_bend_radius",
            Measure::Overlap => ">= 80mm",
            Measure::Mass => "<= 25kg",
            Measure::Count => "<= 300",
        }
    }

    /// What is measured.
    pub const fn doc(self) -> &'static str {
        match self {
            Measure::Planarity => {
                "the cosine of the angle between the two triangles of a quad, split along the diagonal that folds less; 1 is flat"
            }
            Measure::Fold => {
                "the angle between the two triangles of a quad, split along the diagonal that folds less"
            }
            Measure::DiagonalRatio => {
                "the distance at which the diagonals pass each other by their mean length"
            }
            Measure::Edge => "the length of each side of a board",
            Measure::Length => {
                "of a plank, on its axis; of a board, along its grain, or along its longest side where the grain is free"
            }
            Measure::Width => "the least width of the unrolled board, between two parallel lines",
            Measure::Area => "the area of the unrolled board",
            Measure::Angle => "the angle at each corner of the unrolled board",
            Measure::Bevel => "how far each edge that meets another board is from a square cut",
            Measure::BendRadius => "the radius to which the designed surface bends the board",
            Measure::Mitre => "the angle of an end of a plank from a square cut",
            Measure::Overlap => "how far the interior joints of neighbouring curves of the figure are apart",
            Measure::Mass => "what each board or plank weighs; the material must have a density",
            Measure::Count => "how many boards or planks the figure has",
        }
    }

    /// The least and the largest value that any element can have: mm, mm², kg, rad, or a plain number.
    pub fn possible(self) -> (f64, f64) {
        match self {
            Measure::Planarity => (-1.0, 1.0),
            Measure::Fold | Measure::Mitre | Measure::Bevel => (0.0, FRAC_PI_2),
            Measure::Angle => (0.0, PI),
            Measure::DiagonalRatio
            | Measure::Edge
            | Measure::Length
            | Measure::Width
            | Measure::Area
            | Measure::BendRadius
            | Measure::Overlap
            | Measure::Mass
            | Measure::Count => (0.0, f64::INFINITY),
        }
    }

    /// Whether it says how flat a quad is, and so what planarizing changes most.
    pub const fn is_flatness(self) -> bool {
        matches!(self, Measure::Planarity | Measure::Fold | Measure::DiagonalRatio | Measure::BendRadius)
    }

    /// Which blocks may ask for it.
    pub fn applies_to(self, block: SchemaKind) -> bool {
        match self {
            Measure::Planarity
            | Measure::Fold
            | Measure::DiagonalRatio
            | Measure::Edge
            | Measure::Width
            | Measure::Area
            | Measure::Angle
            | Measure::Bevel
            | Measure::BendRadius => block == SchemaKind::Panels,
            Measure::Mitre | Measure::Overlap => block == SchemaKind::Planks,
            Measure::Length | Measure::Mass | Measure::Count => {
                matches!(block, SchemaKind::Panels | SchemaKind::Planks)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::MEASURES;

    #[test]
    fn the_parser_knows_the_same_words_in_the_same_order() {
        assert_eq!(MEASURES, Measure::ALL.map(Measure::words));
        for measure in Measure::ALL {
            assert_eq!(Measure::named(measure.words()), Some(measure));
            let (least, most) = measure.possible();
            assert!(least < most);
            assert!([SchemaKind::Panels, SchemaKind::Planks].iter().any(|block| measure.applies_to(*block)));
        }
        assert_eq!(Measure::named("weight"), None);
    }
}
