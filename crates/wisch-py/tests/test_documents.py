"""Examples, notebooks, stubs and docstrings."""

import ast
import doctest
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import wisch
import wisch._wisch
import wisch.executor
import wisch.gym

HERE = Path(__file__).parent
EXAMPLES = sorted((HERE.parent / "examples").glob("0*.py"))
DOCS = HERE.parents[2] / "docs"
NOTEBOOKS = sorted((DOCS / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("example", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_an_example_runs_and_equals_the_text_in_the_document(example, tmp_path):
    ended = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout
    # The first line is a heading in the document.
    body = example.read_text().split("\n", 2)[2].strip()
    assert f"```python\n{body}\n```" in (DOCS / "python.md").read_text(), f"docs/python.md does not show {example.name}"


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def test_a_notebook_runs(notebook, tmp_path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    book = nbformat.read(notebook, as_version=4)
    assert all(not cell.get("outputs") for cell in book.cells), "outputs are not committed"
    nbclient.NotebookClient(book, timeout=120, resources={"metadata": {"path": tmp_path}}).execute()
    shown = [kind for cell in book.cells for output in cell.get("outputs", []) for kind in output.get("data", {})]
    assert {"image/svg+xml", "text/html"} & set(shown), "no picture and no table"


def test_there_are_three_notebooks():
    assert len(NOTEBOOKS) == 3 and len(EXAMPLES) == 6


@pytest.mark.parametrize("module", [wisch, wisch._task, wisch.gym], ids=lambda module: module.__name__)
def test_examples_in_docstrings_run(module):
    failed, tried = doctest.testmod(module)
    assert tried and not failed


def read_stubs():
    """Return the members of each class; the functions are under None."""
    tree = ast.parse((Path(wisch.__file__).parent / "_wisch.pyi").read_text())
    members = {None: {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}}
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and hasattr(wisch._wisch, node.name):
            members[node.name] = {part.name: part for part in node.body if isinstance(part, ast.FunctionDef)}
    return members


def test_stubs_have_the_members_of_the_module():
    typed = read_stubs()
    for name, thing in vars(wisch._wisch).items():
        if inspect.isclass(thing):
            public = {n for n in vars(thing) if not n.startswith("_") or n in ("_repr_svg_", "_repr_html_")}
            written = {n for n in typed[name] if not n.startswith("__")}
            assert written == public, name
        elif callable(thing) and not name.startswith("__"):
            assert name in typed[None]


def test_stubs_have_the_arguments_of_the_module():
    for owner, members in read_stubs().items():
        for name, node in members.items():
            if any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list) or name.startswith("__"):
                continue
            thing = getattr(getattr(wisch._wisch, owner) if owner else wisch._wisch, name)
            signature = [p for p in inspect.signature(thing).parameters if p != "self"]
            arguments = [a.arg for a in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs] if a.arg != "self"]
            arguments += [node.args.kwarg.arg] if node.args.kwarg else []
            assert arguments == signature, f"{owner}.{name}"


def test_public_members_are_documented():
    typed = read_stubs()
    for name in wisch.__all__:
        thing = getattr(wisch, name)
        assert inspect.getdoc(thing) or name in typed, name
    shapes = re.findall(r"\(\w+(?:, \w+)*\)", (Path(wisch.__file__).parent / "_wisch.pyi").read_text())
    assert len(shapes) > 60


def test_import_is_quick():
    script = "import sys, time; t = time.perf_counter(); import wisch; print(time.perf_counter() - t, 'gymnasium' in sys.modules)"
    times = []
    for _ in range(3):
        seconds, gym = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.split()
        assert gym == "False"
        times.append(float(seconds))
    print(f"import takes {min(times):.3f} s")
