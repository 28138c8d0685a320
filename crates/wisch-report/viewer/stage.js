// What is seen: robot and tool, and of each track scene, surface, path, marks and particles, in the colours of the page.
import {
  AmbientLight, Box3, BoxGeometry, BufferAttribute, BufferGeometry, CanvasTexture, CapsuleGeometry, Color,
  CylinderGeometry, DirectionalLight, DoubleSide, EdgesGeometry, Float32BufferAttribute, GridHelper, Group,
  HemisphereLight, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, PCFShadowMap, PerspectiveCamera,
  PlaneGeometry, Points, PointsMaterial, Scene, ShadowMaterial, Shape, ShapeGeometry, Sphere, SphereGeometry,
  Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { lastBefore, pose } from "./kinematics.js";

const PER_METRE = 1e4; // meshes and particles come as whole tenths of a millimetre
const ABOVE = 0.0015; // what is drawn on the surface floats this much over it [m]

const matte = (options) => new MeshStandardMaterial({ roughness: 0.75, metalness: 0, ...options });

// Vertices and triangles as a geometry with flat faces.
const faceted = ({ vertices, triangles }) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(vertices.map((v) => v / PER_METRE), 3));
  geometry.setIndex(triangles);
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
};

const newSolid = (shape, meshes) => {
  switch (shape.kind) {
    case "box": return new BoxGeometry(...shape.size);
    case "sphere": return new SphereGeometry(shape.radius, 40, 24);
    case "cylinder": return new CylinderGeometry(shape.radius, shape.radius, shape.length, 40).rotateX(Math.PI / 2);
    case "capsule": return new CapsuleGeometry(shape.radius, shape.length, 14, 40).rotateX(Math.PI / 2);
    default: return faceted(meshes[shape.mesh]);
  }
};

// Every mesh of the page as one geometry, however often it is placed.
const solid = (shape, meshes) =>
  shape.kind === "mesh" ? (meshes[shape.mesh].geometry ??= newSolid(shape, meshes)) : newSolid(shape, meshes);

const placed = (object, matrix) => {
  object.matrixAutoUpdate = false;
  object.matrix.copy(matrix);
  return object;
};

// A round dot for points.
const dot = () => {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.beginPath();
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fill();
  return new CanvasTexture(canvas);
};

// Dots that lie on a surface are drawn a little nearer, or it would cut them in half.
const dots = (size) => {
  const material = new PointsMaterial({ size, sizeAttenuation: false, map: dot(), alphaTest: 0.4 });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>
      gl_Position = projectionMatrix * vec4(0.988 * mvPosition.xyz, 1.0);`);
  };
  return material;
};

export class Stage {
  constructor(canvas, data, motions) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    this.materials = {
      body: matte({ roughness: 0.55 }),
      arm: matte({ roughness: 0.5 }),
      // The hand's shape often holds the tool's: let it be seen.
      hand: matte({ roughness: 0.5, transparent: true, opacity: 0.4, depthWrite: false }),
      tool: matte(),
      obstacle: matte({ transparent: true, opacity: 0.5, depthWrite: false }),
      carrier: matte({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
      edge: new LineBasicMaterial({ transparent: true, opacity: 0.6 }),
      surface: matte({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 }),
      outline: new LineMaterial({ linewidth: 2 }),
      first: new LineMaterial({ linewidth: 1.4, transparent: true, opacity: 0.8 }),
      contact: new LineMaterial({ linewidth: 2.6 }),
      lifted: new LineMaterial({ linewidth: 1.6, transparent: true, opacity: 0.8 }),
      particles: dots(4),
      // What was felt lies on what is true.
      pushed: dots(15),
      felt: dots(9),
      floor: new ShadowMaterial({ opacity: 0.16 }),
    };
    this.addRobot(data);
    this.tracks = data.tracks.map((track, i) => this.track(data, track, motions[i]));
    this.take(0);
    // A ball round what is seen of all tracks.
    this.reach = this.tracks.reduce((all, { balls }) => all.union(balls.all), new Sphere());
    this.addFloor();
    this.addLight();
    this.camera = new PerspectiveCamera(38, 1, 0.02, 200);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.62 * Math.PI;
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 40;
    this.look("robot");
  }

  // All that is seen of one track beside robot and tool, hidden.
  track(data, { scene, surface, phases, marks, particles }, motion) {
    const group = new Group();
    group.visible = false;
    this.scene.add(group);
    const track = { group, motion, worldFromSurface: pose(surface.pose) };
    const wiping = phases.find((phase) => phase.contact);
    const links = motion.links(wiping ? wiping.start : 0);
    this.move(motion, links);
    this.addScene(track, scene, data.meshes);
    this.addSurface(track, surface);
    this.addPath(track, phases);
    this.addMarks(track, marks);
    this.addParticles(track, particles);
    // Balls round what is to be seen: the robot as it begins to wipe, the surface, and all ways too.
    track.balls = {
      robot: this.ball([...this.links, this.tool, track.surface]),
      surface: this.ball([track.surface, this.tool]),
      all: this.ball([...this.links, this.tool, track.surface, ...track.path]),
    };
    track.home = this.frontOf(data, motion, links);
    return track;
  }

  // Shows one track instead of another.
  take(index) {
    this.tracks.forEach(({ group }, i) => { group.visible = i === index; });
    this.now = this.tracks[index];
  }

  addRobot(data) {
    this.links = data.links.map(({ arm, shapes }, i) => {
      const kind = i === data.tool.link ? "hand" : arm ? "arm" : "body";
      const group = new Group();
      group.matrixAutoUpdate = false;
      for (const shape of shapes) {
        const part = placed(new Mesh(solid(shape, data.meshes), this.materials[kind]), pose(shape.pose));
        part.castShadow = true;
        part.receiveShadow = true;
        group.add(part);
      }
      this.scene.add(group);
      return group;
    });
    this.tool = new Mesh(solid(data.tool, data.meshes), this.materials.tool);
    this.tool.matrixAutoUpdate = false;
    this.tool.castShadow = true;
    this.scene.add(this.tool);
  }

  addScene({ group }, scene, meshes) {
    for (const { part, ...object } of scene) {
      const geometry = solid(object, meshes);
      const worldFromObject = pose(object.pose);
      const body = placed(new Mesh(geometry, this.materials[part]), worldFromObject);
      body.receiveShadow = part === "carrier";
      body.renderOrder = part === "carrier" ? 0 : 1;
      group.add(body);
      group.add(placed(new LineSegments(new EdgesGeometry(geometry, 30), this.materials.edge), worldFromObject));
    }
  }

  addSurface(track, { first, rings }) {
    const { group, worldFromSurface } = track;
    const [outer, ...holes] = rings.map((ring) => ring.map(([x, y]) => new Vector2(x / PER_METRE, y / PER_METRE)));
    if (!outer || outer.length < 3) return;
    const shape = new Shape(outer);
    shape.holes = holes.map((hole) => new Shape(hole));
    track.surface = placed(new Mesh(new ShapeGeometry(shape), this.materials.surface), worldFromSurface);
    track.surface.receiveShadow = true;
    group.add(track.surface);
    const ends = [outer, ...holes].flatMap((ring) =>
      ring.flatMap((p, i) => [p, ring[(i + 1) % ring.length]].flatMap((end) => [end.x, end.y, ABOVE])));
    group.add(placed(this.lines(ends, this.materials.outline), worldFromSurface));
    // Where it was believed before it was found elsewhere.
    if (first) group.add(placed(this.lines(ends, this.materials.first), pose(first)));
  }

  lines(ends, material) {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(ends);
    return new LineSegments2(geometry, material);
  }

  // Where the tool is at a time, a little off the surface.
  tip({ motion, worldFromSurface }, time) {
    const normal = new Vector3().setFromMatrixColumn(worldFromSurface, 2).multiplyScalar(ABOVE);
    return new Vector3().setFromMatrixPosition(motion.tool(motion.links(time))).add(normal);
  }

  addPath(track, phases) {
    const { group, motion } = track;
    const begins = phases.map((phase) => phase.start);
    const ends = { contact: [], lifted: [] };
    let before = null;
    for (let k = 0; k < motion.count; k++) {
      const time = k * motion.period;
      const tip = this.tip(track, time);
      if (before && before.distanceToSquared(tip) > 1e-10) {
        const phase = phases[lastBefore(begins, time - motion.period / 2)];
        ends[phase && phase.contact ? "contact" : "lifted"].push(...before.toArray(), ...tip.toArray());
      }
      before = tip;
    }
    track.path = ["lifted", "contact"].filter((kind) => ends[kind].length).map((kind) => {
      const line = this.lines(ends[kind], this.materials[kind]);
      group.add(line);
      return line;
    });
  }

  // Where the tool was amid what happened.
  addMarks(track, marks) {
    for (const kind of ["pushed", "felt"]) {
      const places = marks.filter(({ felt }) => felt === (kind === "felt"))
        .flatMap(({ start, end }) => this.tip(track, (start + end) / 2).toArray());
      const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(places, 3));
      track.group.add(new Points(geometry, this.materials[kind]));
    }
  }

  // Each frame is the one before without some particles, and with others at the end.
  addParticles(track, particles) {
    let list = [];
    track.particleTimes = particles.map(([time]) => time);
    track.particleFrames = particles.map(([, removed, added]) => {
      const gone = new Set(removed);
      list = list.filter((_, i) => !gone.has(i));
      for (let i = 0; i < added.length; i += 2) list.push([added[i] / PER_METRE, added[i + 1] / PER_METRE]);
      return Float32Array.from(list.flatMap(([x, y]) => [x, y, ABOVE]));
    });
    const most = Math.max(1, ...track.particleFrames.map((frame) => frame.length));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(most), 3));
    geometry.setDrawRange(0, 0);
    track.particles = placed(new Points(geometry, this.materials.particles), track.worldFromSurface);
    track.particles.frustumCulled = false;
    track.group.add(track.particles);
  }

  ball(objects) {
    const box = new Box3();
    this.scene.updateMatrixWorld(true);
    for (const object of objects) if (object) box.expandByObject(object);
    return box.isEmpty() ? new Sphere(new Vector3(), 1) : box.getBoundingSphere(new Sphere());
  }

  addFloor() {
    const { center, radius } = this.reach;
    const cells = 2 * Math.min(60, Math.max(6, Math.ceil(3 * radius)));
    this.grid = new GridHelper(cells / 2, cells);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.set(Math.round(center.x), Math.round(center.y), 0);
    this.grid.material.vertexColors = false;
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.75;
    this.scene.add(this.grid);
    const floor = new Mesh(new PlaneGeometry(cells / 2, cells / 2), this.materials.floor);
    floor.position.set(this.grid.position.x, this.grid.position.y, -0.001);
    floor.receiveShadow = true;
    this.scene.add(floor);
    for (const [axis, colour] of [[[1, 0, 0], 0xd5342b], [[0, 1, 0], 0x2f9e44], [[0, 0, 1], 0x2b6cd5]]) {
      const line = this.lines([0, 0, 0.002, ...axis.map((v) => 0.4 * v)], new LineMaterial({ linewidth: 3, color: colour }));
      this.scene.add(line);
    }
  }

  addLight() {
    const { center, radius } = this.reach;
    this.scene.add(new HemisphereLight(0xffffff, 0x8a8f98, 1.7), new AmbientLight(0xffffff, 0.35));
    const sun = new DirectionalLight(0xffffff, 2.1);
    sun.position.copy(center).add(new Vector3(0.9, 0.5, 1.9).multiplyScalar(2 * radius));
    sun.target.position.copy(center);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.bias = -0.0005;
    sun.shadow.normalBias = 0.01;
    Object.assign(sun.shadow.camera, {
      left: -1.4 * radius, right: 1.4 * radius, top: 1.4 * radius, bottom: -1.4 * radius, near: 0.1, far: 9 * radius,
    });
    this.scene.add(sun, sun.target);
  }

  // From the far side of the surface, on the side of the arm.
  frontOf(data, motion, links) {
    const at = (i) => new Vector3().setFromMatrixPosition(links[i]);
    const ahead = new Vector3().setFromMatrixPosition(motion.tool(links));
    const base = at(Math.max(0, data.links.findIndex(({ shapes }) => shapes.length)));
    const way = ahead.sub(base).setZ(0);
    if (way.length() < 1e-3) way.set(1, 0, 0);
    const arm = data.links.findIndex(({ arm }) => arm);
    const aside = arm < 0 ? new Vector3() : at(arm).sub(base);
    const left = way.x * aside.y - way.y * aside.x > 1e-6;
    return way.normalize().applyAxisAngle(new Vector3(0, 0, 1), left ? 0.95 : -0.95).setZ(0.62).normalize();
  }

  // Shows "robot", "surface", or everything from "above".
  look(at) {
    const { center, radius } = this.now.balls[at === "above" ? "all" : at];
    const half = (this.camera.fov * Math.PI) / 360;
    const narrowest = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    const direction = at === "above" ? new Vector3(0, -1e-3, 1).normalize() : this.now.home;
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction, (0.95 * radius) / Math.sin(narrowest));
    this.controls.update();
  }

  move(motion, worldFromLink) {
    this.links.forEach((link, i) => link.matrix.copy(worldFromLink[i]));
    this.tool.matrix.copy(motion.tool(worldFromLink));
  }

  show(time) {
    const { motion, particles, particleTimes, particleFrames } = this.now;
    this.move(motion, motion.links(time));
    const frame = particleFrames[Math.max(0, lastBefore(particleTimes, time))];
    if (frame && frame !== this.particleFrame) {
      const { geometry } = particles;
      geometry.attributes.position.array.set(frame);
      geometry.attributes.position.needsUpdate = true;
      geometry.setDrawRange(0, frame.length / 3);
      this.particleFrame = frame;
    }
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  // Takes over the colours of the page, light or dark.
  paint() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => new Color(style.getPropertyValue(`--${name}`).trim() || "#888");
    const names = {
      body: "robot", arm: "robot-arm", hand: "robot-arm", tool: "tool", obstacle: "obstacle", carrier: "outline", edge: "obstacle-line",
      surface: "surface-3d", outline: "outline", first: "quiet", pushed: "goal", felt: "limit", contact: "contact", lifted: "quiet", particles: "left",
    };
    for (const [material, name] of Object.entries(names)) this.materials[material].color.copy(colour(name));
    this.grid.material.color.copy(colour("rule"));
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }
}
