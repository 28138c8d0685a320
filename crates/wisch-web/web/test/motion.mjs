// Compares the drawn pose of the tool with its recorded pose: `npm run check:motion -- recording.jsonl`.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

/** Tolerance: a recording rounds joint positions to 1e-4, which adds up over an arm of many joints [m]. */
const TOLERANCE_M = 2e-3;

const source = (name) => fileURLToPath(new URL(`../src/${name}`, import.meta.url));
const { outputFiles } = await build({
  stdin: { contents: `export { Recording } from ${JSON.stringify(source("store.ts"))}; export { Tree } from ${JSON.stringify(source("scene/tree.ts"))}; export { matrix } from ${JSON.stringify(source("scene/solids.ts"))}; export { Vector3 } from "three";`, resolveDir: source("") },
  bundle: true, format: "esm", write: false, platform: "node", logLevel: "warning",
});
const { Recording, Tree, matrix, Vector3 } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);

let failed = process.argv.length < 3;
for (const path of process.argv.slice(2)) {
  const recording = Recording.parse(readFileSync(path, "utf8"));
  const { robot, tool } = recording.head;
  let [worst, count] = [0, 0];
  if (robot && tool.link !== null) {
    const tree = new Tree(robot.joints);
    for (const round of recording.rounds) for (let i = 0; i < round.count; i++) {
      tree.update(round.plan.root, round.q.map(({ data }) => data[i]));
      const at = new Vector3().setFromMatrixPosition(tree.worldFromLink[tool.link].clone().multiply(matrix(tool.solid.pose)));
      worst = Math.max(worst, at.distanceTo(new Vector3(...round.tool.slice(7 * i, 7 * i + 3))));
      count++;
    }
  }
  failed ||= recording.broken > 0 || !(worst < TOLERANCE_M);
  console.log(`${path}: ${count} instants, largest difference ${(1000 * worst).toFixed(2)} mm, ${recording.broken} broken lines`);
}
process.exit(failed ? 1 : 0);
