"""run_notebook.py NOTEBOOK: runs the cells of code in their order, by nbconvert where it is, else as one program."""
import json
import subprocess
import sys

try:
    import ipykernel  # noqa: F401
    import nbconvert  # noqa: F401
except ImportError:
    with open(sys.argv[1], encoding="utf-8") as file:
        cells = json.load(file)["cells"]
    code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    exec(compile(code, sys.argv[1], "exec"), {})
    print("    ran without nbconvert")
else:
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "markdown", "--execute", "--stdout",
                    "--ExecutePreprocessor.cwd=.", sys.argv[1]], check=True)
