// What a recording is made of. It is a sequence of pieces, one JSON object a line, in the order in which things happen: the
// same lines are a run while it goes on, an episode that is kept, and the data of a report in one file.
//
// Lengths are in metres, times in seconds, forces in newtons, unless said otherwise. Times within a round count from the
// begin of its execution. The common clock lays the rounds one after the other.

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
  /** Where `visual` is true, the shapes are what the link looks like, else what collisions are checked with. */
  links: { name: string; arm: boolean; visual?: boolean; shapes: Solid[] }[];
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
  task: {
    action: string;
    medium: string;
    tool: string;
    surface: string;
    strategy: string;
    seed: number;
    /** Wanted share of the goal, in [0, 1]. */
    target: number;
    /** One sentence: what was asked. */
    asked: string;
  };
  robot: RobotRecord | null;
  /** Fixed to a link of the robot; its pose is in that link's frame. */
  tool: { link: number; solid: Solid } | { link: null; solid: Solid };
  meshes: MeshRecord[];
}

/** Something the program is at. */
export interface StagePiece {
  piece: "stage";
  round: number;
  stage: "planning" | "planned" | "following" | "predicting" | "audited" | "executing" | "interpreting";
  words: string;
}

/** Time; indices in the frame before of particles that are gone; places of those that are new. */
export type ParticleStep = [time: number, gone: number[], added: Places];

/** A plan that was weighed against others; what nobody knows of it is null. */
export interface Considered {
  strategy: string;
  /** Whether it became the plan. */
  chosen: boolean;
  /** The share of the dirt that it brings where it belongs, less three times what it loses, less way and time. */
  worth: number | null;
  /** Performance, and what is lost, in [0, 1]. */
  predicted: number | null;
  lost: number | null;
  strokes: number | null;
  /** Way in contact [m]. */
  in_contact: number | null;
  duration: number | null;
  /** Why there is no plan. */
  error: string | null;
}

/** A round that is about to be executed, or was only planned. */
export interface RoundPiece {
  piece: "round";
  /** Counted from 1. */
  round: number;
  /** A plan that nobody executes has no samples but those of the plan. */
  kind: "executed" | "planned";
  /** How long it is going to take. */
  duration: number;
  /** Of the robot's root in the world. */
  root: Pose | null;
  /** Where it is believed to be; its outline's rings, holes after the outer one. */
  surface: { pose: Pose; rings: Places[] };
  scene: ({ part: "obstacle" | "carrier" } & Solid)[];
  /** Meshes that are new; they continue those of the pieces before. */
  meshes: MeshRecord[];
  goal: { kind: "collected"; place: [number, number]; radius: number } | { kind: "absorbed" | "skimmed" | "polished" | "emitted" };
  /** The strokes as the robot is going to wipe them, corners in turn. */
  strokes: Places[];
  phases: { name: string; start: number; end: number; contact: boolean; stroke: number | null }[];
  /** Performance that the plan promises, in [0, 1], and how it is predicted to grow: time, performance. */
  predicted: number;
  growth: [number, number][];
  /** Particles as they are predicted to move; the first step has them as believed when the round begins. */
  particles: ParticleStep[];
  /** Why this plan: sentences. */
  why: string[];
  /** Among which plans it was chosen, where several were weighed. */
  considered?: Considered[];
}

/** What was measured, some instants in a row. */
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

/** The surface was looked at: after this round, 0 before the first. */
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

/** A round is over. */
export interface JudgedPiece {
  piece: "judged";
  round: number;
  duration: number;
  estimate: Estimate;
  /** By touch alone. */
  felt: Estimate;
  /** "goal met", "wipe again", ... */
  verdict: string;
  ending: string;
  /** What touch told and what follows: sentences. */
  words: string[];
  /** Where the surface was found to be, if elsewhere. */
  found: Pose | null;
  events: EventRecord[];
  /** When the tool was felt to touch: from, to. */
  contacts: [number, number][];
  /** Where the dirt may lie now: one way of many. */
  particles: Places;
}

/** What the simulated world knows of a round. */
export interface TruthPiece {
  piece: "truth";
  round: number;
  performance: number | null;
  particles: Places | null;
  /** When somebody really pushed: from, to. */
  pushes: [number, number][];
  /** Where the surface really is, if known. */
  surface: Pose | null;
}

/** The last piece. */
export interface EndedPiece {
  piece: "ended";
  met: boolean;
  /** null where somebody stopped it. */
  verdict: string | null;
  story: {
    /** What was asked. */
    asked: string;
    /** What happened. */
    happened: string;
    /** How sure we are. */
    sure: string;
    /** What it would take to be surer. */
    surer: string;
  };
  /** Label and value with unit. */
  facts: [string, string][];
  /** The episode in the memory, if one is kept. */
  episode: string | null;
}

export type Piece =
  | Head
  | StagePiece
  | RoundPiece
  | SamplesPiece
  | ObservedPiece
  | JudgedPiece
  | TruthPiece
  | EndedPiece;
