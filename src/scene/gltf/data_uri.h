/* URIs of glTF files: data in them, and percent signs. */
#ifndef SCENE_GLTF_DATA_URI_H
#define SCENE_GLTF_DATA_URI_H

#include "base/file/file.h"

/* Whether the bytes are in the URI itself [RFC 2397], of whatever type. */
bool data_uri_is(const char *uri);

/* Those bytes, from base64 of either alphabet or from percent signs. Error: there is no comma, or a
 * digit that base64 does not have; bytes are zeroed then. */
bool data_uri_decode(struct file_bytes *bytes, const char *uri);

/* Replaces each %XX by its byte, in place, and ends the text; its new length. */
size_t uri_unescape(char *uri);

#endif
