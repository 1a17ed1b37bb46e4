/* libFuzzer's entry: FUZZ is the function to feed. */
#include "fuzz/fuzz.h"

#include "base/log.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    log_set_level(LOG_QUIET);
    FUZZ(bytes, size);
    return 0;
}
