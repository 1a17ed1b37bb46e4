"""check_jeri.py FOLDER: jeri.json has the fields of JERI's InputTree, titles that differ among siblings, and files that
are there.

[disneyresearch/jeri, src/components/ImageViewer/index.tsx]: a node has title and children, a leaf title and image. A tab
is found by its title. Pictures need the channels R, G and B.
"""
import json
import os
import sys

folder = sys.argv[1]
images = []


def check(node, path):
    assert isinstance(node.get("title"), str) and node["title"], f"{path}: no title"
    if "children" in node:
        assert set(node) == {"title", "children"} and node["children"], f"{path}: fields {sorted(node)}"
        titles = [child["title"] for child in node["children"]]
        assert len(set(titles)) == len(titles), f"{path}: titles {titles}"
        for child in node["children"]:
            check(child, f"{path}/{child['title']}")
    else:
        assert set(node) == {"title", "image"}, f"{path}: fields {sorted(node)}"
        images.append(node["image"])


with open(os.path.join(folder, "jeri.json")) as file:
    check(json.load(file), "")
for image in images:
    with open(os.path.join(folder, image), "rb") as file:
        head = file.read(4096)
    assert head[:4] == b"\x76\x2f\x31\x01", f"{image}: no EXR"
    assert all(b"\0" + name + b"\0" in head for name in (b"R", b"G", b"B")), f"{image}: no channels R, G, B"
print(len(images), "pictures")
