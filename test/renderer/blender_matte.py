"""blender -b -P blender_matte.py -- FILE LAYER NAME OUT: the matte of a name in Blender's compositor."""
import sys

import bpy

path, layer, name, out = sys.argv[sys.argv.index("--") + 1:]
scene = bpy.context.scene
scene.use_nodes = True
tree = scene.node_tree
tree.nodes.clear()
matte, end = tree.nodes.new("CompositorNodeCryptomatteV2"), tree.nodes.new("CompositorNodeComposite")
matte.source, matte.image = "IMAGE", bpy.data.images.load(path)
matte.image.pixels[:1]  # loads the file
matte.layer_name, matte.matte_id = layer, name
tree.links.new(matte.outputs["Matte"], end.inputs["Image"])
render = scene.render
render.resolution_x, render.resolution_y, render.resolution_percentage = 40, 40, 100
render.image_settings.file_format, render.image_settings.color_depth, render.filepath = "OPEN_EXR", "32", out
bpy.ops.render.render(write_still=True)
