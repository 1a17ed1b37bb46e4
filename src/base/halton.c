#include "base/halton.h"

double radical_inverse(uint32_t base, uint32_t i) {
    double inverse = 0, digit_weight = 1;
    for (; i > 0; i /= base) {
        digit_weight /= base;
        inverse += digit_weight * (i % base);
    }
    return inverse;
}
