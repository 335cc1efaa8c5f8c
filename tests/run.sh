#!/usr/bin/env bash
# All tests: installs the foreign referees they need, builds everything, runs every test.
set -euo pipefail
cd "$(dirname "$0")/.."
tests/setup.sh
cargo test --workspace
