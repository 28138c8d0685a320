import assert from "node:assert/strict";
import { test } from "node:test";
import { Recording } from "../src/store.ts";
import { Frame } from "../src/timeline/frame.ts";
import { bandOf, drawPerformance } from "../src/timeline/plots.ts";
import { lines, sample } from "./sample.mjs";

test("the plot of performance rounds its target as all texts do", () => {
  const said = [];
  const pen = new Proxy({ fillText: (text) => said.push(text), measureText: () => ({ width: 0 }) }, { get: (own, name) => own[name] ?? (() => {}), set: () => true });
  const frame = new Frame(["performance"]);
  frame.layOut(1000, false);
  [globalThis.document, globalThis.getComputedStyle] = [{ documentElement: {} }, () => ({ getPropertyValue: () => "" })];
  drawPerformance(pen, frame, frame.lane("performance"), { head: { task: { target: 0.625 } }, rounds: [] });
  assert.ok(said.includes("target 62\u202f%"), said.join());
});

test("zoomed in, the band of an estimate is drawn as long as the estimate holds", () => {
  const { rounds: [first, second] } = Recording.parse(lines(sample()));
  const frame = new Frame(["performance"]);
  frame.layOut(1000, false);
  const until = second.start + second.firstContact;
  const at = (from, to) => {
    [frame.from, frame.to] = [from, to];
    return bandOf(frame, first, second);
  };
  const [from, to] = at(0, second.end);
  assert.deepEqual([from, to], [frame.x(first.end), frame.x(until)]);
  assert.deepEqual(at(first.end + 0.1, second.end), [frame.left, frame.x(until)]);
  assert.equal(at(until + 0.1, second.end), null);
});
