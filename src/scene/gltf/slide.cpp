/* Our own extras of a spot: {"texture": {"index": 0}}, a texture of the file whose picture colours
 * the light. */
#include "scene/gltf/model.hpp"

namespace gltf {
namespace {

/* The number of the file's image, or -1. Error: no such texture, or one without a picture. */
int image_of(const Loader &loader, const tinygltf::Value &texture) {
    const auto &textures = loader.model.textures;
    bool is_info = texture.IsObject() && texture.Has("index") && texture.Get("index").IsInt();
    int index = is_info ? texture.Get("index").GetNumberAsInt() : -1;
    int image = index >= 0 && size_t(index) < textures.size()
                    ? texture_source(textures[size_t(index)])
                    : -1;
    if (image < 0 || size_t(image) >= loader.model.images.size()) {
        error_set("it wants {\"index\": N}, a texture of the file with a picture");
        return -1;
    }
    return image;
}

bool check_spot(const struct scene_light &light) {
    if (light.type != EMITTER_SPOT)
        return error_set("only a spot has one");
    return light.outer <= SLIDE_CONE_MAX ||
           error_set("the cone's half angle is %g, above %g radians", double(light.outer),
                     double(SLIDE_CONE_MAX));
}

bool read_picture(Loader &loader, int image, struct bitmap &bitmap) {
    if (!load_image(loader, image, bitmap))
        return false;
    if (bitmap.width > SLIDE_SIZE_MAX || bitmap.height > SLIDE_SIZE_MAX)
        return error_set("its picture has %d x %d pixels, more than %d a side", bitmap.width,
                         bitmap.height, SLIDE_SIZE_MAX);
    return spend(loader, uint64_t(bitmap.width) * uint64_t(bitmap.height), 4 * sizeof(float));
}

} // namespace

bool load_slide(Loader &loader, const tinygltf::Value &extras, struct scene_light &light) {
    if (!extras.IsObject() || !extras.Has("texture"))
        return true;
    struct scene *scene = loader.scene;
    struct bitmap bitmap = {};
    int image = image_of(loader, extras.Get("texture"));
    bool good = image >= 0 && check_spot(light) && read_picture(loader, image, bitmap);
    if (good) {
        slide_init(&scene->slides[scene->slide_count], scene->slide_count, &bitmap);
        light.slide = ++scene->slide_count;
    }
    bitmap_free(&bitmap);
    return good || error_prefix("extras: texture");
}

} // namespace gltf
