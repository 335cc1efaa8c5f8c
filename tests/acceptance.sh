#!/usr/bin/env bash
# The long run, beside tests/run.sh: every fuzz target for some minutes each (10 unless given), from the texts of the tree.
# Then a whole build of 10,000 boards: every file is read again, and 300 of its programs go before rs274 and shapely.
# Then 10,000 random boards in each dialect of NC programs go there too.
# At last the editors: VS Code, Emacs and Helix themselves open a design (tests/editors.sh).
# What a target finds lies in fuzz/artifacts/; the smallest form of it belongs into tests/corpus/.
#   tests/acceptance.sh [MINUTES]
set -euo pipefail
cd "$(dirname "$0")/.."
minutes=${1:-10}

cargo fuzz --version >/dev/null 2>&1 || cargo install --locked cargo-fuzz --version '^0.13'

texts=(tests/suite/*/ tests/corpus/ examples/ stdlib/)
fuzz() {
    local target=$1
    shift
    mkdir -p "fuzz/corpus/$target" "fuzz/artifacts/$target"
    # Without a sanitizer: stable Rust has none, and the compiler forbids unsafe code.
    cargo fuzz run -s none "$target" "fuzz/corpus/$target" "$@" -- -dict=fuzz/words.dict -max_len=4000 \
        -max_total_time=$((minutes * 60)) -timeout=20 -rss_limit_mb=2048
}

fuzz parse "${texts[@]}"
fuzz analyse "${texts[@]}"
fuzz design
WHOLE_BUILD_SIDE=100 cargo test --release -p ifs-tests --test all -- whole_build
NC_BOARDS=10000 cargo test --release -p ifs-tests --test all -- nc::random_boards
tests/editors.sh
echo "acceptance: nothing found in $minutes minutes a target"
