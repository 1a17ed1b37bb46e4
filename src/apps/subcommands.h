/* The subcommands by name. Each parses its own arguments, prints errors and returns the exit
 * status: 0 ok, 1 failed, 2 usage. argv[0] is its name. */
#ifndef APPS_SUBCOMMANDS_H
#define APPS_SUBCOMMANDS_H

struct subcommand {
    const char *name, *help;
    int (*run)(int argc, char **argv); /* NULL: not part of this build */
};

/* All subcommands; a row whose name is NULL ends the table. */
extern const struct subcommand subcommands[];

/* Returns the row of that name, or NULL. */
const struct subcommand *subcommand_find(const char *name);

int app_average(int argc, char **argv);
int app_bench(int argc, char **argv);
int app_compare(int argc, char **argv);
int app_export(int argc, char **argv);
int app_reference(int argc, char **argv);
int app_info(int argc, char **argv);
int app_probe(int argc, char **argv);
int app_render(int argc, char **argv);
int app_view(int argc, char **argv);

#endif
