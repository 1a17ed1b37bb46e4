#!/usr/bin/env python3
"""check_info.py TEXT JSON: the two outputs of `info` have the same facts. Each text of JSON is in TEXT, and each number of
one is in the other as often."""
import json
import re
import sys

text, data = (open(path, encoding="utf-8", newline="").read() for path in sys.argv[1:])
data = json.loads(data)
numbers, words = [], []


def walk(value):
    if isinstance(value, dict):
        for item in value.values():
            walk(item)
    elif isinstance(value, list):
        if all(isinstance(item, dict) for item in value):
            numbers.append(len(value))
        for item in value:
            walk(item)
    elif isinstance(value, str):
        words.append(value)
    elif not isinstance(value, bool):
        numbers.append(value)


walk(data)
for word in sorted(words, key=len, reverse=True):
    assert word in text, f"TEXT lacks {word!r}"
    text = text.replace(word, " ", 1)
for token in re.findall(r"-?\d[\d.]*(?:e[+-]?\d+)?|-?\.\d+", re.sub("m2|1/m", "", text)):
    alike = [n for n in numbers if token in ("%.4g" % n, "%.9g" % n, "%.2f" % n, "%d" % n)]
    assert alike, f"JSON lacks {token}"
    numbers.remove(alike[0])
assert not numbers, f"TEXT lacks {numbers}"
print(f"{len(words)} texts alike")
