(() => {
  "use strict";
  const data = JSON.parse(document.getElementById("effect-data").textContent);
  const find = (id) => document.getElementById(id);
  const [slider, play, words] = ["slider", "play", "moment"].map(find);
  const last = data.frames.length - 1;
  const total = data.frames[last][0];

  // Every particle in every frame, in units of the picture.
  const states = [data.begin.map(([x, y, o]) => [x / 10, y / 10, o])];
  for (const changed of data.changes) {
    const next = states[states.length - 1].slice();
    for (const [i, x, y, o] of changed) next[i] = [x / 10, y / 10, o];
    states.push(next);
  }

  const frameAt = (d) => {
    let low = 0, high = last;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (data.frames[middle][0] <= d) low = middle; else high = middle - 1;
    }
    return low;
  };

  // Pose of the tool after distance d [mm], and the index of its motion.
  const poseAt = (d) => {
    if (!data.motions.length || d <= 0) return [data.start[0] / 10, data.start[1] / 10, data.start[2] / 1000, -1];
    let low = 0, high = data.motions.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (data.motions[middle][1] >= d) high = middle; else low = middle + 1;
    }
    const [from, to, ax, ay, ah, bx, by, bh] = data.motions[low];
    const s = to > from ? Math.min(1, (d - from) / (to - from)) : 1;
    const mix = (a, b) => a + (b - a) * s;
    return [mix(ax, bx) / 10, mix(ay, by) / 10, mix(ah, bh) / 1000, low];
  };

  const covers = (d, x, y) => {
    const [tx, ty, heading] = poseAt(d);
    const c = Math.cos(heading), s = Math.sin(heading);
    // y points down in the picture, so a turn by the heading goes the other way round.
    const u = (c * (x - tx) - s * (y - ty)) * 10, v = (s * (x - tx) + c * (y - ty)) * 10;
    let inside = false;
    for (const ring of data.footprint) {
      for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
        const [ax, ay] = ring[i], [bx, by] = ring[j];
        if ((ay > v) !== (by > v) && u < ax + (v - ay) / (by - ay) * (bx - ax)) inside = !inside;
      }
    }
    return inside;
  };

  // When a particle that a frame takes up is first under the tool.
  const takenUp = new Map();
  const whenTaken = (k, i) => {
    const key = k * states[0].length + i;
    if (!takenUp.has(key)) {
      const [a, b] = [data.frames[k][0], data.frames[k + 1][0]];
      let when = b;
      for (let n = 0; n <= 60; n++) {
        const d = Math.max(a + (b - a) * n / 60, 0.001);
        if (covers(d, states[k][i][0], states[k][i][1])) { when = d; break; }
      }
      takenUp.set(key, when);
    }
    return takenUp.get(key);
  };

  // Between two frames a pushed particle waits for the tool, then rides along to where it ends.
  const place = (k, i, d) => {
    const p = states[k][i];
    if (k === last || states[k + 1][i] === p) return p;
    const q = states[k + 1][i];
    if (q[2] === 3) return d >= whenTaken(k, i) ? q : p;
    const way = Math.hypot(q[0] - p[0], q[1] - p[1]);
    const ahead = (data.frames[k + 1][0] - d) / 1000 * data.scale;
    if (ahead >= way) return p;
    const s = 1 - ahead / way;
    return [p[0] + (q[0] - p[0]) * s, p[1] + (q[1] - p[1]) * s, p[2]];
  };

  const round = (v) => v.toFixed(1);
  const size = Number(find("moving-lost").dataset.radius);
  const show = (share) => {
    const d = share * total;
    const k = share >= 1 ? last : share <= 0 ? 0 : frameAt(d);
    let left = "", done = "", lost = "";
    for (let i = 0; i < states[0].length; i++) {
      const [x, y, outcome] = place(k, i, d);
      if (outcome === 0) left += `M${round(x)} ${round(y)}h0`;
      else if (outcome === 1) done += `M${round(x)} ${round(y)}h0`;
      else if (outcome === 2) lost += `M${round(x - size)} ${round(y - size)}l${2 * size} ${2 * size}m0 ${-2 * size}l${-2 * size} ${2 * size}`;
    }
    find("moving-left").setAttribute("d", left);
    find("moving-done").setAttribute("d", done);
    find("moving-lost").setAttribute("d", lost);

    const [x, y, heading, motion] = poseAt(share >= 1 ? total : d);
    find("moving-tool").setAttribute("transform",
      `translate(${round(x)} ${round(y)}) rotate(${(-heading * 180 / Math.PI).toFixed(2)})`);
    let trail = "", stroke = -1;
    for (let m = 0; m <= motion; m++) {
      const [, , ax, ay, , bx, by, , of] = data.motions[m];
      if (of !== stroke) trail += `M${ax / 10} ${ay / 10}`;
      trail += m < motion ? `L${bx / 10} ${by / 10}` : `L${round(x)} ${round(y)}`;
      stroke = of;
    }
    find("moving-trail").setAttribute("d", trail);

    const next = Math.min(k + 1, last);
    const [d0, p0] = data.frames[k], [d1, p1] = data.frames[next];
    const part = d1 > d0 ? Math.min(1, Math.max(0, (d - d0) / (d1 - d0))) : 0;
    const performance = (p0 + (p1 - p0) * part) / 10;
    const chart = find("cursor").dataset;
    const cx = Number(chart.from) + (Number(chart.to) - Number(chart.from)) * share;
    const cy = Number(chart.bottom) + (Number(chart.top) - Number(chart.bottom)) * performance / 100;
    find("cursor-line").setAttribute("d", `M${round(cx)} ${chart.top}V${chart.bottom}`);
    find("cursor-dot").setAttribute("cx", round(cx));
    find("cursor-dot").setAttribute("cy", round(cy));
    const strokes = data.motions.length ? data.motions[data.motions.length - 1][8] + 1 : 0;
    words.textContent = `${(d / 1000).toFixed(2)} m wiped · ${performance.toFixed(1)} % ${words.dataset.achieved}` +
      (stroke >= 0 ? ` · stroke ${stroke + 1} of ${strokes}` : "");
    slider.value = String(Math.round(share * 1000));
  };

  let running = null, share = 1;
  const stop = () => {
    if (running !== null) cancelAnimationFrame(running);
    running = null;
    play.textContent = "▶ Play";
  };
  // A quarter of a metre per second, but neither a flash nor a film.
  const seconds = Math.min(24, Math.max(5, total / 250));
  play.addEventListener("click", () => {
    if (running !== null) { stop(); return; }
    if (share >= 1) share = 0;
    play.textContent = "❚❚ Pause";
    let before = null;
    const tick = (now) => {
      if (before !== null) share = Math.min(1, share + (now - before) / 1000 / seconds);
      before = now;
      show(share);
      if (share < 1) running = requestAnimationFrame(tick); else stop();
    };
    running = requestAnimationFrame(tick);
  });
  slider.addEventListener("input", () => { stop(); share = Number(slider.value) / 1000; show(share); });

  // #frame=12 or #frame=end opens the page at that moment.
  const fromAddress = () => {
    const wanted = /^#frame=(\d+|end)$/.exec(location.hash);
    stop();
    if (!wanted) { share = 0; }
    else if (wanted[1] === "end") { share = 1; }
    else { share = total > 0 ? data.frames[Math.min(last, Number(wanted[1]))][0] / total : Number(wanted[1] > 0); }
    show(share);
  };
  addEventListener("hashchange", fromAddress);
  fromAddress();
  find("player").hidden = false;
})();
