"""Measures round trips between wisch-ros2 and Cyclone DDS, and between two processes of Cyclone DDS, in turn.

    cargo build --manifest-path crates/wisch-ros2/Cargo.toml --target-dir target
    pip install cyclonedds==11.0.1 numpy
    python peers/ros2/link.py

A process of Cyclone DDS returns each joint state. The other side sends joint states at 1 kHz, and measures the time until it has
deserialised the echo. Medians are of alternating runs of 8 s. Finally, wisch-ros2 sends at 1 kHz for 60 s, and counts the lost
samples. The exit code is 1 if any is lost.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
DEPTH = 1000
PING, ECHO = "/wisch_ping", "/wisch_echo"


def wait_set(net, reader):
    from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState, WaitSet

    waiting = WaitSet(net.participant)
    waiting.attach(ReadCondition(reader, SampleState.Any | ViewState.Any | InstanceState.Any))
    return waiting


def endpoints(domain, read, written):
    import messages as m
    from over_cyclone import Network

    net = Network(domain)
    return net, net.reader(read, m.JointState, DEPTH), net.writer(written, m.JointState, depth=DEPTH)


def echo(domain):
    from cyclonedds.util import duration

    net, reader, writer = endpoints(domain, PING, ECHO)
    waiting = wait_set(net, reader)
    print("ready", flush=True)
    while True:
        waiting.wait(duration(milliseconds=200))
        for message in reader.take(N=100):
            if hasattr(message, "header"):
                writer.write(message)


def ping(domain, rate, seconds):
    import messages as m
    from cyclonedds.util import duration

    net, reader, writer = endpoints(domain, ECHO, PING)
    while not (writer.get_matched_subscriptions() and reader.get_matched_publications()):
        time.sleep(0.01)
    time.sleep(0.5)
    count = int(rate * seconds)
    sent, echoes, is_over = [0.0] * count, [None] * count, threading.Event()

    def listen():
        waiting = wait_set(net, reader)
        while not is_over.is_set():
            waiting.wait(duration(milliseconds=200))
            for message in reader.take(N=100):
                now = time.perf_counter()
                if hasattr(message, "header") and echoes[message.header.stamp.sec] is None:
                    echoes[message.header.stamp.sec] = now

    listener = threading.Thread(target=listen)
    listener.start()
    names, seven = [f"joint_{i}" for i in range(1, 8)], [0.1] * 7
    begin = time.perf_counter()
    for number in range(count):
        time.sleep(max(0.0, begin + number / rate - time.perf_counter()))
        sent[number] = time.perf_counter()
        writer.write(m.JointState(m.Header(m.Time(number, 0), ""), names, seven, seven, seven))
    time.sleep(1.0)
    is_over.set()
    listener.join()
    trips = sorted(1e6 * (b - a) for a, b in list(zip(sent, echoes))[count // 10 :] if b is not None)
    a, b, c = (trips[round(share * (len(trips) - 1))] for share in (0.5, 0.9, 0.99))
    lost = sum(echo is None for echo in echoes)
    print(f"sent {count}, lost {lost}; round trip median {a:.0f} us, 90 % {b:.0f} us, 99 % {c:.0f} us")


def compare(arguments):
    this = [sys.executable, __file__]
    peer = subprocess.Popen([*this, "--domain", str(arguments.domain), "echo"], stdout=subprocess.PIPE)
    peer.stdout.readline()
    try:
        with tempfile.TemporaryDirectory() as folder:
            robot = pathlib.Path(folder) / "robot.toml"
            link = f'domain = {arguments.domain}\ninterfaces = ["127.0.0.1"]'
            motion = 'action = "/a"\ncontrollers = ["a"]'
            robot.write_text(f'schema = 1\nurdf = "arm7"\n[link]\n{link}\n[motion]\n{motion}\n[force]\nkind = "none"\n')
            wisch = [arguments.program, "ping", str(robot)]
            cyclone = [*this, "--domain", str(arguments.domain), "ping"]

            def measure(name, command):
                text = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
                print(f"{name:28} {text}", flush=True)
                return [int(number) for number in re.findall(r"(?:lost|median) (\d+)", text)]

            medians = {"wisch-ros2": [], "Cyclone DDS": []}
            for _ in range(arguments.runs):
                for name, command in zip(medians, (wisch, cyclone)):
                    medians[name].append(measure(f"{name} to Cyclone DDS", command)[1])
            middle = {name: sorted(values)[len(values) // 2] for name, values in medians.items()}
            ours, theirs = middle.values()
            print(f"median of {arguments.runs} runs: wisch-ros2 {ours} us, Cyclone DDS {theirs} us; ratio {ours / theirs:.2f}")
            lost = measure(f"wisch-ros2, {arguments.seconds:.0f} s", [*wisch, "--seconds", str(arguments.seconds)])[0]
            return 1 if lost else 0
    finally:
        peer.kill()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="?", default="compare", choices=["compare", "echo", "ping"])
    parser.add_argument("--domain", type=int, default=79)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=60, help="duration of the last run [s]")
    parser.add_argument("--program", default=str(HERE.parent.parent / "target" / "debug" / "wisch-ros2"))
    arguments = parser.parse_args()
    if arguments.what == "echo":
        echo(arguments.domain)
    elif arguments.what == "ping":
        ping(arguments.domain, 1000.0, 8.0)
    else:
        sys.exit(compare(arguments))


if __name__ == "__main__":
    main()
