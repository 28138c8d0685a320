"""Runs wisch-ros2 against a robot on Cyclone DDS or Fast DDS, and prints what worked.

    cargo build && cargo build --manifest-path crates/wisch-ros2/Cargo.toml --target-dir target
    pip install cyclonedds==11.0.1 numpy
    python peers/ros2/check.py                                  # Cyclone DDS
    make -C peers/ros2 && python peers/ros2/check.py --fastdds  # Fast DDS, needs libfastrtps-dev
    python peers/ros2/check.py --distro humble                  # the messages of Humble
    python peers/ros2/check.py --all-interfaces                 # the default settings of the DDS

The peer is `robot.py`, in another process of this computer. Exit code 1 if a step fails. It takes about three minutes.
"""

import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
ROBOT = """schema = 1
urdf = "arm7"
[link]
domain = {domain}
{interfaces}
ros_distro = "{distro}"
[motion]
action = "/joint_trajectory_controller/follow_joint_trajectory"
controllers = ["joint_trajectory_controller", "force_mode_controller"]
progress = "/joint_trajectory_controller/controller_state"
scaling = "/speed_scaling_state_broadcaster/speed_scaling"
[force]
kind = "ur_force_mode"
topic = "/force_torque_sensor_broadcaster/ft_data"
tare = "/io_and_status_controller/zero_ftsensor"
[limits]
state_age_ms = {age}
wrench_age_ms = {age}
[stop]
safety = "/io_and_status_controller/safety_mode"
program = "/io_and_status_controller/robot_program_running"
"""
TASK = ["arm-board", "--set", "plan.free_speed_m_per_s=0.25", "--no-memory", "--yes-every-round"]
PUSHES = {"straight down": "push 0 0 -20 2", "along the x axis": "push 20 0 0 2"}


class Peer:
    """A running robot.py, whose lines are kept with their times."""

    def __init__(self, file, options):
        command = [sys.executable, str(HERE / "robot.py"), str(file), *options]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True)
        self.lines = []
        threading.Thread(target=self.listen, daemon=True).start()
        self.wait_for("ready")

    def listen(self):
        for line in self.process.stdout:
            at, text = line.rstrip().split(" ", 1)
            self.lines.append((float(at), text))

    def tell(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def wait_for(self, text, after=0, limit=60.0):
        """Time of the first line with a text, after a number of lines."""
        end = time.time() + limit
        while time.time() < end:
            for at, line in self.lines[after:]:
                if text in line:
                    return at
            time.sleep(0.005)
        raise AssertionError(f"no {text!r} within {limit} s")

    def since(self, after, text):
        return [(at, line) for at, line in self.lines[after:] if text in line]


class Check:
    def __init__(self, arguments):
        self.folder = tempfile.TemporaryDirectory()
        self.file = pathlib.Path(self.folder.name) / "robot.toml"
        interfaces = "" if arguments.all_interfaces else 'interfaces = ["127.0.0.1"]'
        values = {"domain": arguments.domain, "distro": arguments.distro, "age": arguments.age}
        self.file.write_text(ROBOT.format(interfaces=interfaces, **values))
        self.programs = pathlib.Path(arguments.programs)
        self.peer = Peer(self.file, ["--fastdds", str(HERE / "bridge")] if arguments.fastdds else [])
        self.vendor = "Fast DDS" if arguments.fastdds else "Cyclone DDS"
        self.failed = 0

    def program(self, *words):
        return [str(self.programs / "wisch-ros2"), *words, str(self.file)]

    def step(self, name, run):
        try:
            print(f"{name:44} {run()}", flush=True)
        except (AssertionError, subprocess.TimeoutExpired) as error:
            self.failed += 1
            print(f"{name:44} FAILED: {error}", flush=True)

    def doctor(self, code):
        done = subprocess.run(self.program("doctor"), capture_output=True, text=True, timeout=60)
        assert done.returncode == code, done.stdout + done.stderr
        assert f"served by {self.vendor}" in done.stdout, done.stdout
        rates = re.findall(r"(\d+) Hz", done.stdout)
        return f"exit code {code}; joint states {rates[0]} Hz, wrench {rates[1]} Hz"

    def push_test(self):
        pipe = subprocess.PIPE
        command = [*self.program("push-test"), "--yes"]
        process = subprocess.Popen(command, stdout=pipe, stderr=subprocess.STDOUT, text=True)
        lines = []
        for line in process.stdout:
            lines.append(line.strip())
            for text, push in PUSHES.items():
                if text in line:
                    self.peer.tell(push)
        assert process.wait(timeout=10) == 0, lines
        return "; ".join(line.split(": ", 1)[1] for line in lines if line.startswith("measured"))

    def start_run(self, *options):
        command = [str(self.programs / "wisch"), "run", *TASK, "--on", str(self.file), *options]
        environment = {**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"}
        pipe = subprocess.PIPE
        return subprocess.Popen(command, stdout=pipe, stderr=subprocess.STDOUT, text=True, env=environment, cwd=self.folder.name)

    def run(self, *options):
        """A whole run; goals, and the time from a goal to the next."""
        before = len(self.peer.lines)
        process = self.start_run("--out", str(pathlib.Path(self.folder.name) / "out"), *options)
        text, _ = process.communicate(timeout=300)
        assert process.returncode in (0, 1), text
        begun, ended = self.peer.since(before, "accepted"), self.peer.since(before, "ended with status 4")
        assert begun and len(begun) == len(ended), self.peer.lines[before:]
        on, off = self.peer.since(before, "force mode on"), self.peer.since(before, "force mode off")
        assert len(on) == len(off) and bool(on) == ("--air" not in options), self.peer.lines[before:]
        return f"{len(begun)} goals to their end, force mode on and off {len(on)} times"

    def stop(self, cause, reason):
        """A fault in the second goal: the goal ends soon, and nothing begins after it."""
        self.peer.tell("home")
        time.sleep(0.5)
        before = len(self.peer.lines)
        process = self.start_run("--air", "0.05")
        self.peer.wait_for("accepted", before)
        middle = len(self.peer.lines)
        self.peer.wait_for("accepted", middle)
        time.sleep(0.3)
        at = time.time()
        cause(process)
        text, _ = process.communicate(timeout=60)
        time.sleep(0.3)
        ended = self.peer.since(middle, "ended with status")
        late = self.peer.since(middle, "accepted")[-1][0] - at
        assert ended and ended[-1][0] >= at and late < 0, (text, self.peer.lines[before:])
        assert reason in " ".join(text.split()), text
        return f"the goal ends {1e3 * (ended[-1][0] - at):.0f} ms later, and none begins"

    def executor(self, process):
        """The process of wisch-ros2 that a run has started."""
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit() and (words := read_words(entry)):
                if len(words) > 2 and words[1] == "execute" and words[2] == str(self.file):
                    return int(entry.name)
        raise AssertionError("no executor")

    def check(self):
        tell = self.peer.tell
        self.step("doctor, not commissioned", lambda: self.doctor(1))
        self.step("push test", self.push_test)
        self.step("doctor, commissioned", lambda: self.doctor(0))
        self.step("run 5 cm above the surface", lambda: self.run("--air", "0.05"))
        self.step("run with force mode, touching nothing", lambda: self.run("--rounds", "1"))
        self.step("Ctrl-C", lambda: self.stop(lambda process: process.send_signal(signal.SIGINT), ""))
        self.step("speed scaling 0", lambda: self.stop(lambda _: tell("scaling 0"), "speed scaling is 0"))
        tell("scaling 1")
        self.step("protective stop", lambda: self.stop(lambda _: tell("safety 3"), "PROTECTIVE_STOP"))
        tell("safety 1")
        self.step("silence", lambda: self.stop(lambda _: tell("silence"), "has been silent"))
        tell("speak")
        time.sleep(0.5)
        kill = lambda process: os.kill(self.executor(process), signal.SIGKILL)
        self.step("kill -9 of wisch-ros2", lambda: self.stop(kill, ""))
        tell("quit")
        return self.failed


def read_words(entry):
    try:
        return (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
    except OSError:
        return []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fastdds", action="store_true", help="Fast DDS in place of Cyclone DDS")
    parser.add_argument("--distro", default="jazzy", choices=["jazzy", "humble"])
    parser.add_argument("--all-interfaces", action="store_true", help="the defaults of the DDS in place of loopback only")
    parser.add_argument("--domain", type=int, default=77)
    parser.add_argument("--age", type=float, default=200, help="limits of the age of states and wrenches [ms]")
    parser.add_argument("--programs", default=str(ROOT / "target" / "debug"))
    check = Check(parser.parse_args())
    try:
        failed = check.check()
    finally:
        check.peer.process.kill()
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
