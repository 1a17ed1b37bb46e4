"""run_notebook.py NOTEBOOK: runs the cells of code in their order as one program; in a long run by nbconvert, if it is
here."""
import importlib.util
import json
import os
import subprocess
import sys


def run_cells(notebook):
    """As a program, in the working folder."""
    with open(notebook, encoding="utf-8") as file:
        cells = json.load(file)["cells"]
    code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    exec(compile(code, notebook, "exec"), {})


def convert(notebook):
    """By Jupyter, whose working folder is that of its input."""
    with open(notebook, "rb") as file:
        subprocess.run([sys.executable, "-m", "nbconvert", "--to", "markdown", "--execute", "--stdin", "--stdout"],
                       stdin=file, check=True)


run_cells(sys.argv[1])
if os.environ.get("MANYLIGHT_LONG") and all(map(importlib.util.find_spec, ("nbconvert", "ipykernel"))):
    convert(sys.argv[1])
