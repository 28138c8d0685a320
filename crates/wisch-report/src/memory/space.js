// Draws the answers of a query in 3-D. It uses WebGL without a library, so that the page stays small.
(() => {
"use strict";
const PER_METRE = 1e4; // points are stored as integers [0.1 mm]
const ROUND = 18; // sides of a round surface
const FIELD = 0.66; // vertical field of view [rad]
const GRID = 0.5; // distance between the lines on the floor [m]
const THROUGH = 0.3; // opacity of a highlighted item behind another item

const data = JSON.parse(document.getElementById("space-data").textContent);
const canvas = document.getElementById("space");
const gl = canvas.getContext("webgl", { antialias: true, alpha: true, premultiplyAlpha: true });
if (!gl) {
  document.getElementById("space-none").hidden = false;
  return;
}
document.getElementById("space-stage").hidden = false;

// Vectors.
const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const minus = (a, b) => add(a, b, -1);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const size = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const n = size(a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; };
const rotate = ([x, y, z], [, , , i, j, k, w]) => {
  const t = [2 * (j * z - k * y), 2 * (k * x - i * z), 2 * (i * y - j * x)];
  return [x + w * t[0] + j * t[2] - k * t[1], y + w * t[1] + k * t[0] - i * t[2], z + w * t[2] + i * t[1] - j * t[0]];
};

// A list of triangles: three corners, each a place and a normal.
class Skin {
  constructor() { this.values = []; }
  corner(place, normal) { this.values.push(place[0], place[1], place[2], normal[0], normal[1], normal[2]); }
  flat(a, b, c) {
    const normal = unit(cross(minus(b, a), minus(c, a)));
    this.corner(a, normal); this.corner(b, normal); this.corner(c, normal);
  }
  // Adds a surface of revolution about z. Profile: [radius, height, outward normal, upward normal] for each ring.
  turn(profile, put, sides = ROUND) {
    const at = (k, s) => {
      const angle = (2 * Math.PI * s) / sides, [radius, height, out, up] = profile[k];
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      return [put([radius * cos, radius * sin, height]), put([out * cos, out * sin, up], true)];
    };
    for (let k = 0; k + 1 < profile.length; k++) {
      for (let s = 0; s < sides; s++) {
        const [a, b, c, d] = [at(k, s), at(k, s + 1), at(k + 1, s + 1), at(k + 1, s)];
        for (const [place, normal] of [a, b, c, a, c, d]) this.corner(place, normal);
      }
    }
  }
  ball(radius, length, put, sides = ROUND, rings = 6) {
    const profile = [];
    for (const end of [-1, 1]) {
      for (let k = 0; k <= rings; k++) {
        const angle = (Math.PI / 2) * (end < 0 ? k / rings - 1 : k / rings);
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
        profile.push([radius * cos, radius * sin + (end * length) / 2, cos, sin]);
      }
    }
    this.turn(profile, put, sides);
  }
  tube(radius, a, b) {
    const z = minus(b, a), length = size(z);
    if (length < 1e-7) return;
    const up = unit(z), x = unit(cross(Math.abs(up[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], up)), y = cross(up, x);
    const put = ([p, q, r], isNormal) => add(add(add(isNormal ? [0, 0, 0] : a, x, p), y, q), up, r);
    this.turn([[radius, -radius / 3, 1, 0], [radius, length + radius / 3, 1, 0]], put, 7);
  }
  solid(solid) {
    const pose = solid.pose;
    const put = (place, isNormal) => { const t = rotate(place, pose); return isNormal ? t : add(t, pose); };
    if (solid.kind === "sphere") this.ball(solid.radius, 0, put);
    else if (solid.kind === "capsule") this.ball(solid.radius, solid.length, put);
    else if (solid.kind === "cylinder") {
      const [r, h] = [solid.radius, solid.length / 2];
      this.turn([[0, -h, 0, -1], [r, -h, 0, -1]], put);
      this.turn([[r, -h, 1, 0], [r, h, 1, 0]], put);
      this.turn([[r, h, 0, 1], [0, h, 0, 1]], put);
    } else if (solid.kind === "box") {
      const half = solid.size.map((v) => v / 2);
      for (const axis of [0, 1, 2]) {
        for (const side of [-1, 1]) {
          const [u, v] = side > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
          const corner = (p, q) => { const c = [0, 0, 0]; c[axis] = side * half[axis]; c[u] = p * half[u]; c[v] = q * half[v]; return put(c); };
          this.flat(corner(-1, -1), corner(1, -1), corner(1, 1));
          this.flat(corner(-1, -1), corner(1, 1), corner(-1, 1));
        }
      }
    } else {
      const { vertices, triangles } = data.meshes[solid.mesh];
      const at = (i) => put([vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]].map((v) => v / PER_METRE));
      for (let i = 0; i < triangles.length; i += 3) this.flat(at(triangles[i]), at(triangles[i + 1]), at(triangles[i + 2]));
    }
  }
}
const places = ({ points }) => {
  const list = [];
  for (let i = 0; i < points.length; i += 3) list.push([points[i] / PER_METRE, points[i + 1] / PER_METRE, points[i + 2] / PER_METRE]);
  return list;
};

const load = (values) => {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.STATIC_DRAW);
  return buffer;
};
const items = data.items.map((item) => {
  const skin = new Skin();
  item.solids.forEach((solid) => skin.solid(solid));
  for (const line of item.lines) {
    const list = places(line);
    for (let i = 0; i + 1 < list.length; i++) skin.tube(line.radius, list[i], list[i + 1]);
  }
  for (const dots of item.dots) {
    const list = places(dots), fine = list.length < 200;
    for (const at of list) skin.ball(dots.radius, 0, (p, isNormal) => (isNormal ? p : add(at, p)), fine ? 14 : 6, fine ? 5 : 2);
  }
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < skin.values.length; i += 6) {
    for (const k of [0, 1, 2]) {
      low[k] = Math.min(low[k], skin.values[i + k]);
      high[k] = Math.max(high[k], skin.values[i + k]);
    }
  }
  return { ...item, low, high, count: skin.values.length / 6, buffer: load(skin.values), shown: true };
});

// Returns the ball round the bounding box of the items.
const ball = (list) => {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const item of list) {
    for (const k of [0, 1, 2]) { low[k] = Math.min(low[k], item.low[k]); high[k] = Math.max(high[k], item.high[k]); }
  }
  if (!(low[0] <= high[0])) return { center: [0, 0, 0], radius: 1 };
  return { center: low.map((v, k) => (v + high[k]) / 2), radius: Math.max(0.1, size(minus(high, low)) / 2) };
};

const whole = ball(items);
const reach = GRID * Math.ceil((1.6 * whole.radius) / GRID);
const middle = whole.center.map((v) => GRID * Math.round(v / GRID));
const floor = [];
for (let v = -reach; v <= reach + 1e-9; v += GRID) {
  for (const [x, y, p, q] of [[v, -reach, v, reach], [-reach, v, reach, v]]) {
    floor.push(middle[0] + x, middle[1] + y, 0, 0, 0, 1, middle[0] + p, middle[1] + q, 0, 0, 0, 1);
  }
}
const floorBuffer = load(floor);

const shader = (kind, text) => {
  const made = gl.createShader(kind);
  gl.shaderSource(made, text);
  gl.compileShader(made);
  return made;
};
const program = gl.createProgram();
gl.attachShader(program, shader(gl.VERTEX_SHADER, `
attribute vec3 place; attribute vec3 normal; uniform mat4 clip; uniform vec3 eye;
varying vec3 n; varying vec3 toEye;
void main() { n = normal; toEye = eye - place; gl_Position = clip * vec4(place, 1.0); }`));
gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `
precision mediump float; uniform vec4 colour; uniform float lit; varying vec3 n; varying vec3 toEye;
void main() {
  vec3 m = normalize(n), e = normalize(toEye);
  m = dot(m, e) < 0.0 ? -m : m;
  float sun = max(0.0, dot(m, normalize(vec3(0.5, 0.3, 0.9))));
  float light = 0.42 + 0.22 * (0.5 + 0.5 * m.z) + 0.32 * sun + 0.14 * max(0.0, dot(m, e));
  vec3 c = mix(colour.rgb, min(vec3(1.0), colour.rgb * light), lit);
  gl_FragColor = vec4(c * colour.a, colour.a);
}`));
gl.linkProgram(program);
gl.useProgram(program);
const [place, normal] = ["place", "normal"].map((name) => gl.getAttribLocation(program, name));
const [clip, eyeAt, colourAt, lit] = ["clip", "eye", "colour", "lit"].map((name) => gl.getUniformLocation(program, name));
gl.enableVertexAttribArray(place);
gl.enableVertexAttribArray(normal);
gl.enable(gl.BLEND);
gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);

const rgb = (name) => {
  const text = name.startsWith("#") ? name : getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const number = parseInt(text.slice(1), 16);
  return [(number >> 16) & 255, (number >> 8) & 255, number & 255].map((v) => v / 255);
};

// The camera orbits the target.
const view = { target: whole.center, distance: 3, azimuth: 0.8, height: 0.5 };
const CLOSE = 0.45; // smallest radius shown round the highlighted items [m]
const look = (what) => {
  const shown = items.filter((item) => item.shown && item.count);
  const asked = shown.filter((item) => item.asked);
  const shining = asked.filter((item) => item.shines);
  const whole = ball(what === "all" || !asked.length ? shown : asked);
  const close = ball(shining);
  const near = what === "near" && shining.length && 2 * close.radius < whole.radius;
  const { center, radius } = near ? { center: close.center, radius: Math.max(CLOSE, 1.5 * close.radius) } : whole;
  view.target = center;
  const narrow = Math.min(1, canvas.clientWidth / Math.max(1, canvas.clientHeight));
  view.distance = (1.02 * radius) / Math.sin((FIELD / 2) * narrow);
  // The camera looks across the surface at the robot, from the side of its right hand.
  const way = data.robot && data.surface ? minus(data.surface, data.robot) : [0, 1, 0];
  view.azimuth = Math.atan2(way[1], way[0]) - 0.75;
  view.height = what === "above" ? 1.45 : 0.42;
  ask();
};

const multiply = (a, b) => {
  const m = new Float32Array(16);
  for (let c = 0; c < 4; c++) for (let r = 0; r < 4; r++) for (let k = 0; k < 4; k++) m[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return m;
};
const axes = () => {
  const [ca, sa, ch, sh] = [Math.cos(view.azimuth), Math.sin(view.azimuth), Math.cos(view.height), Math.sin(view.height)];
  const back = [ca * ch, sa * ch, sh], right = [-sa, ca, 0];
  return { back, right, up: cross(back, right) };
};
const draw = () => {
  asked = 0;
  const ratio = Math.min(2, devicePixelRatio || 1);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((v) => Math.max(1, Math.round(v * ratio)));
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  gl.viewport(0, 0, width, height);
  gl.depthMask(true);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  const { back, right, up } = axes();
  const eye = add(view.target, back, view.distance);
  const near = Math.max(0.01, view.distance * 0.02), far = view.distance + 4 * whole.radius + 10;
  const f = 1 / Math.tan(FIELD / 2);
  const lens = [(f * height) / width, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0];
  const turn = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
  gl.uniformMatrix4fv(clip, false, multiply(lens, turn));
  gl.uniform3fv(eyeAt, eye);
  const paint = (buffer, kind, count, colour, alpha, shading = 1) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 0);
    gl.vertexAttribPointer(normal, 3, gl.FLOAT, false, 24, 12);
    gl.uniform4f(colourAt, ...colour, alpha);
    gl.uniform1f(lit, shading);
    gl.drawArrays(kind, 0, count);
  };
  gl.depthFunc(gl.LEQUAL);
  paint(floorBuffer, gl.LINES, floor.length / 6, rgb("rule"), 0.9, 0);
  const shown = items.filter((item) => item.shown && item.count);
  for (const item of shown.filter((item) => item.alpha >= 1)) paint(item.buffer, gl.TRIANGLES, item.count, rgb(item.colour), 1);
  // Of a translucent item, only the nearest surface is drawn.
  for (const item of shown.filter((item) => item.alpha < 1)) {
    gl.colorMask(false, false, false, false);
    paint(item.buffer, gl.TRIANGLES, item.count, [0, 0, 0], 1);
    gl.colorMask(true, true, true, true);
    gl.depthMask(false);
    paint(item.buffer, gl.TRIANGLES, item.count, rgb(item.colour), item.alpha);
    gl.depthMask(true);
  }
  gl.depthFunc(gl.GREATER);
  gl.depthMask(false);
  for (const item of shown.filter((item) => item.shines)) paint(item.buffer, gl.TRIANGLES, item.count, rgb(item.colour), THROUGH, 0);
};
let asked = 0;
function ask() { if (!asked) asked = requestAnimationFrame(draw); }

// A drag orbits. A drag with shift, or with two fingers, pans. The wheel zooms after a click on the picture.
const pointers = new Map();
let touched = false;
const pan = (dx, dy) => {
  const { right, up } = axes();
  const scale = (2 * view.distance * Math.tan(FIELD / 2)) / canvas.clientHeight;
  view.target = add(add(view.target, right, -dx * scale), up, dy * scale);
};
const orbit = (dx, dy) => {
  view.azimuth -= 0.006 * dx;
  view.height = Math.max(-0.3, Math.min(1.55, view.height + 0.006 * dy));
};
const zoom = (factor) => { view.distance = Math.max(0.1, Math.min(20 * whole.radius + 5, view.distance * factor)); };
canvas.addEventListener("pointerdown", (event) => {
  touched = true;
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
});
canvas.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const now = [event.clientX, event.clientY];
  const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
  if (pointers.size === 2) {
    const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    const distance = (at) => Math.hypot(at[0] - other[0], at[1] - other[1]) || 1;
    zoom(distance(before) / distance(now));
    pan(dx / 2, dy / 2);
  } else if (event.shiftKey || event.buttons === 2) pan(dx, dy);
  else orbit(dx, dy);
  pointers.set(event.pointerId, now);
  ask();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
canvas.addEventListener("pointerleave", (event) => { if (event.pointerType === "mouse") touched = false; });
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  if (!touched) return;
  event.preventDefault();
  zoom(Math.exp(0.0012 * event.deltaY));
  ask();
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  const step = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, -12], ArrowDown: [0, 12] }[event.key];
  if (step) orbit(...step);
  else if (event.key === "+") zoom(0.9);
  else if (event.key === "-") zoom(1.1);
  else return;
  event.preventDefault();
  ask();
});
for (const button of document.querySelectorAll("[data-look]")) {
  button.addEventListener("click", () => look(button.dataset.look));
}
for (const box of document.querySelectorAll("[data-item]")) {
  box.addEventListener("change", () => { items[Number(box.dataset.item)].shown = box.checked; ask(); });
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ask);
let hasSize = false;
new ResizeObserver(() => {
  if (!canvas.clientWidth) return;
  if (!hasSize) look("near");
  hasSize = true;
  ask();
}).observe(canvas);
})();
