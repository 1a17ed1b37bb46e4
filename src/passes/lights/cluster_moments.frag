#include "shared/bindings.h"

flat in vec4 squares, products;

layout(location = TARGET_SUM_SQUARES) out vec4 sum_squares;   // xx, yy, zz; area
layout(location = TARGET_SUM_PRODUCTS) out vec4 sum_products; // yz, zx, xy; squared reach of near fields

void main() {
    sum_squares = squares;
    sum_products = products;
}
