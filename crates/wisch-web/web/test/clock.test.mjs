import assert from "node:assert/strict";
import { test } from "node:test";
import { Clock } from "../src/clock.ts";
import { nextStop } from "../src/keys.ts";

/** A source of frames that the test triggers. */
function hand() {
  let wanted = null;
  let now = 0;
  return {
    frames: { request: (callback) => { wanted = callback; return 1; }, cancel: () => { wanted = null; }, now: () => now },
    pass: (seconds, step = 0.02) => {
      for (let left = seconds; left > 1e-9; left -= step) {
        now += 1000 * step;
        if (!wanted) continue;
        const callback = wanted;
        wanted = null;
        callback(now);
      }
    },
    get idle() { return wanted === null; },
  };
}

const near = (a, b, tolerance = 0.03) => assert.ok(Math.abs(a - b) < tolerance, `${a} is not near ${b}`);

test("the clock plays at its speed, stops at the end and requests no more frames", () => {
  const h = hand();
  const clock = new Clock(h.frames);
  clock.join({ duration: 10, now: 10, live: false });
  clock.play();
  h.pass(2);
  near(clock.time, 2);
  clock.setSpeed(5);
  h.pass(1);
  near(clock.time, 7, 0.15);
  h.pass(2);
  assert.equal(clock.time, 10);
  assert.equal(clock.playing, false);
  assert.ok(h.idle);
  clock.play();
  assert.equal(clock.time, 0);
});

test("the clock does not jump after a tab was suspended", () => {
  const h = hand();
  const clock = new Clock(h.frames);
  clock.join({ duration: 100, now: 100, live: false });
  clock.play();
  h.pass(1);
  h.pass(50, 50);
  assert.ok(clock.time < 1.5);
});

test("the clock keeps real time however slow frames are, and says when it cannot", () => {
  const h = hand();
  const clock = new Clock(h.frames);
  clock.join({ duration: 100, now: 100, live: false });
  clock.play();
  h.pass(3, 0.6);
  near(clock.time, 3, 1e-6);
  assert.equal(clock.isLate, false);
  h.pass(12, 4);
  assert.equal(clock.isLate, true);
  h.pass(0.1);
  assert.equal(clock.isLate, false);
});

test("seeking is clamped to the recording, and notifies subscribers", () => {
  const clock = new Clock(hand().frames);
  clock.join({ duration: 4, now: 4, live: false });
  const seen = [];
  clock.subscribe(({ time }) => seen.push(time));
  for (const t of [2, -1, 9, NaN]) clock.seek(t);
  assert.deepEqual(seen, [2, 0, 4, 0]);
});

test("the clock follows a live run until the user seeks", () => {
  const h = hand();
  const clock = new Clock(h.frames);
  const run = { duration: 30, now: 1, live: true };
  clock.join(run);
  clock.follow();
  h.pass(2);
  assert.equal(clock.time, 1);
  assert.ok(h.idle);
  run.now = 3;
  clock.onGrowth();
  h.pass(2);
  assert.equal(clock.time, 3);
  clock.seek(0.5);
  run.now = 5;
  clock.onGrowth();
  h.pass(1);
  assert.equal(clock.time, 0.5);
  clock.play();
  h.pass(20);
  assert.equal(clock.following, true);
  assert.equal(clock.time, 5);
  Object.assign(run, { now: 6, live: false, duration: 6 });
  clock.onGrowth();
  assert.deepEqual([clock.following, clock.time], [false, 6]);
});

test("a run that arrives in pieces plays evenly", () => {
  for (const [every, piece] of [[0.4, 0.4], [0.1, 0.8], [0.6, 0.3]]) {
    const h = hand();
    const clock = new Clock(h.frames);
    const run = { duration: 1000, now: 0, live: true };
    clock.join(run);
    clock.follow();
    const steps = [];
    clock.subscribe(() => steps.push(clock.time));
    for (let k = 0; k < 40; k++) {
      run.now += piece;
      clock.onGrowth();
      if (k === 20) steps.length = 0;
      h.pass(every);
    }
    const moved = steps.slice(1).map((time, i) => time - steps[i]).filter((by) => by > 0);
    const even = piece * (0.02 / every);
    assert.ok(Math.max(...moved) < 1.3 * even && Math.min(...moved) > 0.7 * even, `${every}: ${Math.min(...moved)} to ${Math.max(...moved)}, even is ${even}`);
    assert.ok(moved.length > 0.95 * 19 * (every / 0.02), `stands still: ${moved.length}`);
    assert.ok(run.now - clock.time < 2 * piece, "lags behind");
  }
});

test("two recordings share one clock, which has the longer duration", () => {
  const clock = new Clock(hand().frames);
  clock.join({ duration: 4, now: 4, live: false });
  const leave = clock.join({ duration: 9, now: 9, live: false });
  assert.equal(clock.duration, 9);
  leave();
  assert.equal(clock.duration, 4);
});

test("speeds stay within their list", () => {
  const clock = new Clock(hand().frames);
  for (let i = 0; i < 9; i++) clock.faster(1);
  assert.equal(clock.speed, 10);
  for (let i = 0; i < 20; i++) clock.faster(-1);
  assert.equal(clock.speed, 0.1);
});

test("the next stop skips a stop at the current time", () => {
  const stops = [0, 2, 5];
  assert.deepEqual([nextStop(stops, 0, 1), nextStop(stops, 2, 1), nextStop(stops, 5, 1), nextStop(stops, 5, -1), nextStop(stops, 0.02, -1)], [2, 5, 5, 2, 0]);
});
