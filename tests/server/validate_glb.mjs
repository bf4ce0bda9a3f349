// Checks GLB files with Khronos' own validator; prints {path: [what is wrong]}, errors and warnings.
import { readFile } from "node:fs/promises";
import { validateBytes } from "gltf-validator";

const WARNING = 1;
const found = {};
for (const path of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(await readFile(path)));
  found[path] = report.issues.messages
    .filter((issue) => issue.severity <= WARNING)
    .map((issue) => `${issue.code} ${issue.pointer ?? ""} ${issue.message}`);
}
process.stdout.write(JSON.stringify(found));
