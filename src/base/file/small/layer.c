/* The channels of one layer, among those of a file. */
#include "base/file/small/small.h"

#include "base/log.h"

#include <stdlib.h>
#include <string.h>

int sort_channels(int channels[3], int wanted[3]) {
    int count = 0;
    for (int c = 0; c < 3; c++) {
        int at = 0;
        while (at < count && wanted[at] < channels[c])
            at++;
        if (at < count && wanted[at] == channels[c])
            continue;
        memmove(wanted + at + 1, wanted + at, (size_t)(count - at) * sizeof *wanted);
        wanted[at] = channels[c];
        count++;
    }
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < count; i++)
            if (wanted[i] == channels[c]) {
                channels[c] = i;
                break;
            }
    return count;
}

void tell_layer(const struct image *image, const char *path, const char *layer) {
    char *note = image_layer_note(image, layer);
    if (note)
        log_note("%s: %s", path, note);
    free(note);
}
