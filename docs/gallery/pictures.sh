#!/usr/bin/env bash
# Builds every example and draws the pictures of docs/gallery.md, each with the camera and the nodes listed here.
# PYTHON names an interpreter with numpy and Pillow, PROGRAM the ifs program (else it is built), PICTURES those to be drawn (else all).
set -euo pipefail
cd "$(dirname "$0")/../.."
python=${PYTHON:-python3}
program=${PROGRAM:-}
if [ -z "$program" ]; then
    cargo build --release -p ifs-cli
    program=target/release/ifs
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# draw EXAMPLE PICTURE AZIMUTH ELEVATION [NAMES] [NAME=COLOUR]...
draw() {
    local example=$1 picture=$2
    shift 2
    if [ -n "${PICTURES:-}" ] && [[ " $PICTURES " != *" $picture "* ]]; then return; fi
    [ -d "$out/$example" ] || "$program" build "examples/$example.ifs" -o "$out/$example" --emit glb > "$out/table.txt"
    "$python" docs/gallery/draw.py "$out/$example/model.glb" "docs/gallery/$picture.png" "$@"
    echo "$picture"
}

# Only the boards of what is fabricated.
boards='/(designed|planarized)=none'

draw surfaces surfaces 14 26 'surface=#d9d4c8'
draw fern fern 0 90 'plant=#2f5d34'
draw de_casteljau de_casteljau 0 90 'hulls=#f0dcb4' 'steps=#8c3b1e'
draw vault vault 48 24
draw boathouse boathouse 35 18
draw steps steps 20 42
draw saddle saddle 20 32 'saddle.*=none' 'along=#c9a06a' 'other=#e6cfa6'
draw shell shell 35 30 planarized
draw shell shell_designed 35 30 designed
draw model model 35 30 "$boards"
draw canopy canopy 30 22 "$boards"
draw folded_shell folded_shell 40 24 "$boards"
draw rough_shell rough_shell 30 20 "$boards"
draw rough_vault rough_vault 30 28 planarized
draw rough_vault rough_vault_designed 30 28 designed
draw dome dome 20 25 "$boards"
draw lattice lattice 50 22
draw column column 25 -12 'tree=#c9a06a'
draw ring ring 25 30
draw wall wall 15 35 "$boards"
