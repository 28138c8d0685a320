"""Topics and services over Cyclone DDS, as rmw_cyclonedds names and sends them."""

import os

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

import messages as m

# Loopback only, with multicast, which discovery needs.
CONFIG = """<CycloneDDS><Domain Id="any"><General><Interfaces><NetworkInterface name="lo" multicast="true"/></Interfaces>
<AllowMulticast>true</AllowMulticast></General></Domain></CycloneDDS>"""


def quality(latched=False, depth=10):
    durability = Policy.Durability.TransientLocal if latched else Policy.Durability.Volatile
    reliability = Policy.Reliability.Reliable(duration(milliseconds=100))
    # RMWs of ROS 2 send the first version of CDR.
    representation = Policy.DataRepresentation(use_cdrv0_representation=True)
    return Qos(reliability, durability, Policy.History.KeepLast(1 if latched else depth), representation)


class Network:
    """A participant. `request` names the request that a handler is answering."""

    def __init__(self, domain, is_local=True):
        if is_local:
            os.environ.setdefault("CYCLONEDDS_URI", CONFIG)
        self.participant = DomainParticipant(domain)
        self.request = None

    def writer(self, name, kind, latched=False, depth=10):
        return DataWriter(self.participant, Topic(self.participant, "rt" + name, kind), qos=quality(latched, depth))

    def reader(self, name, kind, depth=10):
        return DataReader(self.participant, Topic(self.participant, "rt" + name, kind), qos=quality(depth=depth))

    def server(self, name, key):
        request, response = m.service_types(key, with_header=True)
        reader = DataReader(self.participant, Topic(self.participant, f"rq{name}Request", request), qos=quality())
        writer = DataWriter(self.participant, Topic(self.participant, f"rr{name}Reply", response), qos=quality())
        return reader, writer, response

    def serve(self, server, handle):
        reader, writer, response = server
        for request in reader.take(N=8):
            # A sample without data reports that a writer has gone.
            if not hasattr(request, "client"):
                continue
            self.request = (writer, response, request.client, request.number)
            answer = handle(request)
            if answer is not None:
                self.reply(self.request, answer)

    def reply(self, request, answer):
        writer, response, client, number = request
        writer.write(response(client=client, number=number, **answer))
