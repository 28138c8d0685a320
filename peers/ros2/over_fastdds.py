"""Topics and services over Fast DDS, as rmw_fastrtps names and sends them, through the program `bridge`."""

import queue
import struct
import subprocess
import threading

import messages as m

FRAME = struct.Struct("<HI24s")
TOPIC = bytes(24)


def type_name(kind):
    return kind.__idl_typename__.replace(".", "::")


class Writer:
    def __init__(self, net, number):
        self.net, self.number = net, number

    def write(self, message, identity=TOPIC):
        self.net.send(self.number, identity, message.serialize())


class Network:
    """A participant. `request` names the request that a handler is answering."""

    def __init__(self, domain, is_local, bridge):
        command = [bridge, str(domain), *(["127.0.0.1"] if is_local else [])]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.writers, self.queues, self.has_begun, self.early = 0, [], False, []
        self.request = None

    def declare(self, role, name, kind, number):
        self.process.stdin.write(f"{role} {name} {type_name(kind)} {number}\n".encode())

    def writer(self, name, kind, latched=False, prefix="rt"):
        self.declare("writer", prefix + name, kind, int(latched))
        self.writers += 1
        return Writer(self, self.writers - 1)

    def server(self, name, key):
        request, response = m.service_types(key, with_header=False)
        self.declare("reader", f"rq{name}Request", request, 10)
        self.queues.append(queue.Queue())
        return self.queues[-1], self.writer(f"{name}Reply", response, prefix="rr"), request, response

    def send(self, number, identity, data):
        if not self.has_begun:
            # Endpoints are declared first.
            self.early.append((number, identity, data))
            return
        self.process.stdin.write(FRAME.pack(number, len(data), identity) + data)
        self.process.stdin.flush()

    def begin(self):
        self.process.stdin.write(b"begin\n")
        self.has_begun = True
        for frame in self.early:
            self.send(*frame)
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while header := self.process.stdout.read(FRAME.size):
            number, length, identity = FRAME.unpack(header)
            self.queues[number].put((identity, self.process.stdout.read(length)))

    def serve(self, server, handle):
        if not self.has_begun:
            self.begin()
        waiting, writer, request, response = server
        while not waiting.empty():
            identity, data = waiting.get()
            self.request = (writer, response, identity)
            answer = handle(request.deserialize(data))
            if answer is not None:
                self.reply(self.request, answer)

    def reply(self, request, answer):
        writer, response, identity = request
        writer.write(response(**answer), identity)
