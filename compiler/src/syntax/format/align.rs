//! From lines to the text: spaces that put columns and comments below each other.

use super::write::Line;

/// How far the code before a column may differ in width for the lines to have it in common.
const SPREAD: usize = 16;
/// The same for comments.
const COMMENT_SPREAD: usize = 24;
/// What stands between the code and a comment behind it.
const BEFORE_COMMENT: usize = 2;

/// Joins lines to a text; each ends with LF. None if it would have more bytes than `most`.
pub(super) fn text(mut lines: Vec<Line<'_>>, most: usize) -> Option<String> {
    for run in runs(&lines, |before, line| before.kind == line.kind && line.kind.is_some()) {
        let lines = &mut lines[run];
        let columns = lines.iter().flat_map(|line| &line.columns).map(|(_, column)| *column + 1).max();
        for column in 0..columns.unwrap_or(0) {
            align_column(lines, column);
        }
    }
    let mut gaps = vec![BEFORE_COMMENT; lines.len()];
    for run in runs(&lines, |_, _| true) {
        let commented = run.filter(|at| lines[*at].comment.is_some());
        let widths: Vec<(usize, usize)> = commented.map(|at| (at, width(&lines[at].text))).collect();
        for (at, pad) in pads(&widths, COMMENT_SPREAD) {
            gaps[at] += pad;
        }
    }
    let mut text = String::new();
    for (line, gap) in lines.iter().zip(gaps) {
        write(&mut text, line, gap);
        if text.len() > most {
            return None;
        }
    }
    Some(text)
}

/// The ranges of lines which follow each other at one indent without blank lines, and which belong together.
fn runs(lines: &[Line<'_>], together: impl Fn(&Line<'_>, &Line<'_>) -> bool) -> Vec<std::ops::Range<usize>> {
    let mut runs = Vec::new();
    let mut start = 0;
    for at in 1..=lines.len() {
        let goes_on = lines.get(at).is_some_and(|line| {
            let before = &lines[at - 1];
            !line.blank && line.indent == before.indent && together(before, line)
        });
        if !goes_on {
            runs.push(start..at);
            start = at;
        }
    }
    runs
}

/// Puts one column of some lines below each other; lines without it are left out.
fn align_column(lines: &mut [Line<'_>], column: usize) {
    let place = |line: &Line<'_>| line.columns.iter().find(|(_, found)| *found == column).map(|(at, _)| *at);
    let with = |(at, line): (usize, &Line<'_>)| Some((at, width(&line.text[..place(line)?])));
    let widths: Vec<(usize, usize)> = lines.iter().enumerate().filter_map(with).collect();
    for (at, pad) in pads(&widths, SPREAD) {
        let line = &mut lines[at];
        let Some(place) = place(line) else { continue };
        line.text.insert_str(place, &" ".repeat(pad));
        line.columns.iter_mut().filter(|(at, _)| *at >= place).for_each(|(at, _)| *at += pad);
    }
}

/// How many spaces bring each of these widths to the largest of its neighbours, as long as they differ by `spread` at
/// most.
fn pads(widths: &[(usize, usize)], spread: usize) -> Vec<(usize, usize)> {
    let mut pads = Vec::with_capacity(widths.len());
    let mut rest = widths;
    while let Some(((_, first), _)) = rest.split_first() {
        let (mut least, mut most) = (*first, *first);
        let near = rest.iter().take_while(|(_, width)| {
            (least, most) = (least.min(*width), most.max(*width));
            most - least <= spread
        });
        let count = near.count();
        let (near, after) = rest.split_at(count);
        let most = near.iter().map(|(_, width)| *width).max().unwrap_or(0);
        pads.extend(near.iter().map(|(at, width)| (*at, most - width)));
        rest = after;
    }
    pads
}

/// How many columns a text takes.
fn width(text: &str) -> usize {
    text.chars().count()
}

fn write(text: &mut String, line: &Line<'_>, gap: usize) {
    if line.blank {
        text.push('\n');
    }
    text.push_str(&" ".repeat(line.indent));
    text.push_str(&line.text);
    if let Some(comment) = line.comment {
        text.push_str(&" ".repeat(gap));
        text.push_str(comment);
    }
    text.push('\n');
}
