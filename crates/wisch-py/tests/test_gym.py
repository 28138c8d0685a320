"""The environment: Gymnasium's checks, seeds, parallel worlds, and the baselines."""

import subprocess
import sys
import time
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import wisch.gym


def test_it_passes_gymnasiums_checker():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make("wisch/Wiping-v0").unwrapped, skip_render_check=True)


def test_the_name_with_the_module_needs_no_import():
    script = "import gymnasium; env = gymnasium.make('wisch.gym:wisch/Wiping-v0'); print(env.reset(seed=1)[0]['density'].sum())"
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert float(ended.stdout) == pytest.approx(1.0, abs=1e-5)


def test_the_seed_determines_the_episode():
    def play(seed):
        env = wisch.gym.WipingEnv()
        policy = wisch.gym.RandomPolicy(env, seed=1)
        observations = [env.reset(seed=seed)[0]["density"]]
        for _ in range(40):
            observation, reward, terminated, truncated, _ = env.step(policy(None))
            observations.append(observation["density"] * (1 + reward))
            if terminated or truncated:
                observations.append(env.reset()[0]["density"])
        return np.array(observations)

    np.testing.assert_array_equal(play(3), play(3))
    assert (play(3) != play(4)).any()


def test_parallel_worlds_equal_single_worlds():
    count, steps = 5, 70
    many = gymnasium.make_vec("wisch/Wiping-v0", num_envs=count, particles=20, max_strokes=9)
    single = [wisch.gym.WipingEnv(particles=20, max_strokes=9) for _ in range(count)]
    observation, _ = many.reset(seed=11)
    alone = [env.reset(seed=11 + i)[0] for i, env in enumerate(single)]
    over = [False] * count
    random = np.random.default_rng(2)
    for _ in range(steps):
        for i in range(count):
            np.testing.assert_array_equal(observation["density"][i], alone[i]["density"])
            np.testing.assert_array_equal(observation["tool"][i], alone[i]["tool"])
        actions = random.uniform(-1, 1, (count, 5)).astype(np.float32)
        observation, rewards, terminated, truncated, _ = many.step(actions)
        for i, env in enumerate(single):
            if over[i]:
                alone[i], over[i] = env.reset()[0], False
                assert rewards[i] == 0 and not terminated[i] and not truncated[i]
            else:
                alone[i], reward, *ended, _ = env.step(actions[i])
                over[i] = any(ended)
                assert (rewards[i], terminated[i], truncated[i]) == (reward, *ended)
    assert many.observation_space.contains(observation)


def test_the_reward_is_the_gain_minus_the_cost_of_the_path():
    env = wisch.gym.WipingEnv(particles=50, cost_per_m=0.5)
    env.reset(seed=1)
    low, high = env.worlds.reach
    middle, half = (low + high) / 2, (high - low) / 2
    start, end = np.array([-0.15, 0.1]), np.array([0.05, 0.1])
    before = env.worlds.performance[0]
    action = np.array([*(start - middle) / half, *(end - middle) / half, 0.0])
    _, reward, _, _, info = env.step(action)
    way = np.linalg.norm(start - env.task.tool_start) + 0.2
    assert reward == pytest.approx(info["performance"] - before - 0.5 * way)


def test_the_adaptive_policy_is_better_than_the_random_one():
    def mean(policy_of, episodes=3):
        performances = []
        env = gymnasium.make("wisch/Wiping-v0", particles=40)
        policy = policy_of(env)
        for episode in range(episodes):
            observation, info = env.reset(seed=1000 + episode)
            policy.reset()
            over = False
            while not over:
                observation, _, terminated, truncated, info = env.step(policy(observation))
                over = terminated or truncated
            performances.append(info["performance"])
        return np.mean(performances)

    random = mean(lambda env: wisch.gym.RandomPolicy(env, seed=1))
    adaptive = mean(lambda env: wisch.gym.AdaptivePolicy(env, evaluations=2000))
    print(f"random {random:.2f}, adaptive {adaptive:.2f}")
    assert adaptive > 0.7 and adaptive > random + 0.3


def test_wrong_actions_and_settings_are_refused():
    env = wisch.gym.WipingEnv()
    env.reset(seed=1)
    with pytest.raises(wisch.WischError, match=r"actions\[0, 2\]: expected a finite number, found NaN"):
        env.step(np.array([0, 0, np.nan, 0, 0]))
    with pytest.raises(wisch.WischError, match="particles: expected 1 to 100000, found 0"):
        wisch.gym.WipingEnv(particles=0)
    with pytest.raises(wisch.WischError, match="rows of the actions: expected 2, found 3"):
        wisch.gym.WipingVectorEnv(2).step(np.zeros((3, 5)))


def test_print_the_speed():
    """Prints the number of strokes per second in 1024 worlds with 100 particles; no value is too small."""
    env = wisch.gym.WipingVectorEnv(1024)
    env.reset(seed=1)
    actions = [env.action_space.sample() for _ in range(8)]
    begin = time.perf_counter()
    for k in range(16):
        env.step(actions[k % 8])
    print(f"{16 * 1024 / (time.perf_counter() - begin):.0f} steps/s")
