"""Follow the plan with your own robot, and check the motion."""

import wisch

task = wisch.load_task("arm-board")
robot = wisch.Robot.load("arm7")  # or the path of a URDF
session = task.session(robot)
motion, audit = session.follow(), session.audit()
print(f"{robot.name} wipes for {motion.contact_time_s:.0f} s")
print(f"{len(motion.abandoned)} nodes abandoned")
print(f"clearance {1e3 * audit.min_clearance_m:.0f} mm")
print(f"the check finds {len(audit.faults)} faults")
