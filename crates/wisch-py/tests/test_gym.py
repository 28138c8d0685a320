"""The environment: Gymnasium's own checks, seeds, many worlds, and the baselines."""

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


def test_it_is_known_by_the_name_of_its_module():
    script = "import gymnasium; env = gymnasium.make('wisch.gym:wisch/Wiping-v0'); print(env.reset(seed=1)[0]['density'].sum())"
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert float(ended.stdout) == pytest.approx(1.0, abs=1e-5)


def test_the_same_seed_is_the_same_episode_and_another_is_another():
    def played(seed):
        env = wisch.gym.WipingEnv()
        policy = wisch.gym.RandomPolicy(env, seed=1)
        seen = [env.reset(seed=seed)[0]["density"]]
        for _ in range(40):
            observation, reward, terminated, truncated, _ = env.step(policy(None))
            seen.append(observation["density"] * (1 + reward))
            if terminated or truncated:
                seen.append(env.reset()[0]["density"])
        return np.array(seen)

    np.testing.assert_array_equal(played(3), played(3))
    assert (played(3) != played(4)).any()


def test_many_worlds_are_as_many_single_ones():
    count, steps = 5, 70
    many = gymnasium.make_vec("wisch/Wiping-v0", num_envs=count, particles=20, max_strokes=9)
    single = [wisch.gym.WipingEnv(particles=20, max_strokes=9) for _ in range(count)]
    seen, _ = many.reset(seed=11)
    alone = [env.reset(seed=11 + i)[0] for i, env in enumerate(single)]
    over = [False] * count
    random = np.random.default_rng(2)
    for _ in range(steps):
        for i in range(count):
            np.testing.assert_array_equal(seen["density"][i], alone[i]["density"])
            np.testing.assert_array_equal(seen["tool"][i], alone[i]["tool"])
        actions = random.uniform(-1, 1, (count, 5)).astype(np.float32)
        seen, rewards, terminated, truncated, _ = many.step(actions)
        for i, env in enumerate(single):
            if over[i]:
                alone[i], over[i] = env.reset()[0], False
                assert rewards[i] == 0 and not terminated[i] and not truncated[i]
            else:
                alone[i], reward, *ended, _ = env.step(actions[i])
                over[i] = any(ended)
                assert (rewards[i], terminated[i], truncated[i]) == (reward, *ended)
    assert many.observation_space.contains(seen)


def test_a_reward_is_what_is_gained_less_the_way():
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


def test_how_fast_it_is():
    """Told, not judged: how many strokes a second, of 1024 worlds with 100 particles."""
    env = wisch.gym.WipingVectorEnv(1024)
    env.reset(seed=1)
    actions = [env.action_space.sample() for _ in range(8)]
    begin = time.perf_counter()
    for k in range(16):
        env.step(actions[k % 8])
    print(f"{16 * 1024 / (time.perf_counter() - begin):.0f} steps/s")
