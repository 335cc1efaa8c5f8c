//! The printed plan, word for word.

use super::*;

#[test]
fn a_plan_prints_all_that_is_known() {
    let shell = Shape::Sheet(sheet(7, 7, (2, 1), true));
    let both = plan(bspline3_limit(), vec![figure("rib", Some(0), arc(3)), figure("shell", None, shell)]);
    let expected = "\
state 0 bspline3 on 4 points
  left -> state 0, factor 1/2
    [1/2  1/2    0    0]
    [1/8  3/4  1/8    0]
    [  0  1/2  1/2    0]
    [  0  1/8  3/4  1/8]
  right -> state 0, factor 1/2
    [1/8  3/4  1/8    0]
    [  0  1/2  1/2    0]
    [  0  1/8  3/4  1/8]
    [  0    0  1/2  1/2]
  germ segment from [1/6 2/3 1/6 0] to [0 1/6 2/3 1/6]
  elements at levels 0 to 3: 1, 2, 4, 8
  contraction proved: words of length 1 are at most 0.5 in the ∞-norm
  joins proved: the pieces meet at every level

figure rib[0]: curve of state 0 in the plane at level 3: 8 elements, 9 vertices
figure shell: sheet of states 0 and 0 at level (2, 1) on a net of 7 by 7: 128 elements, 153 vertices
";
    assert_eq!(both.to_string(), expected);
}

#[test]
fn verdicts_are_printed_as_they_are() {
    let five = plan(
        four_point_on_five(),
        vec![figure(
            "five",
            None,
            Shape::Curve { state: FIRST, points: vec![[0.0; 3]; 5], level: 1, dimension: Dimension::Space },
        )],
    );
    let text = five.to_string();
    assert!(text.contains("contraction refuted: right has a spectral radius of at least 1"), "{text}");
}
