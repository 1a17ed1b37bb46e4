/* JSON whose names are not Unicode, as exporters write the Latin-1 or GBK of a modelling program */
#include "scene/gltf/json.hpp"

extern "C" {
#include "base/json.h"
}

#include <cctype>

namespace gltf {
namespace {

enum { ESCAPE = 6 }; /* characters of \uXXXX */

/* The code unit of an escape that begins here; 0 = none does. */
unsigned escaped_unit(const std::string &text, size_t at) {
    if (text.compare(at, 2, "\\u") != 0 || text.size() - at < ESCAPE)
        return 0;
    for (size_t i = at + 2; i < at + ESCAPE; i++)
        if (!isxdigit((unsigned char)text[i]))
            return 0;
    return unsigned(std::stoul(text.substr(at + 2, 4), nullptr, 16));
}

bool is_in(unsigned unit, unsigned first, unsigned last) {
    return unit >= first && unit <= last;
}

/* Characters of the character or escape that begins here; 0 = it is not Unicode. */
size_t good_length(const std::string &text, size_t at) {
    if (text[at] != '\\')
        return size_t(utf8_length(reinterpret_cast<const unsigned char *>(&text[at])));
    unsigned unit = escaped_unit(text, at);
    if (!is_in(unit, 0xD800, 0xDFFF))
        return std::min(size_t(2), text.size() - at);
    bool is_pair = unit < 0xDC00 && is_in(escaped_unit(text, at + ESCAPE), 0xDC00, 0xDFFF);
    return is_pair ? 2 * ESCAPE : 0;
}

/* Whether a string that begins here is the value of "uri". */
bool begins_uri(const std::string &before) {
    const char *blanks = " \t\r\n", *key = "\"uri\"";
    size_t colon = before.find_last_not_of(blanks);
    if (colon == 0 || colon == std::string::npos || before[colon] != ':')
        return false;
    size_t end = before.find_last_not_of(blanks, colon - 1);
    return end != std::string::npos && end >= 4 && before.compare(end - 4, 5, key) == 0;
}

/* The byte that Python's "surrogateescape" or the file itself has, by a percent sign. */
std::string percent(unsigned byte) {
    char text[4];
    snprintf(text, sizeof text, "%%%02X", byte & 0xFF);
    return text;
}

} // namespace

size_t replace_bad_text(const std::string &text, std::string &out) {
    size_t first = std::string::npos;
    bool is_uri = false;
    for (size_t at = 0, length; at < text.size(); at += length) {
        length = good_length(text, at);
        if (text[at] == '"')
            is_uri = begins_uri(out);
        if (length > 0) {
            out.append(text, at, length);
            continue;
        }
        first = std::min(first, at);
        unsigned unit = escaped_unit(text, at);
        length = unit ? ESCAPE : 1;
        out += is_uri ? percent(unit ? unit : (unsigned char)text[at]) : "\xEF\xBF\xBD";
    }
    return first;
}

} // namespace gltf
