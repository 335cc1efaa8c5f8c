// Khronos' glTF validator as a referee: `node glb.mjs FILE…`. Prints one line of JSON per file with its counts; an
// error or a warning is printed in full and makes the exit code 1.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import validator from 'gltf-validator';

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node glb.mjs FILE…');
  process.exit(2);
}

let bad = 0;
for (const file of files) {
  const bytes = new Uint8Array(readFileSync(file));
  const report = await validator.validateBytes(bytes, { uri: basename(file), format: 'glb', maxIssues: 100 });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  const { drawCallCount, totalVertexCount, totalTriangleCount } = report.info ?? {};
  const counts = { errors: numErrors, warnings: numWarnings, infos: numInfos, hints: numHints };
  console.log(JSON.stringify({ file, ...counts, drawCallCount, totalVertexCount, totalTriangleCount }));
  for (const { code, message, severity, pointer } of messages) {
    if (severity <= 1) console.error(`${file}: ${code} at ${pointer ?? '-'}: ${message}`);
  }
  if (numErrors + numWarnings > 0) bad += 1;
}
process.exit(bad > 0 ? 1 : 0);
