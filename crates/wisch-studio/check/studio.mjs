// Runs the studio as a process with a temporary memory.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";

export async function begin() {
  const memory = mkdtempSync(join(tmpdir(), "studio-check-"));
  const { WISCH, STUDIO, ENGINE = join(dirname(WISCH), "wisch-prolog") } = process.env;
  const child = spawn(STUDIO, ["--memory", memory, "--wisch", WISCH, "--engine", ENGINE], { stdio: ["ignore", "pipe", "inherit"] });
  const [url] = await once(createInterface({ input: child.stdout }), "line");
  const end = async () => {
    const over = once(child, "exit");
    child.kill("SIGTERM");
    const [code] = await over;
    rmSync(memory, { recursive: true, force: true });
    return code;
  };
  return { url, memory, end };
}
