// Compares where the view puts the tool with where the library puts it: check.mjs PAGE CSV.
// The CSV has a headline, then per line time [s] and x, y, z of the tool in the world [m].
import { readFileSync } from "node:fs";
import { Vector3 } from "three";
import { Motion } from "./kinematics.js";

const TOLERANCE = 1e-4; // positions of up to 23 variables are rounded to 1e-5 [m]

const [page, csv] = process.argv.slice(2).map((path) => readFileSync(path, "utf8"));
const data = JSON.parse(/<script type="application\/json" id="motion-data">([^<]*)</.exec(page)[1]);
const motion = new Motion(data, data.tracks[0]);
const rows = csv.trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
const errors = rows.map(([time, ...place]) => {
  const tool = new Vector3().setFromMatrixPosition(motion.tool(motion.links(time)));
  return tool.distanceTo(new Vector3(...place));
});
const worst = Math.max(...errors);
console.log(`${rows.length} places, largest difference ${worst.toExponential(2)} m`);
process.exit(rows.length > 0 && worst < TOLERANCE ? 0 : 1);
