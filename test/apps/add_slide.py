"""Gives the first light of a GLB a slide of one magenta pixel: add_slide.py SCENE.glb OUT.glb"""
import json
import struct
import sys

PIXEL = (
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4AWP4z/AfAAQAAf8wiYajAAAAAElFTkSuQmCC"
)


def main(source, target):
    with open(source, "rb") as file:
        data = file.read()
    size = struct.unpack_from("<I", data, 12)[0]
    scene, rest = json.loads(data[20 : 20 + size]), data[20 + size :]
    scene.setdefault("images", []).append({"uri": PIXEL})
    scene.setdefault("textures", []).append({"source": len(scene["images"]) - 1})
    light = scene["extensions"]["KHR_lights_punctual"]["lights"][0]
    light["extras"] = {"texture": {"index": len(scene["textures"]) - 1}}
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(target, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text + rest)


main(*sys.argv[1:])
