// The format of a recording: a sequence of pieces, one JSON object per line, in order of time. A live run, an episode and the
// report of a run use the same lines.
//
// Lengths are in metres, times in seconds, forces in newtons, unless stated otherwise. Times within a round start at its
// execution. The common clock concatenates the rounds.

/** x, y, z [m], quaternion x, y, z, w. */
export type Pose = [number, number, number, number, number, number, number];

/** Whole tenths of a millimetre: x, y in turn, in the surface frame. */
export type Places = number[];

export interface MeshRecord {
  /** x, y, z of all vertices in turn, in whole tenths of a millimetre. */
  vertices: number[];
  /** Three vertices each. */
  triangles: number[];
}

/** Red, green, blue and opacity, in [0, 1], sRGB. */
export type Rgba = [red: number, green: number, blue: number, opacity: number];

/** A shape at its pose. Cylinders and capsules lie along z; `length` of a capsule is without its caps. */
export type Solid = { pose: Pose; color?: Rgba } & (
  | { kind: "box"; size: [number, number, number] }
  | { kind: "cylinder" | "capsule"; radius: number; length: number }
  | { kind: "sphere"; radius: number }
  | { kind: "mesh"; mesh: number }
);

export interface JointRecord {
  /** Joint i carries link i + 1. */
  parent: number;
  pose: Pose;
  axis: [number, number, number];
  kind: "fixed" | "revolute" | "prismatic";
  /** Its position: offset plus the sum of factor times variable. */
  offset: number;
  terms: [variable: number, factor: number][];
}

export interface RobotRecord {
  name: string;
  /** Names of the variables. */
  variables: string[];
  joints: JointRecord[];
  /** Where `visual` is true, the shapes are what the link looks like, and `collision`, if given, has what collisions are checked
   * with. Else the shapes are what collisions are checked with. */
  links: { name: string; arm: boolean; visual?: boolean; shapes: Solid[]; collision?: Solid[] }[];
}

/** The first piece. */
export interface Head {
  piece: "head";
  schema: 1;
  /** Of the task. */
  title: string;
  /** "wisch 0.1.0" */
  program: string;
  /** When the run began, RFC 3339; null where that is not to be said, so that the same run gives the same bytes. */
  begun: string | null;
  /** null where it is unknown. */
  task: {
    action: string;
    medium: string;
    tool: string;
    surface: string;
    strategy: string;
    seed: number;
    /** Target performance, in [0, 1]. */
    target: number;
    /** The task and its target, as a sentence. */
    asked: string;
  } | null;
  robot: RobotRecord | null;
  /** Fixed to a link of the robot; its pose is in that link's frame. */
  tool: { link: number; solid: Solid } | { link: null; solid: Solid };
  meshes: MeshRecord[];
}

/** The current stage of the program. */
export interface StagePiece {
  piece: "stage";
  round: number;
  stage: "planning" | "planned" | "following" | "predicting" | "audited" | "executing" | "interpreting";
  words: string;
}

/** Time; indices in the frame before of particles that are gone; places of those that are new. */
export type ParticleStep = [time: number, gone: number[], added: Places];

/** Time; indices of the places whose value changes; their values, in steps. */
export type ValueStep = [time: number, changed: number[], values: number[]];

/** The places of a treated surface, with the allowed band and the predicted values. */
export interface TreatmentRecord {
  /** Passes of a tool, or the thickness of a coat. */
  unit: "passes" | "\u00b5m";
  /** In the unit. The band includes both its ends; passes are rounded before they are compared with it. */
  target: number;
  low: number;
  high: number;
  /** Value of one step. */
  step: number;
  /** Sides of a place's cell along x and y. */
  cell: [number, number];
  /** Middles of the cells. */
  places: Places;
  /** The first step has all values as believed when the round begins. */
  steps: ValueStep[];
}

/** A candidate plan; unknown values are null. */
export interface Considered {
  strategy: string;
  /** Whether it was chosen. */
  chosen: boolean;
  /** Score: share of the dirt that reaches the goal, minus three times the lost share, minus the share at risk in heaps near an edge, minus costs of remaining dirt by its distance, of path length and time. */
  score: number | null;
  /** Performance, and what is lost, in [0, 1]. */
  predicted: number | null;
  lost: number | null;
  strokes: number | null;
  /** Way in contact [m]. */
  in_contact: number | null;
  duration: number | null;
  /** Strokes of a plan that was not chosen, corners in turn; recordings up to version 0.2.0 have none. */
  lines?: Places[];
  /** Reason for a missing plan. */
  error: string | null;
}

/** The prediction for a plan without one of its strokes. */
export interface LeftOut {
  /** Index of the stroke. */
  stroke: number;
  /** Performance, and what is lost, in [0, 1]. */
  performance: number;
  lost: number;
  /** What is on the surface at the end. Empty with `treated`. */
  particles: Places;
  /** Values of `treatment.places` at the end, in steps. */
  treated?: number[];
}

/** Base poses that were rated, and the indices of those that were chosen, in order. */
export interface RatedBases {
  /** x, y [m] and yaw [rad] in the world; share of the path that is in reach from there, in [0, 1]. */
  poses: [x: number, y: number, yaw: number, share: number | null][];
  chosen: number[];
}

/** Shape of a curved surface. */
export type SurfaceShape = CylinderShape | ConeShape | MeshShape;

/** A surface of a mesh. */
export interface MeshShape {
  kind: "mesh";
  /** x, y, z of each vertex in the frame of the surface [m]. */
  points: readonly number[];
  /** x, y of each vertex in the chart [m]. */
  places: readonly number[];
  /** Three vertices of each triangle. */
  triangles: readonly number[];
}

/** A cylinder onto which the chart of a surface is rolled: it touches the chart at the origin. */
export interface CylinderShape {
  kind: "cylinder";
  /** Positive where the surface bulges towards the tool. */
  radius_m: number;
  /** Angle of its axis from the chart's x [rad]. */
  axis_rad: number;
}

/** A circular cone onto which the chart of a surface is rolled: it touches the chart at the origin. */
export interface ConeShape {
  kind: "cone";
  /** Distance of the origin from the axis; positive where the surface bulges towards the tool. */
  radius_m: number;
  /** Angle between axis and surface [rad]. */
  half_angle_rad: number;
  /** Direction from the chart's x in which it widens [rad]. */
  axis_rad: number;
}

/** A round before its execution, a plan without execution, or a round of an episode that was kept without a recording. */
export interface RoundPiece {
  piece: "round";
  /** Counted from 1. */
  round: number;
  /** A plan that nobody executes has no samples but those of the plan. A logged round has no plan. */
  kind: "executed" | "planned" | "logged";
  /** Expected duration. */
  duration: number;
  /** Of the robot's root in the world. */
  root: Pose | null;
  /** Where it is believed to be; its outline's rings in its chart, holes after the outer one; its shape if it is curved. */
  surface: { pose: Pose; rings: Places[]; shape?: SurfaceShape | null };
  scene: ({ part: "obstacle" | "carrier" } & Solid)[];
  /** Meshes that are new; they continue those of the pieces before. */
  meshes: MeshRecord[];
  goal: { kind: "collected"; place: [number, number]; radius: number } | { kind: "absorbed" | "skimmed" | "polished" | "dispensed" } | null;
  /** Normal force with which the tool is to press [N]; recordings of version 0.2.0 have none. */
  press_force?: number | null;
  /** The strokes as the robot is going to wipe them, corners in turn. */
  strokes: Places[];
  phases: { name: string; start: number; end: number; contact: boolean; stroke: number | null }[];
  /** Performance that the plan promises, in [0, 1], and how it is predicted to grow: time, performance. */
  predicted: number | null;
  growth: [number, number][];
  /** Particles as they are predicted to move; the first step has them as believed when the round begins. Empty with `treatment`. */
  particles: ParticleStep[];
  /** Of a polished or coated surface; recordings up to version 0.2.0 have none, and `particles` instead. */
  treatment?: TreatmentRecord;
  /** Why this plan: sentences. */
  why: string[];
  /** Among which plans it was chosen, where several were weighed. */
  considered?: Considered[];
  // Recordings up to version 0.2.0 have none of the next five.
  /** Share of the dirt that is lost after the plan, by the prediction, in [0, 1]. */
  lost?: number;
  /** The predictions for the plan without each of its strokes. */
  without?: LeftOut[];
  /** The stroke that is predicted to gain most if it is repeated at the end: its gain, its corners, its way in contact [m].
   * null, or missing beside `without`, if none gains. */
  another?: { gain: number; line: Places; way: number } | null;
  bases?: RatedBases;
  /** How the tool is turned in each stroke, and why: a sentence each. */
  headings?: string[];
  /** Of a logged round: its events, and its measured intervals of contact. */
  events?: EventRecord[];
  contacts?: [number, number][];
}

/** Consecutive measured samples. */
export interface SamplesPiece {
  piece: "samples";
  round: number;
  /** Times, rising over all pieces of the round. */
  t: number[];
  /** Positions of variables that change in here, by index; the others keep their last position. The first piece of a round has all. */
  q: Record<string, number[]>;
  /** Poses of the tool in the world: seven numbers an instant. */
  tool: number[];
  /** Force of the surroundings on the tool in the axes of the world: three numbers an instant. */
  force: number[];
  /** Its part along the surface's normal, positive when pressed. */
  normal: number[];
  /** Height of the tool over the surface as believed. */
  height: number[];
}

/** An observation of the surface: after this round, 0 before the first. */
export interface ObservedPiece {
  piece: "observed";
  round: number;
  detections: Places;
  hidden_m2: number;
}

export interface Estimate {
  mean: number;
  /** Of the 90 % interval. */
  low: number;
  high: number;
}

export interface EventRecord {
  /** "collision", "hand guiding", "effectless stroke", ... */
  kind: string;
  start: number;
  end: number;
  /** In words: what, where, how strong. */
  words: string;
  /** Whether somebody or something pushed. */
  by_hand: boolean;
}

/** Something that did not go as planned. */
export interface IncidentRecord {
  /** When it was first seen; null if it concerns all of the round. */
  time: number | null;
  /** What happened; pushes are called collisions. */
  title: string;
  /** The measurements that show it; empty without any. */
  evidence: string;
  /** What follows from it; empty if unknown. */
  effect: string;
  /** What a user can do about it; empty if nothing. */
  advice: string;
}

/** The density of the belief: cells that are expected to hold dirt. */
export interface DensityRecord {
  /** Side of a square cell [m]. */
  cell: number;
  /** Middles of the cells, in the chart of the surface. */
  places: Places;
  /** Expected number of particles in each cell: mean over the belief. */
  expected: number[];
  /** Expected number of particles on the surface, also in cells that are left out. */
  remaining?: number;
  /** Expected number of particles in the goal area, which the cells do not give exactly; missing without one. */
  goal?: number;
}

/** The result of a finished round. */
export interface InterpretedPiece {
  piece: "interpreted";
  round: number;
  duration: number;
  estimate: Estimate;
  /** From touch only. */
  by_touch: Estimate;
  /** "goal met", "wipe again", ... */
  verdict: string;
  ending: string;
  /** Summary of the round: sentences. */
  words: string[];
  /** Estimated pose of the surface, if it differs from the believed pose. */
  found: Pose | null;
  events: EventRecord[];
  /** Detected contacts: start, end. */
  contacts: [number, number][];
  /** Recordings of version 0.2.0 have none. */
  incidents?: IncidentRecord[];
  /** Estimated dirt locations: a typical sample of the belief. Empty with `treated`. */
  particles: Places;
  /** Density of the same belief; recordings up to version 0.2.0 have none. */
  density?: DensityRecord;
  /** Mean values over the belief of the round's `treatment.places`, in steps. */
  treated?: number[];
}

/** The simulated world's ground truth of a round. */
export interface TruthPiece {
  piece: "truth";
  round: number;
  performance: number | null;
  particles: Places | null;
  /** Number of particles on the surface, of which `particles` may be a part; recordings up to version 0.2.0 have none. */
  remaining?: number;
  /** True values of the round's `treatment.places`, in steps. */
  treated?: number[];
  /** True pushes: start, end. */
  pushes: [number, number][];
  /** True pose of the surface, if known. */
  surface: Pose | null;
  /** Its true shape, if it differs from the believed one. */
  shape?: SurfaceShape | { kind: "plane" } | null;
}

/** Label, value with unit, and the round that it is about: null for the whole run, missing in recordings of version 0.2.0. */
export type Fact = [label: string, value: string, round?: number | null];

/** The last piece. */
export interface EndedPiece {
  piece: "ended";
  met: boolean;
  /** Of the last round; null if nothing was executed. */
  verdict: string | null;
  /** How the run ended, in a few words; recordings of version 0.2.0 have none. */
  badge?: string | null;
  story: {
    /** Task and target. */
    asked: string;
    /** Result. */
    happened: string;
    /** Estimate with its interval, and ground truth if known. */
    sure: string;
    /** What would narrow the interval. */
    surer: string;
    /** What to do next; null if nothing. Recordings of version 0.2.0 have none. */
    next?: { words: string; command: string | null } | null;
  };
  facts: Fact[];
  /** The episode in the memory, if one is kept. */
  episode: string | null;
}

export type Piece =
  | Head
  | StagePiece
  | RoundPiece
  | SamplesPiece
  | ObservedPiece
  | InterpretedPiece
  | TruthPiece
  | EndedPiece;
