// The robot in 3-D: orbit with the mouse or a finger, play, pause and scrub.
import { Motion, lastBefore } from "./kinematics.js";
import { Stage } from "./stage.js";

const STEP = 0.5; // an arrow key moves this far [s]

const find = (id) => document.getElementById(`motion-${id}`);

const start = () => {
  const data = JSON.parse(find("data").textContent);
  const motion = new Motion(data);
  const canvas = find("canvas");
  let stage;
  try {
    stage = new Stage(canvas, data, motion);
  } catch {
    find("none").hidden = false;
    return;
  }
  find("view").hidden = false;
  const [play, slider, words, speed] = ["play", "slider", "words", "speed"].map(find);
  const begins = data.phases.map((phase) => phase.start);
  let time = 0, playing = false, seen = true, asked = 0, before = null;

  const say = () => {
    const phase = data.phases[lastBefore(begins, time)];
    const name = phase && time <= phase.end + 1e-9 ? ` \u00b7 ${phase.name}` : "";
    words.textContent = `${time.toFixed(1)} s of ${motion.duration.toFixed(1)} s${name}`;
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

  // #motion=12.5 opens the page at that second; else it plays when it is first seen.
  let wanted = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  const fromAddress = () => {
    const given = /^#motion=(\d+(?:\.\d+)?)$/.exec(location.hash);
    if (!given) return;
    wanted = false;
    playing = false;
    go(Number(given[1]));
  };
  addEventListener("hashchange", fromAddress);
  fromAddress();
  new IntersectionObserver(([entry]) => {
    seen = entry.isIntersecting;
    before = null;
    if (seen && wanted) { wanted = false; run(true); }
    if (seen) ask();
  }, { threshold: 0.2 }).observe(canvas);
};

start();
