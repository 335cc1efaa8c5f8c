//! [`NetPlan`]: a product of two curve states on a net that is closed round, or whose points have weights.
//!
//! A plain open net is [`super::Shape::Sheet`], which has the fast path of evaluation to itself.

use super::figure::SheetPlan;

/// A sheet or tensor product with closed directions or weights.
#[derive(Clone, Debug, PartialEq)]
pub struct NetPlan {
    /// The product and its net.
    pub sheet: SheetPlan,
    /// Whether the net goes round along its first and along its second index.
    pub closed: (bool, bool),
    /// One weight above 0 for each point of the net, where it is rational.
    pub weights: Option<Vec<f64>>,
}
