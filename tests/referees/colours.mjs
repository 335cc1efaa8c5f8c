// Colours every .ifs file it is given with the TextMate grammar, as the editor does, and prints one JSON object: the words
// of the language (first argument, commas between) that were left without a colour, by file and line, and counts.
import fs from "node:fs";
import { createRequire } from "node:module";
const require = createRequire(import.meta.url);
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");

const here = new URL(".", import.meta.url);
await oniguruma.loadWASM(fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () =>
    textmate.parseRawGrammar(fs.readFileSync(new URL("../../editors/vscode/syntaxes/ifs.tmLanguage.json", here), "utf8"), "ifs.json"),
});
const grammar = await registry.loadGrammar("source.ifs");
const [list, ...files] = process.argv.slice(2);
const words = new RegExp(`(?<![A-Za-z0-9_])(?:${list.split(",").join("|")})(?![A-Za-z0-9_])`, "g");
const counts = { files: files.length, words: 0, uncoloured: [] };
for (const file of files) {
  let state = textmate.INITIAL;
  fs.readFileSync(file, "utf8").split("\n").forEach((line, at) => {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    state = ruleStack;
    for (const found of line.matchAll(words)) {
      const scopes = tokens.find((token) => token.startIndex <= found.index && found.index < token.endIndex).scopes;
      const coloured = scopes.some((scope) => /^(keyword|storage|variable\.language|constant|comment|string)/.test(scope));
      counts.words += 1;
      if (!coloured) counts.uncoloured.push(`${file}:${at + 1}: ${found[0]} is ${scopes.at(-1)}`);
    }
  });
}
console.log(JSON.stringify(counts));
process.exit(counts.uncoloured.length > 0 ? 1 : 0);
