/* The bridge to tinygltf. No exception leaves it. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/gltf.h"
}

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>

#include <unistd.h>

namespace gltf {

std::string clean(const std::string &text) {
    std::string out = text.substr(0, SCENE_NAME_SIZE - 1);
    while (out.size() < text.size() && !out.empty() && (text[out.size()] & 0xC0) == 0x80)
        out.pop_back();
    for (char &c : out)
        if ((unsigned char)c < 32 || c == 127)
            c = '?';
    return out;
}

std::string label(const char *noun, size_t index, const std::string &name) {
    std::string text = noun + (" " + std::to_string(index));
    return name.empty() ? text : text + " '" + clean(name) + "'";
}

void copy_name(char to[SCENE_NAME_SIZE], const std::string &from) {
    strcpy(to, clean(from).c_str());
}

bool copy_numbers(const std::vector<double> &from, float *to, const char *what) {
    for (size_t i = 0; i < from.size(); i++) {
        to[i] = float(from[i]);
        if (!std::isfinite(to[i]))
            return error_set("%s: %g is too large", what, from[i]);
    }
    return true;
}

namespace {

void list_files(Loader &loader) {
    struct scene &scene = *loader.scene;
    for (const Picture &picture : loader.pictures)
        if (!picture.uri.empty())
            remember_uri(loader, picture.uri);
    scene.files = allocate<char *>(loader.files.size());
    for (const std::string &file : loader.files)
        scene.files[scene.file_count++] = mem_strdup(file.c_str());
}

/* The JSON library allocates memory where it frees some, from where no exception comes. In threads
 * that have one of these, that ends as base/memory.h has it. The handler is the process's: the
 * first thread sets it, the last one puts back what was there. */
class MemoryEnds {
  public:
    MemoryEnds() {
        std::lock_guard<std::mutex> lock(mutex);
        if (count++ == 0)
            before = std::set_terminate(end);
        reads = true;
    }
    ~MemoryEnds() {
        std::lock_guard<std::mutex> lock(mutex);
        reads = false;
        if (--count == 0)
            std::set_terminate(before);
    }

  private:
    [[noreturn]] static void end() {
        if (!reads) {
            before();
            std::abort();
        }
        fputs("manylight: out of memory, while a scene is read\n", stderr);
        _exit(1);
    }
    static std::mutex mutex;
    static int count;
    static std::terminate_handler before;
    static thread_local bool reads;
};
std::mutex MemoryEnds::mutex;
int MemoryEnds::count;
std::terminate_handler MemoryEnds::before;
thread_local bool MemoryEnds::reads;

/* Each part of the scene, in this order. */
bool load_parts(Loader &loader) {
    return check_extensions(loader) && load_materials(loader) && load_meshes(loader) &&
           load_lights(loader) && load_cameras(loader) && load_nodes(loader) &&
           load_skins(loader) && load_clips(loader) && load_environment(loader) &&
           load_medium(loader);
}

} // namespace
} // namespace gltf

extern "C" bool gltf_load(struct scene *scene, const char *path, const struct file_bytes *bytes,
                          const struct scene_choice *choice) try {
    using namespace gltf;
    MemoryEnds ends;
    Loader loader;
    loader.scene = scene;
    loader.folder = path;
    loader.folder.resize(loader.folder.find_last_of('/') + 1);
    if (bytes ? loader.folder.empty() : piped_file_is(path))
        loader.folder = file_no_folder;
    scene->path = mem_strdup(path);
    if (!parse(loader, path, bytes))
        return false;
    if (!load_choice(loader, *choice) || !load_parts(loader))
        return error_prefix("%s", path);
    settle_blending(*scene);
    list_files(loader);
    tell_mended(loader);
    tell_lacks(loader);
    return true;
} catch (const std::bad_alloc &) {
    return error_set_memory("%s: out of memory while reading", path);
} catch (const std::exception &error) {
    /* A JSON library begins with its own name in brackets. */
    const char *bracket = strstr(error.what(), "] ");
    return error_set("%s: %s", path, bracket ? bracket + 2 : error.what());
}
