/* The JSON library's only name in the tree. */
#ifndef BASE_JSON_LIBRARY_HPP
#define BASE_JSON_LIBRARY_HPP

#include <nlohmann/json.hpp>

#endif
