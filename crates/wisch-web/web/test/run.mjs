// Bundles the tests with the tested modules, and runs them in node's test runner.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "wisch-web-"));
try {
  const tests = readdirSync(here).filter((name) => name.endsWith(".test.mjs"));
  await build({
    entryPoints: tests.map((name) => join(here, name)), bundle: true, platform: "node", format: "esm", outdir: folder,
    outExtension: { ".js": ".mjs" }, logLevel: "warning",
  });
  const { status } = spawnSync(process.execPath, ["--test", ...tests.map((name) => join(folder, name))], { stdio: "inherit" });
  process.exitCode = status ?? 1;
} finally {
  rmSync(folder, { recursive: true });
}
