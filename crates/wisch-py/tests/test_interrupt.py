"""Ctrl-C takes effect in every stage within a second."""

import signal
import subprocess
import sys
import time

import pytest

#: Sends the signal in a stage, and prints the time from the signal to its exception [s].
SCRIPT = """
import signal, sys, threading, time
import wisch
sent = []
def after(seconds):
    def send():
        time.sleep(seconds)
        sent.append(time.monotonic())
        signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)
    threading.Thread(target=send, daemon=True).start()

task = wisch.load_task("{scenario}", set={{"plan.evaluations": {evaluations}, "perception.senses": ["touch"]}})
robot = task.robot()
session = task.session(robot)

class Robot:
    def execute(self, motion, sink):
        if not "{stage}":
            after(0.3)
        while True:
            k = 0
            for k in range(100):
                pass
            time.sleep(10)

def on_event(event):
    if event["event"] == "{stage}":
        after(0.3)

try:
    session.run(Robot(), on_event=on_event)
except KeyboardInterrupt:
    print(time.monotonic() - sent[0])
"""


@pytest.mark.parametrize(
    ("scenario", "evaluations", "stage"),
    [("chopping-board", 10_000_000, "planning"), ("chopping-board", 1000, "planned"), ("arm-board", 1000, "executing")],
)
def test_ctrl_c_takes_effect_within_a_second(scenario, evaluations, stage):
    script = SCRIPT.format(scenario=scenario, evaluations=evaluations, stage=stage if stage != "executing" else "")
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert ended.returncode == 0, ended.stderr
    assert 0 <= float(ended.stdout) < 1.0


def test_ctrl_c_ends_the_program(program, tmp_path):
    command = [*program, "plan", "chopping-board", "--set", "plan.evaluations=10000000", "--out", "out"]
    child = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE)
    time.sleep(2.0)
    child.send_signal(signal.SIGINT)
    assert child.wait(timeout=5) in (-signal.SIGINT, 130)


def test_a_session_can_continue_after_ctrl_c(task, robot, exact):
    class Interrupted(type(exact)):
        is_first = True

        def execute(self, motion, sink):
            if self.is_first:
                self.is_first = False
                sink.many(
                    time_s=motion.time_s[:200],
                    world_from_tool=motion.world_from_tool[:200],
                    force_n=(motion.stroke[:200, None] >= 0) * self.reaction,
                )
                raise KeyboardInterrupt
            super().execute(motion, sink)

    executor = Interrupted(task.surface_reaction)
    session = task.session(robot)
    with pytest.raises(KeyboardInterrupt):
        session.run(executor)
    assert session.stage == "executed"
    [only] = session.run(executor)
    assert (only.ending, session.stage) == ("stopped", "ended")
