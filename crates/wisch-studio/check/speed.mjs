// Measures the cost of followers of a live run: `node speed.mjs [REPETITIONS]`, with the programs named as in `run`. It repeats the
// same run with no, one and ten followers in turn. Followers read the whole stream and draw nothing.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { get } from "node:http";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { begin } from "./studio.mjs";

const repetitions = Number(process.argv[2] ?? 5);
const FOLLOWERS = [0, 1, 10];
const studio = await begin();
const out = mkdtempSync(join(tmpdir(), "studio-speed-"));
const factors = new Map(FOLLOWERS.map((count) => [count, []]));

/** Reads a stream to its end; returns its number of bytes. */
const follow = (id) => new Promise((resolve, reject) => {
  get(`${studio.url}api/runs/${encodeURIComponent(id)}/stream?after=0`, (answer) => {
    let bytes = 0;
    answer.on("data", (part) => { bytes += part.length; });
    answer.on("close", () => resolve(bytes));
  }).on("error", reject);
});

async function running() {
  for (;;) {
    const { runs } = await (await fetch(`${studio.url}api/overview`)).json();
    if (runs.length) return runs[0].id;
    await new Promise((done) => setTimeout(done, 50));
  }
}

try {
  for (let turn = 0; turn < repetitions; turn++) {
    for (const count of FOLLOWERS) {
      const child = spawn(process.env.WISCH, ["run", "chopping-board", "--live", "--json", "--force", "--memory", studio.memory, "--out", out], { stdio: ["ignore", "pipe", "inherit"] });
      let text = "";
      child.stdout.on("data", (part) => { text += part; });
      const ended = new Promise((resolve) => child.on("close", resolve));
      const id = await running();
      const streams = Array.from({ length: count }, () => follow(id));
      await ended;
      const bytes = await Promise.all(streams);
      if (new Set(bytes).size > 1 || bytes.includes(0)) throw new Error(`streams of ${bytes} bytes`);
      factors.get(count).push(JSON.parse(text).realtime_factor);
    }
  }
  const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
  const alone = median(factors.get(0));
  for (const [count, list] of factors) {
    console.log(`${count} followers: ${median(list).toFixed(1)} times real time (${Math.min(...list).toFixed(1)} to ${Math.max(...list).toFixed(1)}), ${Math.round((100 * median(list)) / alone)} % of alone`);
  }
  console.log(`load ${loadavg().map((load) => load.toFixed(1)).join(" ")}`);
} finally {
  rmSync(out, { recursive: true, force: true });
  await studio.end();
}
