"""The white furnace: directional albedo of each material that manylight reads, in light of radiance 1 from everywhere.

A plate of the material fills the view of an orthographic camera. Expected values have no code in common with the program.
"""
import math

import numpy as np

import manylight
from glb import open_glb
from manylight import Camera, Mesh

ANGLES = (0, 60, 75)  # degrees between the view and the normal


def lobe_albedo(roughness, cosine, f0=1, f90=1, steps=1500):
    """Of GGX with height-correlated Smith visibility and Schlick's Fresnel term, by the midpoint rule over half vectors,
    even in the square of their tangent over alpha (which goes as D n.h) and in their turn."""
    alpha2, sine = max(roughness, .045)**4, math.sqrt(1 - cosine * cosine)
    u, turn = np.meshgrid((np.arange(steps) + .5) / steps, math.pi * (np.arange(steps // 4) + .5) / (steps // 4))
    half = np.sqrt((1 - u) / (1 - u + alpha2 * u))
    v_h = sine * np.sqrt(1 - half * half) * np.cos(turn) + cosine * half
    n_l = 2 * v_h * half - cosine
    up = np.maximum(n_l, 0)
    roots = [np.sqrt(alpha2 + (1 - alpha2) * c * c) for c in (cosine, up)]
    visibility = .5 / (cosine * roots[1] + up * roots[0])
    fresnel = f0 + (f90 - f0) * (1 - np.clip(v_h, 0, 1))**5
    return np.where((v_h > 0) & (n_l > 0), 4 * v_h / half * up * visibility * fresnel, 0).mean()


def plate_passes(cosine, index=1.52):
    """Two faces of clear glass with inner reflections, mean of both polarisations: (1 - r) / (1 + r)."""
    within = np.sqrt(1 - (1 - cosine**2) / index**2)
    faces = ((cosine - index * within) / (cosine + index * within), (within - index * cosine) / (within + index * cosine))
    return sum(.5 * (1 - r * r) / (1 + r * r) for r in faces)


class Row:
    """A material and its albedo by the cosine of the view."""

    def __init__(self, name, material, albedo=lambda cosine: 1., **more):
        self.name, self.material, self.albedo, self.more = name, material, albedo, more


def surface(metalness, roughness, color=(1, 1, 1, 1), **more):
    return {"pbrMetallicRoughness": {"baseColorFactor": list(color), "metallicFactor": metalness,
                                     "roughnessFactor": roughness}, "doubleSided": True, **more}


def extended(metalness, roughness, **extensions):
    return surface(metalness, roughness, extensions={f"KHR_materials_{name}": value for name, value in extensions.items()})


def metal(metalness, roughness):
    def albedo(cosine):
        return 1 - metalness + metalness * lobe_albedo(roughness, cosine)
    return Row(f"metalness {metalness:g}, roughness {roughness:g}", surface(metalness, roughness), albedo)


def materials():
    for roughness in (0, .1, .25, .5, .75, 1):
        yield Row(f"metalness 0, roughness {roughness:g}", surface(0, roughness))
    for metalness in (.5, 1):
        for roughness in (0, .1, .25, .5, .75, 1):
            yield metal(metalness, roughness)
    for ior in (1, 1.33, 2.4):
        yield Row(f"`ior` {ior:g}, roughness .5", extended(0, .5, ior={"ior": ior}))
    yield Row("`specular` .5, roughness .5", extended(0, .5, specular={"specularFactor": .5}))
    yield Row("`specular` 0, roughness .5", extended(0, .5, specular={"specularFactor": 0}))
    yield Row("`specularColor` 5, roughness .5", extended(0, .5, specular={"specularColorFactor": [5, 5, 5]}))
    for specular, glossiness in ((.04, .5), (.5, .5), (1, .5)):
        old = {"diffuseFactor": [1, 1, 1, 1], "specularFactor": [specular] * 3, "glossinessFactor": glossiness}
        yield Row(f"`specular-glossiness`: white, {specular:g}, {glossiness:g}", extended(1, 1, pbrSpecularGlossiness=old))
    yield Row("`unlit`", extended(0, 1, unlit={}))
    for fraction in (.5, 1):
        yield Row(f"`transmission` {fraction:g}, thin", extended(0, 0, transmission={"transmissionFactor": fraction}))
    yield Row("`transmission` 1, thin, roughness .5", extended(0, .5, transmission={"transmissionFactor": 1}),
              lambda cosine: 1 - (1 - plate_passes(cosine, 1.5)) * (1 - lobe_albedo(.5, cosine)))
    yield Row("`transmission` 1, a solid 1 m thick",
              extended(0, 0, transmission={"transmissionFactor": 1}, volume={"thicknessFactor": 1}), thick=True)
    yield Row("blend, alpha .5", surface(0, 1, (1, 1, 1, .5), alphaMode="BLEND"))
    yield Row("mask, alpha .4: a hole", surface(0, 1, (1, 1, 1, .4), alphaMode="MASK"))
    yield Row("mask, alpha .6", surface(0, 1, (1, 1, 1, .6), alphaMode="MASK"))
    tilt = math.radians(30)
    yield Row("normal map, 30 degrees across the view", surface(0, 1, normalTexture={"index": 0}),
              lambda cosine: .5 * (1 + math.cos(tilt)), tilted=True)


def normal_map():
    """A glTF's texture of one normal, turned about the x axis."""
    from manylight._parts import _png  # noqa: the module's own writer
    import base64
    texel = np.round(255 * (.5 + .5 * np.array([0, math.sin(math.radians(30)), math.cos(math.radians(30))])))
    uri = "data:image/png;base64," + base64.b64encode(_png(np.full((4, 4, 3), texel, np.uint8))).decode()
    return {"textures": [{"source": 0}], "images": [{"uri": uri}]}


def plate(height=0, up=1, size=5):
    corners = [(-size, height, up * size), (size, height, up * size), (size, height, -up * size), (-size, height, -up * size)]
    return Mesh(corners, [[0, 1, 2], [0, 2, 3]], uvs=[(0, 0), (1, 0), (1, 1), (0, 1)])


def parts_of(row):
    """Meshes, and members of glTF's JSON."""
    return [plate()] + ([plate(-1, -1)] if row.more.get("thick") else []), normal_map() if row.more.get("tilted") else {}


def scene_of(row, environment):
    meshes, more = parts_of(row)
    return open_glb(meshes, [row.material], environment, **more)


def camera(angle, size=.5):
    """Across the z axis, from 3 m away."""
    turn = math.radians(angle)
    away = np.array([math.sin(turn), math.cos(turn), 0])
    return Camera(tuple(3 * away), tuple(-away), (0, 0, 1), fov_y=0, y_extent=size)


def mean(layers):
    return float(layers["beauty"][..., :3].mean())


def measure(device, folder):
    """Rows of (name, albedos, the tracer's, the frame's), one each angle."""
    environment = folder + "/white.exr"
    manylight.write(environment, {"beauty": np.ones((32, 64, 3), np.float32)})
    for row in materials():
        scene, traced, frames = scene_of(row, environment), [], []
        for angle in ANGLES:
            traced.append(mean(manylight.reference(scene, (16, 16), camera=camera(angle), samples=1024)))
            frames.append(mean(device.render(scene, (64, 64), camera=camera(angle))))
        yield row.name, [row.albedo(math.cos(math.radians(angle))) for angle in ANGLES], traced, frames


HEAD = """
## White furnace

Radiance of a plate of each material in light of radiance 1 from everywhere, seen from 0, 60 and 75 degrees.
Base colours are white. Albedos are 1, or formulas with an independent quadrature of GGX. The last columns are
deviations in %.

- A metal of metalness m loses m (1 - E): GGX scatters once, and E is its directional albedo.
- A dielectric loses nothing: its diffuse part has the light that the lobe leaves. glTF's own mix has up to 1.35 of it.
- Rough thin glass mirrors by GGX in the path tracer and so loses (1 - plate) (1 - E). Frames mirror it as smooth glass.
- Another engine's tests have .5755 for the metal of roughness .75 from straight on. Its masking term, Schlick's with
  k = (roughness + 1)^2 / 8, has .5756 in this quadrature; Smith's, which glTF names, has .6269.
- A normal map of 30 degrees turns the hemisphere: the plate itself blocks (1 - cos 30) / 2 of it.

| material | albedo | path tracer | frame |
|---|---|---|---|"""


def page(rows):
    print(HEAD)
    for name, albedos, *found in rows:
        texts = [", ".join(f"{100 * (value / albedo - 1):+.2f}" for value, albedo in zip(values, albedos)) for values in found]
        print(f"| {name} |", ", ".join(f"{albedo:.4g}" for albedo in albedos), "|", " | ".join(texts), "|")
