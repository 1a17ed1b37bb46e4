#define _POSIX_C_SOURCE 199309L
#include "apps/bench_machine.h"

#include "base/parallel.h"
#include "gl/api.h"

#include "version.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

static void read_cpu(char *text, size_t size) {
    char line[256];
    snprintf(text, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (colon && strncmp(line, "model name", 10) == 0) {
            snprintf(text, size, "%.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
            break;
        }
    }
    if (file)
        fclose(file);
}

void bench_machine_read(struct bench_machine *machine, bool software) {
    time_t now = time(NULL);
    *machine = (struct bench_machine){.software = software, .cores = parallel_core_count()};
    snprintf(machine->vendor, sizeof machine->vendor, "%s", (const char *)gl.GetString(GL_VENDOR));
    snprintf(machine->renderer, sizeof machine->renderer, "%s",
             (const char *)gl.GetString(GL_RENDERER));
    snprintf(machine->version, sizeof machine->version, "%s",
             (const char *)gl.GetString(GL_VERSION));
    snprintf(machine->commit, sizeof machine->commit, "%s", MANYLIGHT_COMMIT);
    strftime(machine->date, sizeof machine->date, "%Y-%m-%d", gmtime(&now));
    read_cpu(machine->cpu, sizeof machine->cpu);
}
