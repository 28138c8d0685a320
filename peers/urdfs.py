"""Checks all URDFs and SRDFs below some folders with `wisch robot check`, and prints a table of the outcomes.

    git clone https://github.com/Daniella1/urdf_files_dataset
    git clone https://github.com/Gepetto/example-robot-data
    git clone https://github.com/moveit/moveit_resources            # and any other packages of robots
    cargo build --release --locked
    python peers/urdfs.py urdf_files_dataset example-robot-data moveit_resources

The script needs only Python 3 on Linux. Each file counts once, even if several packages contain copies of it. A URDF is checked
with the SRDF of the same name beside it, if there is one. An SRDF is checked with the URDF below the same folders that has the robot's
name and most of the links which the SRDF names. Packages of meshes are looked for below the folders too, and passed by --package.

Outcomes are "refused" (exit code 2), "warnings" (1), "no warnings" (0), "crash" (any other end), "too slow" and "too large". Refusals
are counted by their messages, in which names and numbers are replaced. `--files` lists the file of each refusal, `--findings` counts
the warnings too. `--setup` also runs `wisch robot setup` on each robot that is read, and counts its outcomes.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
GIB = 2**30
# Examples of a message that the table names.
EXAMPLES = 2


class Collection:
    """The descriptions of robots below folders, each content once, and the folders that may be packages."""

    def __init__(self, folders):
        self.folders = collections.defaultdict(list)
        self.urdfs, self.srdfs, self.copies, seen = [], [], 0, set()
        for top in folders:
            for place, inner, names in os.walk(top):
                inner[:] = sorted(name for name in inner if name != ".git")
                for name in inner:
                    self.folders[name].append(pathlib.Path(place, name))
                for name in sorted(names):
                    kept = {".urdf": self.urdfs, ".srdf": self.srdfs}.get(pathlib.PurePath(name).suffix)
                    path = pathlib.Path(place, name)
                    if kept is None or not path.is_file():
                        continue
                    digest = path.suffix, hashlib.sha256(path.read_bytes()).digest()
                    self.copies += digest in seen
                    if digest not in seen:
                        seen.add(digest)
                        kept.append(path)
        self.robots = collections.defaultdict(list)
        for path in self.urdfs:
            text = path.read_text(errors="replace")
            self.robots[robot_name(text)].append((path, links(text)))

    def packages(self, urdf):
        """Arguments that name the packages of the meshes of a URDF: the nearest folders of their names with such a file."""
        files = collections.defaultdict(set)
        for file in re.findall(r"package://+([^\"']+)", urdf.read_text(errors="replace")):
            name, _, rest = file.partition("/")
            files[name].add(rest)
        given = []
        for name, rests in sorted(files.items()):
            places = [place for place in self.folders[name] if any((place / rest).is_file() for rest in rests)]
            if places:
                nearest = max(places, key=lambda place: len(os.path.commonpath([place, urdf])))
                given += ["--package", f"{name}={nearest}"]
        return given

    def urdf_of(self, srdf):
        """The URDF of an SRDF, or None."""
        text = srdf.read_text(errors="replace")
        named = set(re.findall(r'(?:link1?|link2|base_link|tip_link|child_link|parent_link)\s*=\s*"([^"]+)"', text))
        robots = self.robots[robot_name(text)]
        rank = lambda robot: (len(named & robot[1]), len(os.path.commonpath([srdf, robot[0]])))
        return max(robots, key=rank)[0] if robots else None


def robot_name(text):
    found = re.search(r'<robot\b[^>]*?\bname\s*=\s*["\']([^"\']*)', text)
    return found and found[1]


def links(text):
    return set(re.findall(r'<link\b[^>]*?\bname\s*=\s*["\']([^"\']*)', text))


class Limits:
    """Runs commands within a time [s] and a memory [bytes]."""

    def __init__(self, program, timeout, memory):
        self.program, self.timeout, self.memory = program, timeout, memory

    def run(self, arguments):
        """Exit code, or the limit that was exceeded; standard output and errors."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            # Address space is more than memory in use; this keeps the machine alive.
            resource.setrlimit(resource.RLIMIT_AS, (4 * self.memory, 4 * self.memory))

        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
            process = subprocess.Popen([self.program, *arguments], stdout=out, stderr=errors, preexec_fn=limit)
            killer = threading.Timer(self.timeout, process.kill)
            killer.start()
            _, status, used = os.wait4(process.pid, 0)
            is_late = not killer.is_alive()
            killer.cancel()
            process.returncode = code = os.waitstatus_to_exitcode(status)
            texts = []
            for file in (out, errors):
                file.seek(0)
                texts.append(file.read().decode(errors="replace"))
        if is_late:
            code = f"too slow (> {self.timeout:g} s)"
        elif used.ru_maxrss * 1024 > self.memory:
            code = f"too large (> {self.memory / GIB:g} GiB)"
        return code, *texts


def kind(message):
    """A message without its place, and without the names and numbers in it."""
    message = re.sub(r"^(error: )?\S+?\.(urdf|srdf)(:\d+:\d+)?: ", "", message)
    message = re.sub(r"; (nearest|known): .*", "", message)
    message = re.sub(r"\bthe package \S+ is unknown.*", "the package … is unknown", message)
    message = re.sub(r'"[^"]*"(, "[^"]*")*', "…", message)
    message = re.sub(r"/\S+/\S+", "PATH", message)
    message = re.sub(r"[-+]?\b\d+(\.\d+)?([eE][-+]?\d+)?", "N", message)
    return message.split("; expected plain URDF")[0][:160]


def check(limits, arguments):
    """Outcome of `wisch robot check`, its kinds of errors and its kinds of warnings."""
    code, out, errors = limits.run(["robot", "check", "--json", *map(str, arguments)])
    names = {0: "no warnings", 1: "warnings", 2: "refused"}
    if code not in names:
        last = errors.strip().splitlines()[-1:] or [""]
        return code if isinstance(code, str) else f"crash ({code}): {last[0][:100]}", set(), set()
    findings = json.loads(out).get("findings", []) if out.strip() else []
    kinds = {severity: set() for severity in ("error", "warning", "note")}
    for found in findings:
        kinds[found["severity"]].add(f"{found['fault']}: {kind(found['value'])}")
    if code == 2 and not kinds["error"]:
        message = next((line for line in errors.splitlines() if line.startswith("error: ")), errors)
        kinds["error"].add(kind(message))
    return names[code], kinds["error"], kinds["warning"]


def setup(limits, urdf, packages):
    """Outcome of `wisch robot setup`, whose SRDF is written elsewhere."""
    with tempfile.TemporaryDirectory() as folder:
        out_file = pathlib.Path(folder) / "robot.srdf"
        code, out, errors = limits.run(["robot", "setup", "--json", str(urdf), "--out", str(out_file), *packages])
    if code == 0:
        return "written"
    message = next((line for line in errors.splitlines() if line.startswith("error: ")), errors.strip()[-100:])
    if not message and out.strip():
        message = str(json.loads(out.strip().splitlines()[-1]).get("problem"))
    return f"{code}: {kind(message)}"


def table(head, counts, examples=None):
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for name, count in counts.most_common():
        cells = [str(count), name.replace("|", "/")]
        if examples is not None:
            cells.append(", ".join(examples[name][:EXAMPLES]))
        print("| " + " | ".join(cells) + " |")
    print()


def survey(what, jobs, tasks, list_files, with_findings):
    """Runs the tasks, pairs of a file and a function that checks it, and prints their outcomes. Returns the outcomes by file."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(lambda task: task[1](), tasks))
    outcomes, kinds, warnings = collections.Counter(), collections.Counter(), collections.Counter()
    examples = collections.defaultdict(list)
    for (path, _), (outcome, errors, warned) in zip(tasks, results):
        outcomes[outcome] += 1
        kinds.update(errors)
        warnings.update(warned)
        for name in errors | warned:
            examples[name].append(path.name)
        if list_files and outcome not in ("no warnings", "warnings"):
            print(f"{path}: {outcome}: {'; '.join(sorted(errors))}")
    print(f"\n{what}: {len(tasks)}\n")
    table(["files", "outcome"], outcomes)
    if kinds:
        table(["files", "refused because of", "for example"], kinds, examples)
    if with_findings:
        table(["files", "warning", "for example"], warnings, examples)
    return {path: result[0] for (path, _), result in zip(tasks, results)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders that contain the packages")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "target/release/wisch")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="files that are checked at the same time")
    parser.add_argument("--timeout", type=float, default=30, help="longest time of one command [s]")
    parser.add_argument("--memory-gib", type=float, default=2, help="largest memory of one command [GiB]")
    parser.add_argument("--files", action="store_true", help="list the files that are refused")
    parser.add_argument("--findings", action="store_true", help="count the warnings too")
    parser.add_argument("--setup", action="store_true", help="set up each robot that is read")
    args = parser.parse_args()
    limits = Limits(args.program.resolve(), args.timeout, args.memory_gib * GIB)
    found = Collection([folder.resolve() for folder in args.folders])
    print(f"{len(found.urdfs)} URDFs and {len(found.srdfs)} SRDFs that differ; {found.copies} copies are left out")
    tasks = []
    for urdf in found.urdfs:
        given = [urdf, *found.packages(urdf)]
        tasks.append((urdf, lambda given=given: check(limits, given)))
    read = survey("URDFs", args.jobs, tasks, args.files, args.findings)
    pairs = [(srdf, found.urdf_of(srdf)) for srdf in found.srdfs]
    tasks = []
    for srdf, urdf in pairs:
        if urdf is not None and read[urdf] in ("no warnings", "warnings"):
            given = [urdf, "--srdf", srdf, *found.packages(urdf)]
            tasks.append((srdf, lambda given=given: check(limits, given)))
    print(f"{len(pairs) - len(tasks)} SRDFs have no URDF here that is read")
    survey("SRDFs", args.jobs, tasks, args.files, args.findings)
    if args.setup:
        robots = [urdf for urdf, outcome in read.items() if outcome in ("no warnings", "warnings")]
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            done = pool.map(lambda urdf: (urdf, setup(limits, urdf, found.packages(urdf))), robots)
            outcomes, examples = collections.Counter(), collections.defaultdict(list)
            for urdf, outcome in done:
                outcomes[outcome] += 1
                examples[outcome].append(urdf.name)
        table(["robots", "setup", "for example"], outcomes, examples)


if __name__ == "__main__":
    main()
