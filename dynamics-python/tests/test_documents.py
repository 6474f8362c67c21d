"""The programs in documents run, one after the other in each of them."""

import os
import re
import shutil
from pathlib import Path

import pytest

from conftest import DATA

ROOT = Path(__file__).parents[2]

DOCUMENTS = ["dynamics-python/README.md", "docs/guide/src/python.md"]


def programs(text: str) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("document", DOCUMENTS)
def test_programs_in_documents_run(
    document: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(DATA / "urdf" / "panda.urdf", tmp_path)
    monkeypatch.chdir(tmp_path)
    found = programs((ROOT / document).read_text())
    assert found
    names: dict[str, object] = {}
    for number, program in enumerate(found):
        exec(compile(program, f"{document}, program {number + 1}", "exec"), names)
    assert os.listdir(tmp_path) == ["panda.urdf"]
