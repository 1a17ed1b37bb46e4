/* The JSON of a file before tinygltf sees it: checked, mended, and without the bytes that it
 * names. */
#ifndef SCENE_GLTF_JSON_HPP
#define SCENE_GLTF_JSON_HPP

#include "scene/gltf/model.hpp"

#include "base/json_library.hpp"

namespace gltf {

using nlohmann::json;

/* Of the list at a JSON pointer; 0 where there is none. */
size_t list_size(const json &root, const char *pointer);

/* The value as a user would find it in the file, shortened. */
std::string quote(const json &value);

/* "mesh 3 'name'" of an element that may be anything. */
std::string label_of(const char *noun, size_t index, const json &element);

/* text.cpp: writes U+FFFD for each byte and escape that is not Unicode; in a URI the byte itself,
 * by a percent sign. Returns the place of the first one, or npos. */
size_t replace_bad_text(const std::string &text, std::string &out);

/* extension.cpp: refuses a version or a required extension that is not read. */
bool check_asset(Loader &loader, json &root);

/* schema.cpp: whether the JSON is what the standard demands, after small defects are mended. All
 * indices and types are right afterwards. */
bool check_schema(Loader &loader, json &root);

/* mended.cpp: leaves lights out that are of an unknown type or of negative intensity. The JSON may
 * be anything. */
bool mend_lights(Loader &loader, json &root);

/* mended.cpp: numbers of nodes, lights and materials that are off by rounding, and depths of
 * cameras that are none. */
bool mend_numbers(Loader &loader, json &root);

/* buffers.cpp: takes the bytes of buffers and the pictures out of the JSON, with those of the BIN
 * chunk, and checks that all buffer views lie in them. */
bool take_buffers(Loader &loader, json &root, const char *bin, size_t bin_size);
bool take_pictures(Loader &loader, json &root);

} // namespace gltf

#endif
