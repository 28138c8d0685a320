import assert from "node:assert/strict";
import { test } from "node:test";
import { Frames } from "../src/frames.ts";

/** A source of frames that the test triggers. */
function hand() {
  const wanted = [];
  const frames = new Frames((step) => wanted.push(step));
  return { frames, wanted, pass: (now = 0) => { for (const callback of wanted.splice(0)) callback(now); } };
}

test("a step and all draws that it requests run in one frame", () => {
  const { frames, wanted, pass } = hand();
  const made = [];
  const scene = () => made.push("scene");
  const view = () => { made.push("view"); frames.draw(scene); };
  const step = (now) => { made.push(now); frames.request(step); frames.draw(view); };
  frames.request(step);
  pass(16);
  assert.deepEqual(made, [16, "view", "scene"]);
  pass(32);
  assert.deepEqual(made.slice(3), [32, "view", "scene"]);
  assert.equal(wanted.length, 1);
});

test("a draw runs once per frame, and again in the next", () => {
  const { frames, pass, wanted } = hand();
  let count = 0;
  const again = () => { if (++count < 3) frames.draw(again); };
  frames.draw(again);
  frames.draw(again);
  pass();
  assert.equal(count, 1);
  pass();
  pass();
  assert.equal(count, 3);
  assert.equal(wanted.length, 0);
});

test("dropped and cancelled work does not run, and a failure stops no other work", () => {
  const { frames, pass } = hand();
  const made = [];
  const faults = [];
  globalThis.reportError = (error) => faults.push(error.message);
  const dropped = () => made.push("dropped");
  frames.draw(dropped);
  frames.drop(dropped);
  frames.cancel(frames.request(() => made.push("cancelled")));
  frames.request(() => { throw new Error("no"); });
  frames.draw(() => made.push("drawn"));
  pass();
  assert.deepEqual([made, faults], [["drawn"], ["no"]]);
});
