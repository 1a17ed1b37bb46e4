#include "shared/vpl.h"

vec3 cluster_color(int k) {
    return vec3(cluster_color(k, 0), cluster_color(k, 1), cluster_color(k, 2));
}
