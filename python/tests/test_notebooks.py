"""The notebooks run from beginning to end, and are committed without outputs."""

import json
import os
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "examples" / "notebooks").glob("*.ipynb"))


def test_there_are_four() -> None:
    assert len(NOTEBOOKS) == 4


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: str(file.stem))
def test_notebook(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for cell in json.loads(file.read_text())["cells"]:
        assert not cell.get("outputs") and cell.get("execution_count") is None
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    for name in ["ipykernel", "matplotlib", "pandas", "polars", "scipy", "xarray"]:
        pytest.importorskip(name)
    monkeypatch.setitem(os.environ, "MPLBACKEND", "agg")
    notebook = nbformat.read(file, as_version=4)
    client = nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": file.parent}})
    client.execute()
    kinds = [kind for cell in notebook.cells for output in cell.get("outputs", []) for kind in output.get("data", {})]
    shown = {"1-figure-5": "image/svg+xml", "2-girders": "image/svg+xml", "4-study": "text/html"}
    assert file.stem not in shown or shown[file.stem] in kinds
