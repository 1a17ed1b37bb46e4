/* The subcommands. Each parses its own arguments, prints errors and returns the exit status:
 * 0 ok, 1 failed, 2 usage. argv[0] is the subcommand's name. */
#ifndef APPS_APPS_H
#define APPS_APPS_H

int app_average(int argc, char **argv);
int app_bench(int argc, char **argv);
int app_compare(int argc, char **argv);
int app_export(int argc, char **argv);
int app_reference(int argc, char **argv);
int app_info(int argc, char **argv);
int app_manual(int argc, char **argv);
int app_render(int argc, char **argv);
int app_score(int argc, char **argv);
int app_view(int argc, char **argv);

#endif
