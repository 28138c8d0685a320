// The robot in 3-D: orbit with the mouse or a finger, choose a round, play, pause and scrub.
import { Motion, lastBefore } from "./kinematics.js";
import { Stage } from "./stage.js";

const STEP = 0.5; // an arrow key moves this far [s]

const find = (id) => document.getElementById(`motion-${id}`);

const start = () => {
  const data = JSON.parse(find("data").textContent);
  const motions = data.tracks.map((track) => new Motion(data, track));
  const canvas = find("canvas");
  let stage;
  try {
    stage = new Stage(canvas, data, motions);
  } catch {
    find("none").hidden = false;
    return;
  }
  find("view").hidden = false;
  const [play, slider, words, speed] = ["play", "slider", "words", "speed"].map(find);
  // What stands once per track, in their order.
  const [tabs, captions, strips] = [".rounds-shown button", ".caption", ".strip"]
    .map((selector) => [...find("view").querySelectorAll(selector)]);
  let track = data.tracks[0], motion = motions[0];
  let time = 0, playing = false, seen = true, asked = 0, before = null;

  const say = () => {
    const phase = track.phases[lastBefore(track.phases.map(({ start }) => start), time)];
    const current = [phase, ...track.marks].filter((span) => span && time >= span.start - 1e-9 && time <= span.end + 1e-9);
    words.textContent = [`${time.toFixed(1)} s of ${motion.duration.toFixed(1)} s`, ...current.map(({ name }) => name)].join(" \u00b7 ");
    slider.value = String(motion.duration > 0 ? Math.round((10000 * time) / motion.duration) : 0);
    slider.setAttribute("aria-valuetext", words.textContent);
    play.textContent = playing ? "\u275a\u275a Pause" : "\u25b6 Play";
  };
  const draw = (now) => {
    asked = 0;
    if (playing) {
      const passed = before === null ? 0 : Math.min(0.2, (now - before) / 1000);
      time = Math.min(motion.duration, time + passed * Number(speed.value));
      before = now;
      if (time >= motion.duration) playing = false;
    }
    stage.show(time);
    stage.render();
    say();
    if (playing && seen) ask();
  };
  const ask = () => { if (!asked) asked = requestAnimationFrame(draw); };
  const go = (wanted) => {
    time = Math.min(motion.duration, Math.max(0, wanted));
    ask();
  };
  const run = (wanted) => {
    playing = wanted;
    before = null;
    if (playing && time >= motion.duration) time = 0;
    ask();
  };

  // Shows one of the tracks from its beginning.
  const choose = (index) => {
    [track, motion] = [data.tracks[index], motions[index]];
    stage.take(index);
    for (const list of [captions, strips]) list.forEach((part, i) => { part.hidden = i !== index; });
    tabs.forEach((tab, i) => tab.setAttribute("aria-pressed", String(i === index)));
    playing = false;
    go(0);
  };

  tabs.forEach((tab, i) => tab.addEventListener("click", () => { choose(i); run(true); }));
  play.addEventListener("click", () => run(!playing));
  slider.addEventListener("input", () => {
    playing = false;
    go((motion.duration * Number(slider.value)) / 10000);
  });
  for (const at of ["robot", "surface", "above"]) {
    find(at).addEventListener("click", () => { stage.look(at); ask(); });
  }
  find("view").addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target === speed) return;
    const step = { ArrowLeft: -STEP, ArrowRight: STEP }[event.key];
    if (step !== undefined) { playing = false; go(time + step); }
    else if (event.key === " " && event.target.tagName !== "BUTTON") run(!playing);
    else return;
    event.preventDefault();
  });

  // The wheel scrolls the page until the picture is touched.
  stage.controls.enableZoom = false;
  canvas.addEventListener("pointerdown", () => { stage.controls.enableZoom = true; }, true);
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse") stage.controls.enableZoom = false;
  });
  stage.controls.addEventListener("change", ask);

  let shaped = false;
  new ResizeObserver(() => {
    const { clientWidth, clientHeight } = canvas;
    if (!clientWidth || !clientHeight) return;
    stage.resize(clientWidth, clientHeight);
    if (!shaped) stage.look("robot");
    shaped = true;
    ask();
  }).observe(canvas);
  const repaint = () => { stage.paint(); ask(); };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  repaint();

  // #motion=12.5 opens the page at that second, #round=2 and #round=2&motion=12.5 at that round; else it plays when it
  // is first seen.
  let wanted = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  const open = (address) => {
    const [found, round, second] = /^#(?:round=(\d+)&?)?(?:motion=(\d+(?:\.\d+)?))?$/.exec(address) ?? [];
    const index = round ? data.tracks.findIndex((shown) => shown.round === Number(round)) : 0;
    if (!found || found === "#" || index < 0) return false;
    wanted = false;
    choose(index);
    if (second) go(Number(second)); else run(true);
    return true;
  };
  const show = (address) => { if (open(address)) find("view").scrollIntoView(); };
  addEventListener("hashchange", () => show(location.hash));
  show(location.hash);
  // A second click on the same link changes no address.
  for (const link of document.querySelectorAll('a[href^="#round="]')) {
    link.addEventListener("click", (event) => {
      if (link.hash === location.hash) { event.preventDefault(); show(link.hash); }
    });
  }
  new IntersectionObserver(([entry]) => {
    seen = entry.isIntersecting;
    before = null;
    if (seen && wanted) { wanted = false; run(true); }
    if (seen) ask();
  }, { threshold: 0.2 }).observe(canvas);
};

start();
