"""A robot for wisch-ros2 on another DDS: Cyclone DDS or Fast DDS, as the drivers of ROS 2 use them.

    pip install cyclonedds==11.0.1 numpy
    python peers/ros2/robot.py ROBOT.toml                          # on Cyclone DDS
    python peers/ros2/robot.py ROBOT.toml --fastdds peers/ros2/bridge

It serves the names of the robot file: joint states and wrench at 500 Hz, the controller's state, speed scaling, safety mode, the
controller manager, force mode, and the action FollowJointTrajectory. Services are sent as the RMW of the vendor sends them:
Cyclone DDS with a header in each message, Fast DDS with the identity of the request beside the message. For Fast DDS, the
program `bridge` of this folder passes the bytes on; `make -C peers/ros2` builds it. With `interfaces` in the robot file, the robot
is on loopback only; without them, the DDS has its default settings.

The arm follows its setpoints exactly and touches nothing. Commands on standard input:

    push X Y Z SECONDS     a force on the tool, in the axes of the base frame [N]
    scaling SHARE          speed scaling, 0 to 1
    safety NUMBER          safety mode; 1 is NORMAL
    home                   jump to the ready posture, if there is no goal
    silence | speak        stop sending joint states, and send them again
    quit                   end

It prints one line for each request, with the time of this computer's clock.
"""

import argparse
import math
import pathlib
import queue
import sys
import threading
import time
import tomllib
import xml.etree.ElementTree

import numpy

import messages as m

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PERIOD = 0.002
ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = 1, 2, 3, 4, 5, 6


def log(text):
    print(f"{time.time():.4f} {text}", flush=True)


def turn(axis, angle):
    """Rotation about an axis of length 1."""
    x, y, z = axis
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


class Arm:
    """Joints, ready posture and rotations of a URDF with its SRDF."""

    def __init__(self, urdf):
        tree = xml.etree.ElementTree.parse(urdf).getroot()
        numbers = lambda text: [float(word) for word in text.split()]
        self.joints = []
        for joint in tree.findall("joint"):
            origin, axis = joint.find("origin"), joint.find("axis")
            self.joints.append(
                (
                    joint.get("name"),
                    joint.get("type"),
                    joint.find("child").get("link"),
                    numbers(origin.get("rpy", "0 0 0")) if origin is not None else [0, 0, 0],
                    numbers(axis.get("xyz")) if axis is not None else [0, 0, 1],
                )
            )
        self.names = [name for name, kind, *_ in self.joints if kind in ("revolute", "continuous", "prismatic")]
        state = xml.etree.ElementTree.parse(urdf.with_suffix(".srdf")).getroot().find("group_state")
        ready = {joint.get("name"): float(joint.get("value")) for joint in state.findall("joint")}
        self.ready = [ready[name] for name in self.names]
        self.last_link = self.joints[-1][2]

    def base_from_link(self, positions, link):
        """Rotation of a link in the first link; the links are one chain."""
        rotation, values = numpy.eye(3), dict(zip(self.names, positions))
        for name, kind, child, (roll, pitch, yaw), axis in self.joints:
            rotation = rotation @ turn((0, 0, 1), yaw) @ turn((0, 1, 0), pitch) @ turn((1, 0, 0), roll)
            if kind in ("revolute", "continuous"):
                rotation = rotation @ turn(axis, values[name])
            if child == link:
                break
        return rotation


def quintic(p, v, a, q, w, b, span, time):
    """Value and velocity of the polynomial of fifth degree between two states, a span [s] apart."""
    s, v, w, a, b, d = time / span, v * span, w * span, a * span**2, b * span**2, q - p
    c = [p, v, a / 2, 10 * d - 6 * v - 4 * w - 1.5 * a + 0.5 * b]
    c += [-15 * d + 8 * v + 7 * w + 1.5 * a - b, 6 * d - 3 * v - 3 * w - 0.5 * a + 0.5 * b]
    value = sum(k * s**i for i, k in enumerate(c))
    return value, sum(i * k * s ** (i - 1) for i, k in enumerate(c) if i) / span


class Robot:
    """The topics, services and action of a robot file over a transport."""

    def __init__(self, file, arm, net):
        self.file, self.arm, self.net = file, arm, net
        motion, force, stop = file["motion"], file["force"], file.get("stop", {})
        distro = file.get("link", {}).get("ros_distro", "jazzy")
        topic = lambda name, kind, latched=False: net.writer(name, kind, latched) if name else None
        self.states = topic(motion.get("joint_states", "/joint_states"), m.JointState)
        self.wrench = topic(force.get("topic"), m.WrenchStamped)
        self.progress = topic(motion.get("progress"), m.JointTrajectoryControllerState)
        self.scaling_topic = topic(motion.get("scaling"), m.Float64)
        self.safety_topic = topic(stop.get("safety"), m.SafetyMode, True)
        self.program_topic = topic(stop.get("program"), m.Bool, True)
        action = motion["action"] + "/_action/"
        self.feedback = topic(action + "feedback", m.FeedbackMessage)
        self.status_topic = topic(action + "status", m.GoalStatusArray, True)
        self.services = [
            (net.server(action + "send_goal", "send_goal"), self.take_goal),
            (net.server(action + "get_result", "get_result"), self.take_result_request),
            (net.server(action + "cancel_goal", "cancel_goal"), self.take_cancel),
        ]
        manager = motion.get("controller_manager", "/controller_manager")
        self.services.append((net.server(manager + "/list_controllers", ("list", distro)), self.list_controllers))
        self.services.append((net.server(manager + "/switch_controller", ("switch", distro)), self.switch))
        if force.get("tare"):
            self.services.append((net.server(force["tare"], "trigger"), self.tare))
        if force["kind"] == "ur_force_mode":
            start = force.get("start", "/force_mode_controller/start_force_mode")
            end = force.get("stop", "/force_mode_controller/stop_force_mode")
            self.services.append((net.server(start, "force_mode"), self.start_force))
            self.services.append((net.server(end, "trigger"), self.stop_force))
        self.controller = m.ControllerOfJazzy if distro == "jazzy" else m.ControllerOfHumble
        self.is_jazzy = distro == "jazzy"
        self.active = set()
        self.positions, self.velocities = list(arm.ready), [0.0] * len(arm.ready)
        self.goal, self.knots, self.time, self.results, self.waiting = None, [], 0.0, {}, []
        self.scaling, self.safety, self.is_silent = 1.0, 1, False
        self.push, self.push_end = numpy.zeros(3), 0.0
        self.sensor = force.get("link") or arm.last_link
        self.safety_topic and self.safety_topic.write(m.SafetyMode(1))
        self.program_topic and self.program_topic.write(m.Bool(True))

    def header(self, frame=""):
        now = time.time()
        return m.Header(m.Time(int(now), int(now % 1 * 1e9)), frame)

    # Services.

    def take_goal(self, request):
        points = request.goal.trajectory.points
        order = [request.goal.trajectory.joint_names.index(name) for name in self.arm.names]
        accepted = bool(points) and self.goal is None and self.safety == 1
        if accepted:
            self.knots = [(0.0, [(q, 0.0, 0.0) for q in self.positions])]
            for p in points:
                at = p.time_from_start.sec + 1e-9 * p.time_from_start.nanosec
                self.knots.append((at, [(p.positions[i], p.velocities[i], p.accelerations[i]) for i in order]))
            self.goal, self.time = bytes(request.goal_id), 0.0
            self.publish_status(EXECUTING)
        log(f"goal with {len(points)} points of {self.knots[-1][0]:.2f} s {'accepted' if accepted else 'rejected'}")
        return {"accepted": accepted, "stamp": m.Time(0, 0)}

    def take_result_request(self, request):
        self.waiting.append((bytes(request.goal_id), self.net.request))

    def take_cancel(self, request):
        log("cancel")
        wanted = bytes(request.goal_info.goal_id)
        if self.goal is None or wanted not in (bytes(16), self.goal):
            return {"return_code": 2, "goals_canceling": []}
        info = m.GoalInfo(list(self.goal), m.Time(0, 0))
        self.publish_status(CANCELING)
        self.end(CANCELED, 0, "")
        return {"return_code": 0, "goals_canceling": [info]}

    def list_controllers(self, _):
        controllers = []
        for number, name in enumerate(self.file["motion"]["controllers"]):
            is_active = name in self.active
            claimed = [f"{joint}/position" for joint in self.arm.names] if is_active and number == 0 else []
            state = [name, "active" if is_active else "inactive", "peer/Controller"]
            state += [False, 500] if self.is_jazzy else []
            state += [claimed, [], [], False, False] + ([[]] if self.is_jazzy else []) + [[], []]
            controllers.append(self.controller(*state))
        return {"controller": controllers}

    def switch(self, request):
        log("activate " + " ".join(request.activate_controllers))
        self.active |= set(request.activate_controllers)
        self.active -= set(request.deactivate_controllers)
        return {"ok": True, "message": ""} if self.is_jazzy else {"ok": True}

    def tare(self, _):
        log("tare")
        return {"success": True, "message": ""}

    def start_force(self, request):
        log(f"force mode on, {-request.wrench.force.z:.2f} N, frame {request.task_frame.header.frame_id}")
        return {"success": True}

    def stop_force(self, _):
        log("force mode off")
        return {"success": True, "message": ""}

    # Motion.

    def publish_status(self, status):
        info = m.GoalInfo(list(self.goal), m.Time(0, 0))
        self.status_topic.write(m.GoalStatusArray([m.GoalStatus(info, status)]))

    def end(self, status, code, text):
        if self.goal is None:
            return
        log(f"goal ended with status {status}")
        self.publish_status(status)
        self.results[self.goal] = (status, m.Result(code, text))
        self.goal, self.velocities = None, [0.0] * len(self.positions)

    def advance(self, elapsed):
        """Follows the trajectory."""
        if self.goal is None:
            return
        scaling = self.scaling if self.safety == 1 else 0.0
        self.time += elapsed * scaling
        after = next((i for i, (at, _) in enumerate(self.knots) if at > self.time), None)
        if after is None:
            self.positions = [state[0] for state in self.knots[-1][1]]
            self.end(SUCCEEDED, 0, "")
            return
        (begin, before), (end, states) = self.knots[after - 1], self.knots[after]
        for i, (first, last) in enumerate(zip(before, states)):
            value, rate = quintic(*first, *last, end - begin, self.time - begin)
            self.positions[i], self.velocities[i] = value, rate * scaling

    def publish(self):
        """Sends joint state and wrench."""
        if not self.is_silent:
            efforts = [0.0] * len(self.positions)
            state = m.JointState(self.header(), self.arm.names, list(self.positions), list(self.velocities), efforts)
            self.states.write(state)
        if self.wrench:
            push = self.push if time.time() < self.push_end else numpy.zeros(3)
            force = self.arm.base_from_link(self.positions, self.sensor).T @ push if push.any() else push
            zero = m.Vector3(0.0, 0.0, 0.0)
            self.wrench.write(m.WrenchStamped(self.header(self.sensor), m.Wrench(m.Vector3(*map(float, force)), zero)))

    def publish_slowly(self):
        """Sends what the controller reports."""
        scaling = self.scaling if self.safety == 1 else 0.0
        full = self.file["motion"].get("full_scaling", 100.0)
        self.scaling_topic and self.scaling_topic.write(m.Float64(scaling * full))
        here, none, multi = m.point(self.positions, self.velocities, self.time), m.point(), m.no_multi()
        if self.progress:
            state = [self.header(), self.arm.names, here, here, none, none, [], multi, multi, multi, multi, scaling]
            self.progress.write(m.JointTrajectoryControllerState(*state))
        if self.goal is not None:
            content = m.Feedback(self.header(), self.arm.names, here, here, none, [], multi, multi, multi)
            self.feedback.write(m.FeedbackMessage(list(self.goal), content))

    def obey(self, line):
        words = line.split()
        if words:
            log("command " + line.strip())
        match words:
            case ["push", x, y, z, seconds]:
                self.push = numpy.array([float(x), float(y), float(z)])
                self.push_end = time.time() + float(seconds)
            case ["scaling", share]:
                self.scaling = float(share)
            case ["safety", mode]:
                self.safety = int(mode)
                self.safety_topic and self.safety_topic.write(m.SafetyMode(self.safety))
                if self.safety != 1:
                    self.end(ABORTED, -1, "safety stop")
            case ["home"] if self.goal is None:
                self.positions = list(self.arm.ready)
            case ["silence" | "speak" as what]:
                self.is_silent = what == "silence"

    def answer(self):
        for server, handle in self.services:
            self.net.serve(server, handle)
        for wanted, request in list(self.waiting):
            if wanted in self.results:
                self.waiting.remove((wanted, request))
                status, result = self.results[wanted]
                self.net.reply(request, {"status": status, "result": result})

    def run(self, commands):
        log("ready: " + ", ".join(self.arm.names))
        due, turned, number = time.perf_counter(), time.perf_counter(), 0
        while True:
            now = time.perf_counter()
            self.advance(now - turned)
            turned = now
            self.answer()
            self.publish()
            if number % 10 == 0:
                self.publish_slowly()
                while not commands.empty():
                    line = commands.get()
                    if line.strip() == "quit":
                        return
                    self.obey(line)
            number += 1
            due = max(due + PERIOD, time.perf_counter() - 5 * PERIOD)
            time.sleep(max(0.0, due - time.perf_counter()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robot", type=pathlib.Path, help="the robot file")
    parser.add_argument("--fastdds", metavar="BRIDGE", help="the program `bridge`, for Fast DDS in place of Cyclone DDS")
    arguments = parser.parse_args()
    file = tomllib.loads(arguments.robot.read_text())
    urdf = file["urdf"]
    path = arguments.robot.parent / urdf if "." in urdf or "/" in urdf else ROOT / "robots" / f"{urdf}.urdf"
    domain, is_local = file["link"]["domain"], "interfaces" in file["link"]
    if arguments.fastdds:
        from over_fastdds import Network

        net = Network(domain, is_local, arguments.fastdds)
    else:
        from over_cyclone import Network

        net = Network(domain, is_local)
    commands = queue.Queue()
    threading.Thread(target=lambda: [commands.put(line) for line in sys.stdin], daemon=True).start()
    Robot(file, Arm(path), net).run(commands)


if __name__ == "__main__":
    main()
