// VPLs and empty leaves in the order of the tree: a key of two words to be sorted by, and a number.
#include "shared/vpl.h"

PASS_BLOCK(vpl_tree_params, 32)

layout(std430, binding = STORAGE_TREE_KEYS) buffer tree_key_storage {
    uvec4 tree_keys[];
};
