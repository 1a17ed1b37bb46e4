/* URIs of glTF files: embedded data and percent encoding. */
#ifndef SCENE_GLTF_DATA_URI_H
#define SCENE_GLTF_DATA_URI_H

#include "base/file/file.h"

/* True if the URI contains its data [RFC 2397], of any type. */
bool data_uri_is(const char *uri);

/* Decodes the data, from base64 of either alphabet or percent encoding. Error: no comma, or an
 * invalid base64 digit; `bytes` is then zeroed. */
bool data_uri_decode(struct file_bytes *bytes, const char *uri);

/* Replaces each %XX by its byte, in place. Returns the new length; the text stays
 * null-terminated. */
size_t uri_unescape(char *uri);

#endif
