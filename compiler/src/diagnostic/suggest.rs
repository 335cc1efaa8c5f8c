//! Suggestions for misspelt names.

/// The candidate nearest to `name`, when it is near enough to be what was meant.
///
/// Near enough is at most a third of the longer name's characters, at least one, by the optimal string alignment
/// distance (insertions, deletions, substitutions and swaps of neighbours count 1). The first of equals wins.
pub fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let mut best: Option<(usize, &str)> = None;
    let own = name.chars().count();
    for candidate in candidates {
        let length = candidate.chars().count();
        let longer = own.max(length);
        let most = (longer / 3).max(1);
        let near = |distance: usize| distance <= most && best.is_none_or(|(least, _)| distance < least);
        // No fewer characters differ than one name is longer by.
        if longer > 64 || candidate == name || !near(own.abs_diff(length)) {
            continue;
        }
        let distance = distance(name, candidate);
        if near(distance) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// The sentence ``did you mean `x`?`` for the nearest candidate.
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    closest(name, candidates).map(|candidate| format!("did you mean `{candidate}`?"))
}

fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, cell) in rows[0].iter_mut().enumerate() {
        *cell = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = least;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["bezier3", "bspline3", "sheet"];
        assert_eq!(closest("bezeir3", names), Some("bezier3"));
        assert_eq!(closest("sheat", names), Some("sheet"));
        assert_eq!(closest("tensor", names), None);
    }
}
