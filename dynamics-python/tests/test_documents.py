"""The programs in documents run, one after the other in each of them.

Programs without this package, of text that the command writes, are run by `dynamics-cli/tests/documents.rs`.
"""

import os
import re
import shutil
from pathlib import Path

import pytest

from conftest import DATA

ROOT = Path(__file__).parents[2]


def programs(text: str) -> list[str]:
    found = re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)
    assert len(found) == text.count("```python"), "a block of another form"
    return found


def documents(*, with_casadi: bool) -> list[str]:
    """Those whose programs use this package, either beside CasADi or without it."""
    chapters = sorted((ROOT / "docs/guide/src").glob("*.md"))
    paths = [ROOT / "dynamics-python/README.md", *chapters]
    joined = {path: "".join(programs(path.read_text())) for path in paths}
    return [
        str(path.relative_to(ROOT))
        for path, program in joined.items()
        if "import robot_dynamics" in program and ("import casadi" in program) == with_casadi
    ]


@pytest.mark.parametrize("document", documents(with_casadi=False))
def test_programs_in_documents_run(
    document: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robots = [DATA / "urdf/panda.urdf", ROOT / "examples/robots/picker.urdf"]
    for robot in robots:
        shutil.copy(robot, tmp_path)
    monkeypatch.chdir(tmp_path)
    found = programs((ROOT / document).read_text())
    names: dict[str, object] = {}
    for number, program in enumerate(found):
        exec(compile(program, f"{document}, program {number + 1}", "exec"), names)
    assert sorted(os.listdir(tmp_path)) == [robot.name for robot in robots]


def test_documents_are_found() -> None:
    found = documents(with_casadi=False)
    assert {"dynamics-python/README.md", "docs/guide/src/python.md"} <= set(found)
    # `test_casadi.py` runs it.
    assert documents(with_casadi=True) == ["docs/guide/src/optimal_control.md"]
