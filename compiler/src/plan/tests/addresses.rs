//! Words, addresses and aliases.

use std::collections::BTreeSet;

use super::*;
use crate::plan::address::{ChainWords, FigureAddresses};

#[test]
fn words_follow_the_chain() {
    let cubic = bezier(3, &r(1, 2));
    let words = ChainWords::new(&cubic, FIRST, 2);
    assert_eq!(words.elements(), 4);
    assert_eq!(words.names(1), Some(vec!["left", "right"]));
    assert_eq!(words.names(2), Some(vec!["right", "left"]));
    assert_eq!(words.names(4), None);
    assert_eq!(ChainWords::new(&cubic, FIRST, 0).names(0), Some(vec![]));
    // The other state's letters are walked by its own counts.
    let both = alternating();
    let words = ChainWords::new(&both, FIRST, 3);
    let all: BTreeSet<Vec<&str>> = (0..8).map(|element| words.names(element).unwrap()).collect();
    assert_eq!(all.len(), 8);
}

#[test]
fn curves_have_addresses() {
    let vault =
        plan(bezier(3, &r(1, 2)), vec![figure("vault", Some(2), arc(4)), figure("curve", None, arc(7))]);
    let addresses = FigureAddresses::new(vault.automaton(), &vault.figures()[0]);
    let fifth = addresses.segment(5).unwrap();
    assert_eq!(fifth.to_string(), "vault.2.left.right.left.right");
    assert_eq!(fifth.alias, "vault-2-05");
    assert_eq!((addresses.segment(16), addresses.quad(0, 0)), (None, None));
    let addresses = FigureAddresses::new(vault.automaton(), &vault.figures()[1]);
    assert_eq!(addresses.segment(5).unwrap().alias, "curve-005");
}

#[test]
fn families_keep_their_number() {
    let mut state = bezier(3, &r(1, 2)).states()[0].clone();
    state.transforms[0].name = "branch.0".to_owned();
    let column = plan(automaton(state), vec![figure("column", None, arc(2))]);
    let addresses = FigureAddresses::new(column.automaton(), &column.figures()[0]);
    assert_eq!(addresses.segment(1).unwrap().to_string(), "column.branch.0.right");
}

#[test]
fn sheets_have_windows_pairs_and_aliases() {
    let shell = plan(bspline3_limit(), vec![figure("shell", None, Shape::Sheet(sheet(7, 7, (2, 2), true)))]);
    let addresses = FigureAddresses::new(shell.automaton(), &shell.figures()[0]);
    let quad = addresses.quad(7, 12).unwrap();
    assert_eq!(quad.to_string(), "shell.1-3.right-left.right-left");
    assert_eq!(quad.alias, "shell-07-12");
    assert_eq!((addresses.quad(16, 0), addresses.quad(0, 16), addresses.segment(0)), (None, None, None));
    let all: BTreeSet<String> =
        (0..256).map(|i| addresses.quad(i / 16, i % 16).unwrap().to_string()).collect();
    assert_eq!(all.len(), 256);
}

#[test]
fn a_side_without_levels_stays_empty() {
    let patch = Shape::Sheet(sheet(4, 4, (2, 1), false));
    let turned = Shape::Sheet(sheet(4, 4, (0, 7), false));
    let patch =
        plan(bezier(3, &r(1, 2)), vec![figure("patch", Some(1), patch), figure("turned", None, turned)]);
    let addresses = FigureAddresses::new(patch.automaton(), &patch.figures()[0]);
    let quad = addresses.quad(2, 1).unwrap();
    assert_eq!(
        (quad.to_string().as_str(), quad.alias.as_str()),
        ("patch.1.right-right.left-", "patch-1-02-01")
    );
    let addresses = FigureAddresses::new(patch.automaton(), &patch.figures()[1]);
    let quad = addresses.quad(0, 127).unwrap();
    let word = vec!["-right".to_owned(); 7];
    assert_eq!((quad.word, quad.alias.as_str()), (word, "turned-000-127"));
}
