// Checks that a piece has all fields that the page draws. Recordings are untrusted input.
import type { ConeShape, CylinderShape, DensityRecord, Head, MeshShape, Piece, Solid, TreatmentRecord } from "./recording.ts";

type Check = (value: unknown) => boolean;

const text: Check = (value) => typeof value === "string";
const finite: Check = (value) => typeof value === "number" && Number.isFinite(value);
const list = (each: Check): Check => (value) => Array.isArray(value) && value.every(each);
const some: Check = (value) => Array.isArray(value);
const tuple = (...checks: Check[]): Check => (value) => Array.isArray(value) && value.length === checks.length && checks.every((check, i) => check(value[i]));
const exactly = (length: number): Check => tuple(...Array.from({ length }, () => finite));
const maybe = (check: Check): Check => (value) => value === null || value === undefined || check(value);
const has = (fields: Record<string, Check>): Check => (value) =>
  typeof value === "object" && value !== null && Object.entries(fields).every(([name, check]) => check((value as Record<string, unknown>)[name]));
/** Checks that a value has fields, and then a condition on it. */
const such = <T>(fields: Record<string, Check>, holds: (value: T) => boolean): Check => (value) => has(fields)(value) && holds(value as T);

const pose = exactly(7);
const interval = exactly(2);
const estimate = has({ mean: finite, low: finite, high: finite });
const SOLIDS = new Map<unknown, Check>([
  ["box", has({ size: exactly(3) })], ["sphere", has({ radius: finite })], ["mesh", has({ mesh: finite })],
  ["cylinder", has({ radius: finite, length: finite })], ["capsule", has({ radius: finite, length: finite })],
]);
const solid = such<Solid>({ pose, kind: text, color: maybe(exactly(4)) }, (value) => SOLIDS.get(value.kind)?.(value) === true);
const mesh = has({ vertices: list(finite), triangles: list(finite) });

/** A radius of 0 would be no surface. */
const cylinder = such<CylinderShape>({ radius_m: finite, axis_rad: finite }, ({ kind, radius_m }) => kind === "cylinder" && radius_m !== 0);
/** A half angle of 0 would be a cylinder. */
const cone = such<ConeShape>({ radius_m: finite, half_angle_rad: finite, axis_rad: finite },
  ({ kind, radius_m, half_angle_rad: half }) => kind === "cone" && radius_m !== 0 && half > 0 && half < Math.PI / 2);
const chart = such<MeshShape>({ points: list(finite), places: list(finite), triangles: list(finite) }, ({ kind, points, places, triangles }) => {
  const count = points.length / 3;
  const isVertex = (i: number): boolean => Number.isInteger(i) && i >= 0 && i < count;
  return kind === "mesh" && count > 0 && places.length === 2 * count && triangles.length > 0 && triangles.length % 3 === 0 && triangles.every(isVertex);
});
const curved: Check = (value) => cylinder(value) || cone(value) || chart(value);
const shaped: Check = (value) => curved(value) || such<{ kind: string }>({}, ({ kind }) => kind === "plane")(value);

const event = has({ kind: text, start: finite, end: finite, words: text });

const head = has({
  task: maybe(has({ target: finite })), tool: has({ solid }), meshes: list(mesh),
  robot: maybe(has({
    variables: list(text), links: list(has({ shapes: list(solid), collision: maybe(list(solid)) })),
    joints: list(has({ parent: finite, pose, axis: exactly(3), offset: finite, terms: list(interval) })),
  })),
});

const considered = has({
  strategy: text, chosen: (value) => typeof value === "boolean", error: maybe(text),
  score: maybe(finite), predicted: maybe(finite), lost: maybe(finite), strokes: maybe(finite), in_contact: maybe(finite), duration: maybe(finite),
  lines: maybe(list(list(finite))),
});

/** The fields of a round that say why its plan is as it is. */
const REASONS: Record<string, Check> = {
  why: list(text), considered: maybe(list(considered)), lost: maybe(finite), headings: maybe(list(text)),
  without: maybe(list(has({ stroke: finite, performance: finite, lost: finite, particles: list(finite), treated: maybe(some) }))),
  another: maybe(has({ gain: finite, line: list(finite), way: finite })), bases: maybe(has({ poses: list(tuple(finite, finite, finite, maybe(finite))), chosen: list(finite) })),
};

/** Largest value of a treated surface, in its unit. */
const MOST_VALUE = 1e6;

const treatment = such<TreatmentRecord>(
  { unit: text, target: finite, low: finite, high: finite, step: finite, cell: exactly(2), places: list(finite), steps: list(tuple(finite, list(finite), list(finite))) },
  ({ unit, low, high, target, places }) => {
    const isBand = unit === "passes" ? [target, low, high].every(Number.isInteger) : unit === "\u00b5m" && low < high;
    return isBand && high <= MOST_VALUE && low > 0 && low <= target && target <= high && places.length % 2 === 0;
  });

const round = has({
  ...REASONS,
  round: finite, duration: finite, root: maybe(pose), surface: has({ pose, rings: list(list(finite)), shape: maybe(curved) }), scene: list(solid), meshes: list(mesh),
  goal: maybe(such<{ kind: string }>({ kind: text }, (goal) => goal.kind !== "collected" || has({ place: exactly(2), radius: finite })(goal))),
  strokes: list(list(finite)), phases: list(has({ name: text, start: finite, end: finite })), press_force: maybe(finite), predicted: maybe(finite), growth: list(interval),
  particles: list(tuple(finite, some, some)), treatment: maybe(treatment), events: maybe(list(event)), contacts: maybe(list(interval)),
});

const incident = has({ time: maybe(finite), title: text, evidence: text, effect: text, advice: text });

const density = such<DensityRecord>({ cell: finite, places: list(finite), expected: list(finite), goal: maybe(finite) },
  ({ cell, places, expected }) => cell > 0 && places.length === 2 * expected.length);

const interpreted = has({
  round: finite, duration: finite, estimate, by_touch: estimate, verdict: text, words: list(text), found: maybe(pose),
  events: list(event), contacts: list(interval), incidents: maybe(list(incident)), particles: some, density: maybe(density), treated: maybe(some),
});

const fact: Check = (value) => Array.isArray(value) && text(value[0]) && text(value[1]) && maybe(finite)(value[2]);

const CHECKS: Partial<Record<Piece["piece"], Check>> = {
  head, round, interpreted,
  stage: has({ stage: text, words: text }),
  observed: has({ round: finite, detections: some }),
  truth: has({ round: finite, performance: maybe(finite), particles: maybe(some), treated: maybe(some), pushes: list(interval), surface: maybe(pose), shape: maybe(shaped) }),
  ended: has({ verdict: maybe(text), badge: maybe(text), story: has({ asked: text, happened: text, sure: text, surer: text, next: maybe(has({ words: text, command: maybe(text) })) }), facts: list(fact) }),
};

/** Returns a piece with today's names, if it has those of version 0.2.0. */
export function fromEarlierVersion(piece: Piece | null): Piece {
  const given = piece as unknown as { piece?: unknown; considered?: unknown; felt?: unknown } | null;
  if (given?.piece === "judged") {
    const { felt, ...rest } = given;
    return { by_touch: felt, ...rest, piece: "interpreted" } as unknown as Piece;
  }
  if (given?.piece === "round" && Array.isArray(given.considered)) {
    const considered = given.considered.map((plan: { worth?: unknown } | null) => (plan && "worth" in plan ? { score: plan.worth, ...plan } : plan));
    return { ...given, considered } as unknown as Piece;
  }
  return piece as Piece;
}

/** Throws if a piece of a known kind lacks a field. */
export function checkPiece(piece: Piece): void {
  if (typeof piece !== "object" || piece === null) throw new Error("a line is not a piece");
  const check = CHECKS[piece.piece];
  if (check && !check(piece)) throw new Error(`a ${piece.piece} piece lacks a field`);
  if (piece.piece === "head") checkJoints(piece);
}

/** Checks that joints come after their parents, and that the tool's link exists. */
function checkJoints({ robot, tool }: Head): void {
  if (!robot) return;
  const links = robot.joints.length + 1;
  if (robot.links.length > links || robot.joints.some(({ parent }, i) => !(parent >= 0 && parent <= i))) throw new Error("a joint comes before its parent, or a link has no joint");
  if (tool.link !== null && !(tool.link < links)) throw new Error("the link of the tool does not exist");
}
