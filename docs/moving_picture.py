#!/usr/bin/env python3
"""Draws the first executed round of a run as a picture that moves: an SVG without scripts, fonts or links.

    wisch run scenarios/chopping-board.toml --no-memory --out /tmp/run
    python3 docs/moving_picture.py /tmp/run > docs/wiping.svg

It reads recording.jsonl.gz, which crates/wisch-web/web/src/recording.ts describes. The tool moves as it was measured,
the dirt as it was predicted: it is recorded at the end of each straight motion, and in between a particle rests until the
tool pushes it. At the end the dirt lies as estimated and, if the world is simulated, as in the ground truth.
"""

import gzip
import json
import math
import statistics
import sys
from bisect import bisect
from html import escape
from itertools import pairwise

LOOP_S, RUN, ESTIMATED, TRUE, END = 12, 12, 76, 88, 100  # length of the loop [s], and when its parts begin [%]
CONTACT_SHARE = 0.7  # how much of the run's part is wiping; free motion has the rest
TOP, WIDTH, HEIGHT, RIGHT, SIDE, STRIP, MARGIN_MM = 60, 520, 394, 568, 288, 92, 45
DIRTY, CLEAN = "#0d55a5", "#00694d"
TOOL = 'fill="#14829e" stroke="#0b5c8c" stroke-width="3" stroke-linejoin="round" paint-order="stroke"'
GOAL = 'fill="#f0c800" fill-opacity=".15" stroke="#6a4000" stroke-width="1.5" stroke-dasharray="4 3"'
STYLE = f"""text{{font:14px Inter,system-ui,-apple-system,'Segoe UI',sans-serif;fill:#1b222a}}.end{{text-anchor:end}}
.quiet{{font-size:13px;fill:#56616d}}.name{{font-size:16px}}.value{{font-size:22px}}.name,.value{{font-weight:600}}
circle{{stroke:#fff;stroke-width:.6}}.jump{{animation:{LOOP_S}s step-end infinite}}
.glide{{animation:{LOOP_S}s linear infinite}}@media (prefers-reduced-motion:reduce){{*{{animation:none!important}}}}"""
keyframes = {}


def animated(frames, kind="glide"):
    """Attributes of an element to which declarations happen at parts of the loop [%]; it glides or jumps to each."""
    frames = {f"{min(max(part, 0), 100):.2f}": what for part, what in frames}
    frames = {"0.00": next(iter(frames.values())), **frames, "100.00": [*frames.values()][-1]}
    text = "".join(f"{float(part):g}%{{{what}}}" for part, what in frames.items())
    return f'class="{kind}" style="animation-name:{keyframes.setdefault(text, f"k{len(keyframes)}")}"'


def shown(begin, end=END, other=0):
    return animated([(0, f"opacity:{other}"), (begin, "opacity:1"), (end, f"opacity:{end // END or other}")], "jump")


def line(places):
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)


def pairs(tenths):
    return [(x / 10, y / 10) for x, y in zip(tenths[::2], tenths[1::2])]


def at(rows, first):
    """The row that begins with this number, interpolated between the rows before and after it."""
    k = min(max(bisect(rows, first, key=lambda row: row[0]), 1), len(rows) - 1)
    share = min(max((first - rows[k - 1][0]) / ((rows[k][0] - rows[k - 1][0]) or 1), 0), 1)
    return [a + share * (b - a) for a, b in zip(rows[k - 1], rows[k])]


def rotated(quaternion, vector):
    (x, y, z, w), (a, b, c) = quaternion, vector
    t, u, v = 2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)
    return [a + w * t + y * v - z * u, b + w * u + z * t - x * v, c + w * v + x * u - y * t]


def tool_motion(surface, samples):
    """Rows of time, x, y [mm] and angle [deg] of the tool on the surface."""
    origin, (x, y, z, w), motion = surface["pose"][:3], surface["pose"][3:], []
    rows = [(t, piece["tool"][7 * i : 7 * i + 7]) for piece in samples for i, t in enumerate(piece["t"])]
    for time, pose in rows[::3]:  # each 0.12 s
        place = rotated((-x, -y, -z, w), [1000 * (a - b) for a, b in zip(pose, origin)])
        ahead = rotated((-x, -y, -z, w), rotated(pose[3:], (1, 0, 0)))
        angle = math.degrees(math.atan2(ahead[1], ahead[0]))
        angle += 360 * round((motion[-1][3] - angle) / 360) if motion else 0
        motion.append([time, *place[:2], angle])
    return motion


def footprint(mesh):
    """The path of what touches, in the tool's frame [mm]: the triangles within 1 mm of the contact plane z = 0."""
    corners = [*zip(*(iter(v / 10 for v in mesh["vertices"]),) * 3)]
    triangles = [[corners[i] for i in three] for three in zip(*(iter(mesh["triangles"]),) * 3)]
    return "".join(line(c[:2] for c in three) + "Z" for three in triangles if all(z < 1 for _, _, z in three))


def particle_tracks(steps, phases, motion):
    """Of each particle: rows of time, x, y [mm], and the time when it is gone, or None."""
    tracks = [[[[0.0, *place]], None] for place in pairs(steps[0][2])]
    present = [*range(len(tracks))]
    for (earlier, _, _), (end, gone, added) in pairwise(steps):
        begin = max([earlier] + [phase["start"] for phase in phases if phase["start"] < end <= phase["end"] + 1e-3])
        (x, y), last = at(motion, begin)[1:3], at(motion, end)[1:3]
        length = math.dist((x, y), last) or 1e-6
        u, v = (last[0] - x) / length, (last[1] - y) / length
        along, across = lambda p: (p[0] - x) * u + (p[1] - y) * v, lambda p: (p[1] - y) * u - (p[0] - x) * v
        course = [[0.0, begin], *([along(row[1:]), row[0]] for row in motion if begin < row[0] < end), [length, end]]
        rest = {index: tracks[index][0][-1][1:] for index in (present[k] for k in gone)}
        pushed = sorted(rest, key=lambda index: across(rest[index]))
        places, now = pairs(added), [None] * (len(added) // 2)
        # A particle that is pushed stays on its line along the tool's way. One that no place is left for is gone.
        for k in sorted(range(len(places)), key=lambda k: across(places[k])):
            aside = lambda n: abs(across(rest[pushed[n]]) - across(places[k]))
            n = min(range(len(pushed) - now.count(None) + 1), key=aside)
            now[k], pushed = pushed[n], pushed[n + 1 :]
            (rows, _), start = tracks[now[k]], rest[now[k]]
            way = min(max(math.dist(start, places[k]), 0.1), length)
            since = max(at(course, length - way)[1], rows[-1][0])
            ways = [(time, min(max(1 - (length - progress) / way, 0), 1)) for progress, time in course if time > since]
            rows.append([since, *start])
            rows += [[time, *(a + share * (b - a) for a, b in zip(start, places[k]))] for time, share in ways]
        for index in rest.keys() - set(now):
            tracks[index][1] = at(course, along(rest[index]))[1]
        present = [index for index in present if index not in rest] + now
    return tracks


def loop_parts(phases):
    """Rows of time [s] and part of the loop [%]."""
    phases = phases[max(0, next(i for i, phase in enumerate(phases) if phase["contact"]) - 2) :]
    spent = [sum(p["end"] - p["start"] for p in phases if p["contact"] == contact) for contact in (False, True)]
    rates = [(ESTIMATED - RUN) * share / s for share, s in zip((1 - CONTACT_SHARE, CONTACT_SHARE), spent)]
    rows = [[phases[0]["start"], RUN]]
    for phase in phases:
        rows.append([phase["end"], rows[-1][1] + rates[phase["contact"]] * (phase["end"] - phase["start"])])
    return rows


def board(head, plan, layers, motion, part):
    """The surface from above, lengths in millimetres, y up: goal, strokes, dirt and tool."""
    rings = [pairs(ring) for ring in plan["surface"]["rings"]]
    left, low = (min(side) - MARGIN_MM for side in zip(*rings[0]))
    width, height = (max(side) - min(side) + 2 * MARGIN_MM for side in zip(*rings[0]))
    goal, radius = [1000 * v for v in plan["goal"].get("place", (0, 0))], 1000 * plan["goal"].get("radius", 0)
    colour = lambda place: CLEAN if math.dist(place, goal) < radius else DIRTY
    outline = "".join(line(ring) + "Z" for ring in rings)
    out = [f'<path d="{outline}" fill="#fbf6ec" stroke="#8a7a5c" stroke-width="1.5"/>'
           f'<ellipse cx="{goal[0]:g}" cy="{goal[1]:g}" rx="{radius:g}" ry="{radius:g}" {GOAL}/>']
    for stroke, phase in zip(plan["strokes"], (phase for phase in plan["phases"] if phase["contact"])):
        drawn = animated([(part(phase["start"]), "stroke-dashoffset:1"), (part(phase["end"]), "stroke-dashoffset:0")])
        path = f'<path d="{line(pairs(stroke))}" fill="none" stroke="#0b5c8c" opacity=".6"'
        out.append(f'{path} stroke-dasharray="3 3" stroke-width=".8"/>')
        out.append(f'{path} stroke-dasharray="1" pathLength="1" stroke-width="1.8" {drawn}/>')
    out.append(f'<g opacity="0" {shown(0, ESTIMATED)}>')
    for rows, gone in particle_tracks(plan["particles"], plan["phases"], motion):
        frames = [(part(t), f"transform:translate({x:.1f}px,{y:.1f}px);fill:{colour((x, y))}") for t, x, y in rows]
        out.append(f'<g {shown(0, END if gone is None else part(gone))}><circle r="3" {animated(frames)}/></g>')
    for begin, end, places in layers:
        dots = "".join(f'<circle cx="{x}" cy="{y}" r="3" fill="{colour((x, y))}"/>' for x, y in pairs(places))
        out.append(f'</g><g opacity="{end // END}" {shown(begin, end)}>{dots}')
    frames = [(part(t), f"transform:translate({x:.1f}px,{y:.1f}px) rotate({a:.1f}deg)") for t, x, y, a in motion]
    presses = [(part(p["start"]), f"opacity:{0.65 if p['contact'] else 0.35}") for p in plan["phases"]]
    touching = footprint(head["meshes"][head["tool"]["solid"]["mesh"]])
    out.append(f'</g><g opacity="0" {shown(RUN, ESTIMATED)}><g {animated(frames)}>'
               f'<path d="{touching}" {TOOL} {animated(presses, "jump")}/></g></g>')
    return f'''<svg x="24" y="{TOP}" width="{WIDTH}" height="{HEIGHT}" viewBox="{left:g} {-low - height:g} {width:g}
{height:g}"><g transform="scale(1 -1)">{"".join(out)}</g></svg>'''


def draw(pieces):
    find = lambda kind: next((p for p in pieces if p["piece"] == kind and p.get("kind") != "planned"), None)
    head, plan, judged, truth = find("head"), find("round"), find("judged"), find("truth")
    samples = [p for p in pieces if p["piece"] == "samples" and p["round"] == plan["round"]]
    loop, force = loop_parts(plan["phases"]), [row for piece in samples for row in zip(piece["t"], piece["normal"])]
    part, percent = lambda time: at(loop, time)[1], lambda share: f"{100 * share:.0f} %" if share is not None else "?"
    wipes, estimate = [phase for phase in plan["phases"] if phase["contact"]], judged["estimate"]
    median = statistics.median(f for t, f in force if any(p["start"] <= t <= p["end"] for p in wipes))
    interval, then = f"{100 * estimate['low']:.0f} to {percent(estimate['high'])}", TRUE if truth else END
    steps = [(0, RUN, "Predicted", percent(plan["predicted"]), f"after the {len(wipes)} strokes of the plan"),
             (RUN, ESTIMATED, "Executed", f"{median:.1f} N", "median force while wiping"),
             (ESTIMATED, then, "Estimated", percent(estimate["mean"]), "90 % interval: " + interval)]
    steps += [(TRUE, END, "True", percent(truth["performance"]), "ground truth of the simulated world")] if truth else []
    layers = [(begin, end, piece["particles"] or []) for (begin, end, *_), piece in zip(steps[2:], (judged, truth))]
    drawn, words = board(head, plan, layers, tool_motion(plan["surface"], samples), part), ""
    for y, (begin, end, name, value, detail) in zip(range(TOP, 400, 64), steps):
        words += f"""<path d="M-12 {y}h312v58h-312z" fill="#e6f1f8" opacity="0" {shown(begin, end)}/>
<g {shown(begin, other=0.4)}><text y="{y + 24}" class="name">{name}</text><text x="{SIDE}" y="{y + 28}"
class="value end">{value}</text><text y="{y + 45}" class="quiet">{detail}</text></g>"""
    curve = line(((part(t) - RUN) / (ESTIMATED - RUN) * SIDE, STRIP - 6 * max(f, 0)) for t, f in force if part(t) > RUN)
    cover = animated([(RUN, "transform:translate(0)"), (ESTIMATED, f"transform:translate({SIDE}px)")])
    title, rules = escape(head["title"].replace("_", " ")), [f"@keyframes {n}{{{k}}}" for k, n in keyframes.items()]
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 880 508" width="880" height="508" role="img">
<title>{title}</title><style>{STYLE}{"".join(rules)}</style><rect x=".5" y=".5" width="879" height="507" rx="8"
fill="#fff" stroke="#cfd6dd"/><text x="24" y="38" class="name">{title}</text>{drawn}<g transform="translate({RIGHT})">
{words}<text y="344" class="quiet">Measured force</text><text x="{SIDE}" y="344" class="quiet end">line: 10 N</text>
<svg y="352" width="{SIDE}" height="{STRIP}"><path d="M0 {STRIP - .5}h{SIDE}m0 -60h-{SIDE}" stroke="#cfd6dd"/>
<path d="{curve}" fill="none" stroke="#db3900" stroke-width="1.5"/><g transform="translate({SIDE})" {cover}>
<rect width="{SIDE}" height="{STRIP}" fill="#fff" opacity=".9"/></g></svg></g><g transform="translate(24 484)">
<circle cx="6" cy="-5" r="4" fill="{DIRTY}"/><text x="18">dirt</text><circle cx="66" cy="-5" r="4" fill="{CLEAN}"/>
<text x="78">dirt at the goal</text><ellipse cx="206" cy="-5" rx="9" ry="9" {GOAL}/><text x="222">goal</text>
<path d="M274-13h24v16h-24z" {TOOL} opacity=".65"/><text x="308">tool</text><text x="832" class="quiet end">
The dirt moves as predicted. Free motion is shown faster.</text></g></svg>
"""


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) == 2 else sys.exit(__doc__)
    with gzip.open(f"{folder}/recording.jsonl.gz", "rt", encoding="utf-8") as recording:
        print(draw([json.loads(row) for row in recording]), end="")
