"""Build a task from Python objects, plan it, and predict the effect of the plan on the dirt."""

import numpy as np
import wisch

crumbs = np.random.default_rng(1).uniform([-0.2, -0.14], [0.2, 0.14], (80, 2))
task = wisch.build_task(
    action="collect",
    tool="sponge",
    medium="breadcrumbs",
    surface={"name": "chopping_board", "size_m": [0.40, 0.28], "position_m": [0.0, 0.0, 0.75]},
    collect={"goal_m": [0.13, -0.08]},
    particles=crumbs,
    strategy="kde",
)
plan = task.session().plan()
print(f"{plan.strategy} places {len(plan.strokes)} strokes, {plan.contact_distance_m:.2f} m")
print(f"the first goes through {np.round(plan.strokes[0][:, :2], 2).tolist()}")
print(f"{100 * plan.predict().performance:.0f} % are predicted to be collected")
