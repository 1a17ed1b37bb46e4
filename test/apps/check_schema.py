"""check_schema.py SCHEMA FILE [SCHEMA FILE ...]: exit status 1 where a file is not as its schema says."""
import json
import pathlib
import sys

import jsonschema


def load(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def main(paths):
    folder = pathlib.Path(paths[0]).parent
    store = {path.name: load(path) for path in folder.glob("*.json")}
    for schema, file in zip(paths[::2], paths[1::2]):
        resolver = jsonschema.RefResolver("", load(schema), store=store)
        validator = jsonschema.Draft202012Validator(load(schema), resolver=resolver)
        for error in validator.iter_errors(load(file)):
            print(f"{file}: {error.message}")
            return 1
    return 0


sys.exit(main(sys.argv[1:]))
