#!/usr/bin/env python3
"""check_progress.py: reads the events of --progress json on standard input. Each line is one object with the fields that
docs/user/02-rendering.md lists, what is done of a task never falls, and the last event is done or error. Prints how many
events of each kind there are, and the files."""
import collections
import json
import sys

FIELDS = {
    "progress": {"task", "done", "seconds", "eta", "note"},
    "file": {"task", "file"},
    "note": {"text"},
    "warning": {"text"},
    "detail": {"text"},
    "error": {"text"},
    "done": {"done", "seconds"},
}
PLACES = ({"frame", "frames"}, {"pass", "passes"})

counts, files, done, last = collections.Counter(), [], {}, None
for line in sys.stdin:
    event = json.loads(line)
    last = event.pop("event")
    counts[last] += 1
    names = set(event)
    for place in PLACES:
        if last in ("progress", "file") and place <= names:
            names -= place
    assert names == FIELDS[last], (last, names)
    if last == "progress":
        before = done.get(event["task"], {"done": 0, "seconds": 0})
        assert before["done"] <= event["done"] <= 1, (before, event)
        assert before["seconds"] <= event["seconds"], (before, event)
        assert (event["eta"] is None) == (event["done"] == 0), event
        assert event.get("pass", 0) <= event.get("passes", 0), event
        done[event["task"]] = event
    if last == "file":
        files.append(event["file"].rsplit("/", 1)[-1])
assert last in ("done", "error"), last
assert counts["done"] + counts["error"] == 1, counts
print(" ".join(f"{name}={counts[name]}" for name in FIELDS if counts[name]), *files)
