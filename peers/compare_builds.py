#!/usr/bin/env python3
"""Runs two builds of wisch over scenarios and seeds and names every file that differs.

    peers/compare_builds.py REVISION [--new target/release/wisch] [--seeds 1,2,3] [--scenarios DIR] [--keep DIR] [--limit S]

The old build is a revision of this repository, which is built below target/compare, or a program. The new build is the
working tree, or a program. A folder of results that is already in --keep is not computed again. The exit code is 1 if
anything differs.
"""

import argparse
import filecmp
import pathlib
import shutil
import subprocess
import sys
import tempfile


def built(source, target):
    """The program that Cargo builds from the sources in a folder."""
    command = ["cargo", "build", "--release", "--locked", "--target-dir", target]
    subprocess.run(command, cwd=source, check=True)
    return target / "release" / "wisch"


def built_revision(revision):
    """The program of a revision; its sources and what Cargo makes of them lie below target/compare."""
    show = ["git", "rev-parse", "--verify", f"{revision}^{{commit}}"]
    commit = subprocess.run(show, check=True, capture_output=True, text=True).stdout.strip()
    folder = (pathlib.Path("target") / "compare").resolve()
    program = folder / commit / "wisch"
    if not program.exists():
        source = folder / commit / "source"
        source.mkdir(parents=True, exist_ok=True)
        files = subprocess.run(["git", "archive", commit], check=True, capture_output=True).stdout
        subprocess.run(["tar", "-x", "-C", source], check=True, input=files)
        shutil.copy2(built(source, folder / "build"), program)
    return program


def run(program, scenario, seed, out, limit):
    """The exit code of one run; its files lie in `out`."""
    code = out.with_suffix(".code")
    if not code.exists():
        words = [program, "run", scenario, "--seed", str(seed), "--no-memory", "--quiet", "--out", out]
        try:
            done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=limit)
            code.write_text(str(done.returncode))
        except subprocess.TimeoutExpired:
            code.write_text(f"none within {limit} s")
    return code.read_text()


def files(folder):
    """Name to path of all files; by their last part, so that a file may have moved to another folder."""
    return {path.name: path for path in folder.rglob("*") if path.is_file()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", help="a revision, or a program")
    parser.add_argument("--new", type=pathlib.Path, help="a program; without it, the working tree is built")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--scenarios", type=pathlib.Path, default=pathlib.Path("scenarios"))
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--limit", type=float, default=600.0, help="seconds that a run may take")
    args = parser.parse_args()
    is_program = pathlib.Path(args.old).is_file()
    old_program = pathlib.Path(args.old) if is_program else built_revision(args.old)
    new_program = args.new or built(pathlib.Path("."), pathlib.Path("target"))
    keep = args.keep or pathlib.Path(tempfile.mkdtemp())
    differing = 0
    for scenario in sorted(args.scenarios.glob("*.toml")):
        for seed in args.seeds.split(","):
            folders = [keep / side / f"{scenario.stem}-{seed}" for side in ("old", "new")]
            for folder in folders:
                folder.parent.mkdir(parents=True, exist_ok=True)
            pairs = zip((old_program, new_program), folders)
            codes = [run(p.resolve(), scenario, seed, f, args.limit) for p, f in pairs]
            if all(code.startswith("none") for code in codes):
                print(f"{scenario.stem} seed {seed}: not compared, neither ended within {args.limit} s", flush=True)
                continue
            old, new = map(files, folders)
            found = [f"exit code {codes[0]} became {codes[1]}"] if codes[0] != codes[1] else []
            found += [f"only old: {name}" for name in sorted(old.keys() - new.keys())]
            found += [f"only new: {name}" for name in sorted(new.keys() - old.keys())]
            found += [
                name
                for name in sorted(old.keys() & new.keys())
                if not filecmp.cmp(old[name], new[name], shallow=False)
            ]
            print(f"{scenario.stem} seed {seed}: {', '.join(found) or 'the same'}", flush=True)
            differing += bool(found)
    sys.exit(1 if differing else 0)


if __name__ == "__main__":
    main()
