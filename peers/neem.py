"""Opens a NEEM of wisch, and its ontology, with independent libraries, and checks both.

    cargo run --release --workspace --example synthetic_neem -- /tmp/neem 20
    python peers/neem.py /tmp/neem

or, with episodes in a memory,

    wisch memory export --neem /tmp/neem
    python peers/neem.py /tmp/neem

Documents are read with pymongo's bson, the ontology with rdflib; closures are computed from the OWL
files. Then the script plants faults one by one, and checks that it finds each.
"""

import copy
import json
import math
import sys
from collections import Counter, defaultdict
from datetime import datetime
from pathlib import Path

import bson
from rdflib import OWL, RDF, RDFS, XSD, Graph, Literal, Namespace, URIRef

ROOT = Path(__file__).resolve().parent.parent
SEMCO = Namespace("https://wisch-project.org/ont/semco.owl#")
SOMA = Namespace("http://www.ease-crc.org/ont/SOMA.owl#")
DUL = Namespace("http://www.ontologydesignpatterns.org/ont/dul/DUL.owl#")
COLLECTIONS = ["triples", "annotations", "inferred", "tf", "wrench"]
META = "_id name description created_by created_at url model_version keywords activity environment agent image visibility"
KINDS = [OWL.Class, OWL.ObjectProperty, OWL.DatatypeProperty, OWL.NamedIndividual]


def ontology():
    graph = Graph()
    for name in ("upper.owl", "semco.owl"):
        graph.parse(ROOT / "ontology" / name, format="xml")
    return graph


def ontology_faults(graph):
    """What is wrong with the ontology: labels, parents, domains, circles."""
    own = {s for kind in KINDS for s in graph.subjects(RDF.type, kind) if s.startswith(SEMCO)}
    if len(own) < 100:
        yield f"only {len(own)} names"
    for name in own:
        for said in (RDFS.label, RDFS.comment):
            if len(list(graph.objects(name, said))) != 1:
                yield f"{name} has not one {said}"
        kind = next(kind for kind in KINDS if (name, RDF.type, kind) in graph)
        above = RDFS.subClassOf if kind in (OWL.Class, OWL.NamedIndividual) else RDFS.subPropertyOf
        start = set(graph.objects(name, RDF.type)) - set(KINDS) if kind == OWL.NamedIndividual else {name}
        upper = {top for first in start for top in graph.transitive_objects(first, above)}
        if not any(str(top).startswith((str(SOMA), str(DUL))) for top in upper):
            yield f"{name} has no ancestor in SOMA or DUL"
        if kind in (OWL.ObjectProperty, OWL.DatatypeProperty):
            for said in (RDFS.domain, RDFS.range):
                if len(list(graph.objects(name, said))) != 1:
                    yield f"{name} has not one {said}"
        for parent in graph.objects(name, above):
            if name in graph.transitive_objects(parent, above):
                yield f"{name} lies below itself"


def documents(neem, collection):
    folder = neem / collection / "roslog"
    metadata = json.loads((folder / f"{collection}.metadata.json").read_text())
    assert metadata["collectionName"] == collection, metadata
    with open(folder / f"{collection}.bson", "rb") as file:
        yield from bson.decode_file_iter(file)


class Checker:
    """Checks triple documents one by one, then what they say together."""

    def __init__(self, graph):
        self.graph = graph
        self.closures = {}
        self.seen = set()
        self.statements = Graph()
        self.counts = Counter()

    def closure(self, iri, property_):
        if iri not in self.closures:
            node = URIRef(iri)
            above = RDFS.subPropertyOf if property_ else RDFS.subClassOf
            self.closures[iri] = {str(top) for top in self.graph.transitive_objects(node, above)}
        return self.closures[iri]

    def faults(self, document):
        s, p, o = document["s"], document["p"], document["o"]
        self.counts["triples"] += 1
        if not isinstance(document["_id"], bson.ObjectId) or document["_id"] in self.seen:
            yield f"{document['_id']} is not its own"
        self.seen.add(document["_id"])
        if document["graph"] != "wiping":
            yield f"graph is {document['graph']}"
        time = document["scope"]["time"]
        since, until = time["since"], time["until"]
        if type(since) is not float or type(until) is not float or not since <= until:
            yield f"{s}: scope from {since!r} to {until!r}"
        property_closure = document["p*"]
        if property_closure[0] != p or set(property_closure) != self.closure(p, True) or len(
            set(property_closure)
        ) != len(property_closure):
            yield f"{p}: p* is {property_closure}"
        names_term = URIRef(p) in (RDF.type, RDFS.subClassOf, RDFS.subPropertyOf)
        if names_term != ("o*" in document):
            yield f"{s}: o* where there should be none, or none where it should be"
        elif names_term:
            of_property = URIRef(p) == RDFS.subPropertyOf
            if document["o*"][0] != o or set(document["o*"]) != self.closure(o, of_property):
                yield f"{s} {p} {o}: o* is {document['o*']}"
        for iri in [s, p] + property_closure + document.get("o*", []):
            if " " in iri or "://" not in iri:
                yield f"{iri!r} is no IRI"
        yield from self.object_faults(document)

    def object_faults(self, document):
        """Object properties lead to IRIs, data properties to doubles or texts."""
        s, p, o = URIRef(document["s"]), URIRef(document["p"]), document["o"]
        literal = (p, RDF.type, OWL.DatatypeProperty) in self.graph or p == RDFS.label
        if (p, RDF.type, OWL.DatatypeProperty) in self.graph:
            wanted = str if self.graph.value(p, RDFS.range) == XSD.string else float
            if type(o) is not wanted:
                yield f"{s} {p}: {o!r} is no {wanted.__name__}"
        if literal:
            self.statements.add((s, p, Literal(o)))
        elif isinstance(o, str) and "://" in o:
            self.statements.add((s, p, URIRef(o)))
        else:
            yield f"{s} {p}: {o!r} is no IRI"
        if p == DUL.executesTask:
            self.counts["tasks"] += 1
            if o.count("_") != 1:
                yield f"the task {o} has not one underscore: a timeline does not show it"

    def faults_together(self):
        graph = self.statements
        for event, interval in graph.subject_objects(DUL.hasTimeInterval):
            begin, end = graph.value(interval, SOMA.hasIntervalBegin), graph.value(interval, SOMA.hasIntervalEnd)
            if begin is None or end is None or not begin.datatype == end.datatype == XSD.double:
                yield f"{event} is from {begin!r} to {end!r}"
            elif not begin.toPython() <= end.toPython():
                yield f"{event} ends at {end} before it begins at {begin}"
            self.counts["intervals"] += 1
        for part, whole in graph.subject_objects(SEMCO.isStepOf):
            if not any((whole, has, part) in graph for has in (DUL.hasConstituent, DUL.includesAction, DUL.includesEvent)):
                yield f"{whole} does not have {part}"
        for event, region in graph.subject_objects(SEMCO.hasPeakForce):
            force, peak = graph.value(region, SOMA.hasForceValue), graph.value(event, SEMCO.peakForce)
            if force is None or force != peak or (region, RDF.type, SOMA.NetForce) not in graph:
                yield f"{event}: its force {peak} is {force} as a region"
            self.counts["forces"] += 1
        for subject in set(graph.subjects()):
            if subject.startswith(SEMCO) and not any(graph.objects(subject, RDF.type)):
                yield f"{subject} has no type"


def question(neem, checker):
    """All collisions with their times: by closures as KnowRob asks MongoDB, and by SPARQL over the triples."""
    of_class = {
        document["s"]
        for document in documents(neem, "triples")
        if document["p"] == str(RDF.type) and str(SEMCO.Collision) in document.get("o*", [])
    }
    together = checker.statements + checker.graph
    rows = together.query(
        """SELECT ?event ?begin WHERE { ?event a/rdfs:subClassOf* semco:Collision ;
             dul:hasTimeInterval/soma:hasIntervalBegin ?begin }""",
        initNs={"semco": SEMCO, "dul": DUL, "soma": SOMA, "rdfs": RDFS},
    )
    by_sparql = {str(row.event) for row in rows}
    assert of_class == by_sparql, of_class ^ by_sparql
    return len(of_class)


def tf_faults(neem):
    """Poses as ROS writes transforms, in the order of their times, with unit quaternions."""
    last, count, shortest = {}, 0, math.inf
    for document in documents(neem, "tf"):
        count += 1
        header, transform = document["header"], document["transform"]
        frame, stamp = document["child_frame_id"], header["stamp"]
        if not isinstance(stamp, datetime) or document["__recorded"] != stamp or document["__topic"] != "tf":
            yield f"{frame}: stamp {stamp!r}"
        if frame in last:
            shortest = min(shortest, (stamp - last[frame]).total_seconds())
        last[frame] = stamp
        size = math.sqrt(sum(transform["rotation"][axis] ** 2 for axis in "xyzw"))
        if abs(size - 1) > 1e-6 or not all(math.isfinite(transform["translation"][axis]) for axis in "xyz"):
            yield f"{frame} at {stamp}: {transform}"
        if "/" in frame or "#" in frame or not header["frame_id"]:
            yield f"frame {frame!r} in {header['frame_id']!r}"
    if shortest <= 0:
        yield f"two poses of a frame are {shortest} s apart"
    print(f"tf: {count} poses of {len(last)} frames, at least {shortest} s apart")


def planted(graph, good):
    """Faults, one by one, of documents that are good: what was changed, and the documents."""
    def changed(what, index, change):
        bad = copy.deepcopy(good)
        change(bad[index])
        return what, bad

    def first(predicate, subject=""):
        return next(i for i, d in enumerate(good) if d["p"] == str(predicate) and subject in d["s"])

    typed = first(RDF.type, "WipingRound_")
    part = first(DUL.hasConstituent)
    number = first(SOMA.hasIntervalBegin)
    task = first(DUL.executesTask)
    yield changed("a class less above", typed, lambda d: d["o*"].pop())
    yield changed("a class more above", typed, lambda d: d["o*"].append(str(DUL.Quality)))
    yield changed("no closure of a class", typed, lambda d: d.pop("o*"))
    yield changed("a property less above", part, lambda d: d["p*"].pop())
    yield changed("another graph", part, lambda d: d.update(graph="user"))
    yield changed("a scope that ends before it begins", part, lambda d: d["scope"]["time"].update(until=-1.0))
    yield changed("a scope in whole seconds", part, lambda d: d["scope"]["time"].update(since=1))
    yield changed("a time as text", number, lambda d: d.update(o=str(d["o"])))
    yield changed("a time that ends before it begins", number, lambda d: d.update(o=9e9))
    yield changed("a task with two underscores", task, lambda d: d.update(o=d["o"] + "_2"))
    yield changed("a document twice", part, lambda d: d.update(_id=good[0]["_id"]))
    yield changed("a whole without its part", part, lambda d: d.update(o=str(SEMCO.sponge)))
    without = first(SOMA.hasIntervalEnd)
    yield "an interval without end", good[:without] + good[without + 1 :]
    forces = [i for i, d in enumerate(good) if d["p"] == str(SOMA.hasForceValue) and d["s"].endswith("peak")]
    if forces:
        yield changed("another force", forces[0], lambda d: d.update(o=d["o"] + 1.0))


def all_faults(graph, triples):
    checker = Checker(graph)
    found = [fault for document in triples for fault in checker.faults(document)]
    return found + list(checker.faults_together())


def report(what, faults):
    faults = list(faults)
    for fault in faults[:10]:
        print(f"FAULT in {what}: {fault}")
    return len(faults)


def main(neem):
    graph = ontology()
    wrong = report("the ontology", ontology_faults(graph))
    assert (neem / "semco.owl").read_bytes() == (ROOT / "ontology" / "semco.owl").read_bytes()
    meta = json.loads((neem / "meta.json").read_text())
    assert set(meta) == set(META.split()), set(meta) ^ set(META.split())
    assert len(meta["_id"]["$oid"]) == 24 and datetime.fromisoformat(meta["created_at"]), meta

    checker = Checker(graph)
    per_episode = defaultdict(list)
    for document in documents(neem, "triples"):
        wrong += report("a triple", checker.faults(document))
        name = document["s"].rsplit("#", 1)[-1]
        episode = name.split("_", 1)[-1].rsplit("-", 1)[0] if "_" in name and "-" in name else ""
        if len(per_episode) < 3 or episode in per_episode:
            per_episode[episode].append(document)
    wrong += report("the triples", checker.faults_together())
    print(f"triples: {dict(checker.counts)}, {len(checker.statements)} different")
    print(f"collisions by closure and by SPARQL: {question(neem, checker)}")
    for document in documents(neem, "annotations"):
        assert set(document) == {"_id", "s", "p", "v"} and document["p"] == str(RDFS.comment), document
    wrong += report("tf", tf_faults(neem))
    wrenches = 0
    for document in documents(neem, "wrench"):
        wrenches += 1
        numbers = [document["wrench"][part][axis] for part in ("force", "torque") for axis in "xyz"]
        assert len(numbers) == 6 and isinstance(document["header"]["stamp"], datetime), document
    print(f"wrenches: {wrenches}, inferred: {len(list(documents(neem, 'inferred')))}")

    one = next(documents_ for episode, documents_ in per_episode.items() if episode)
    assert not all_faults(graph, one), all_faults(graph, one)[:3]
    kinds = 0
    for what, bad in planted(graph, one):
        kinds += 1
        if not all_faults(graph, bad):
            print(f"NOT FOUND: {what}")
            wrong += 1
    print(f"{kinds} kinds of planted faults tried")
    print("all is well" if not wrong else f"{wrong} faults")
    return wrong != 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
