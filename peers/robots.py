"""Sets up public robots from their URDFs alone, lets each wipe a shipped task, and prints a table of the results.

    pip install example-robot-data rtb-data
    git clone https://github.com/RobotLocomotion/models
    git clone https://github.com/ros-industrial/abb
    git clone https://github.com/Kinovarobotics/ros_kortex
    git clone https://github.com/frankarobotics/franka_description
    git clone https://github.com/UniversalRobots/Universal_Robots_ROS2_Description ur_description
    xacro ur_description/urdf/ur.urdf.xacro name:=ur5e ur_type:=ur5e > ur5e.urdf    # and ur10e, fr3, gen3 in the same way
    cargo build --release --locked
    python peers/robots.py SITE-PACKAGES .

The arguments are folders that contain the packages: the folder site-packages for those of pip, or a folder into which their wheels are
unpacked. For each robot of ROBOTS that is found, the script runs the commands that a new user would type: `wisch robot setup` with the
task, `wisch robot check` and `wisch run`. A fixed arm stands where the arm of the task stands; two arms stand farther from the board. A
robot on wheels is set up with --mobile, and wisch chooses its base pose. Nothing else is adapted to a robot.

The table shows the nodes of the plan that the robot does not reach, how it holds the tool, and the true performance in simulation.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# An elbow that bends by 120 degrees only needs more room than the arm of the task, which stands at -0.45 m.
FARTHER = ["--set", "robot.position_m=[0, -0.6, 0.75]"]

# Name, end of the URDF's path, task, further arguments: --mobile of setup, --set of setup and run.
ROBOTS = [
    ("UR3", "ur_description/urdf/ur3_robot.urdf", "arm-board", []),
    ("UR5", "ur_description/urdf/ur5_robot.urdf", "arm-board", []),
    ("UR10", "ur_description/urdf/ur10_robot.urdf", "arm-board", []),
    ("Panda", "panda_description/urdf/panda.urdf", "arm-board", []),
    ("xArm7", "xarm_description/urdf/xarm7.urdf", "arm-board", []),
    ("Z1", "z1_description/urdf/z1.urdf", "arm-board", []),
    ("Kinova Gen2", "kinova_description/robots/kinova.urdf", "arm-board", []),
    ("Jaco 7", "jaco_description/urdf/j2s7s300.urdf", "arm-board", []),
    ("iiwa14", "iiwa_description/urdf/iiwa14_primitive_collision.urdf", "arm-board", FARTHER),
    ("iiwa14 R820", "kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf", "arm-board", FARTHER),
    ("UR5e", "ur5e.urdf", "arm-board", []),
    ("UR10e", "ur10e.urdf", "arm-board", []),
    ("FR3", "fr3.urdf", "arm-board", []),
    ("Gen3", "gen3.urdf", "arm-board", []),
    ("IRB 2400", "abb_irb2400_support/urdf/irb2400.urdf", "arm-board", []),
    ("IRB 140", "abb_irb140_description/urdf/irb140.urdf", "arm-board", []),
    ("Puma 560", "unimation_puma560_description/urdf/puma560_robot.urdf", "arm-board", []),
    ("TIAGo", "tiago_description/robots/tiago.urdf", "chopping-board", ["--mobile"]),
    ("TIAGo Pro", "tiago_pro_description/robots/tiago_pro.urdf", "chopping-board", ["--mobile"]),
    ("PR2", "example-robot-data/robots/pr2_description/urdf/pr2.urdf", "chopping-board", ["--mobile"]),
    ("Baxter", "baxter_description/urdf/baxter.urdf", "chopping-board", ["--mobile"]),
    ("Talos", "talos_data/robots/talos_reduced.urdf", "chopping-board", ["--mobile"]),
]


def find(folders, end):
    """Returns the file below the folders whose path ends with a name; None if there is none."""
    name = pathlib.PurePath(end).name
    found = (path for folder in folders for path in sorted(folder.rglob(name)))
    return next((path for path in found if path.as_posix().endswith(end)), None)


def packages(urdf, folders):
    """Arguments that name the packages of a URDF: folders of their names with its files, or a folder above it."""
    parts = urdf.read_text(errors="replace").split("package://")[1:]
    files = [part.split('"')[0].lstrip("/") for part in parts]
    given = []
    for name in sorted({file.split("/")[0] for file in files}):
        own = [file for file in files if file.startswith(name + "/")]
        above = (parent.parent for parent in urdf.parents if parent.name == name)
        below = (path.parent for folder in folders for path in sorted(folder.rglob(name)))
        place = next((place for place in (*above, *below) if any((place / file).is_file() for file in own)), None)
        folder = place / name if place else None
        if not folder:
            # A copy of the package under another name.
            rests = [file.split("/", 1)[1] for file in own]
            folder = next((parent for parent in urdf.parents if any((parent / rest).is_file() for rest in rests)), None)
        if folder:
            given += ["--package", f"{name}={folder.resolve()}"]
    return given


def wisch(program, arguments, folder, timeout):
    """Runs wisch in a folder: the object that it prints, and the error, if it did not do its work."""
    command = [program, *arguments, "--json"]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return {}, f"not done after {timeout:.0f} s"
    lines = done.stdout.strip().splitlines()
    record = json.loads(lines[-1]) if lines else {}
    errors = [line.removeprefix("error: ") for line in done.stderr.splitlines() if line.startswith("error: ")]
    return record, errors[-1] if errors else record.get("problem")


def try_robot(program, urdf, folders, task, options, timeout):
    """The cells of a robot's row, and whether it met the goal."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(urdf, folder)
        given = packages(urdf, folders)
        setup, error = wisch(program, ["robot", "setup", urdf.name, "--task", task, *options, *given], folder, timeout)
        if error:
            return [f"setup: {error}"] + [""] * 5, False
        check, _ = wisch(program, ["robot", "check", urdf.name, *given], folder, timeout)
        arm = next(iter(setup["groups"]))
        cells = [f"{arm['name']} to {arm['tip']}", f"{check.get('errors')}, {check.get('warnings')}"]
        settings = [option for option in options if option != "--mobile"]
        ran, error = wisch(program, ["run", task, "--robot", urdf.name, *settings, *given], folder, timeout)
        if error or not ran:
            return [*cells, f"run: {error}", "", "", ""], False
        left_out = str(ran["abandoned_nodes"])
        why = f": {ran['first_obstruction']}" if ran["first_obstruction"] else ""
        true = ran.get("final_true")
        wiped = "nothing was wiped" if true is None else f"{100 * true:.1f} %"
        return [*cells, left_out + why, ran["mount"], wiped, "yes" if ran["goal_met"] else "no"], ran["goal_met"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders that contain the packages")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "target/release/wisch")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="names of the robots to try")
    parser.add_argument("--timeout", type=float, default=600, help="longest time of one command [s]")
    args = parser.parse_args()
    program = args.program.resolve()
    head = ["robot", "task", "group", "errors, warnings", "nodes left out", "tool held", "really wiped", "goal met"]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    met = tried = 0
    for name, end, task, options in ROBOTS:
        if args.only and name not in args.only:
            continue
        urdf = find(args.folders, end)
        if urdf is None:
            print(f"{name}: no {end} below the folders", file=sys.stderr)
            continue
        cells, is_met = try_robot(program, urdf.resolve(), args.folders, task, options, args.timeout)
        print("| " + " | ".join([name, task, *(cell.replace("|", "/") for cell in cells)]) + " |", flush=True)
        met += is_met
        tried += 1
    print(f"\n{met} of {tried} robots meet the goal.")


if __name__ == "__main__":
    main()
