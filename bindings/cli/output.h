/* SPDX-License-Identifier: MIT */
/* Where results go: a file or standard output, written completely or not at all. */
#ifndef TRUCKRIDE_CLI_OUTPUT_H
#define TRUCKRIDE_CLI_OUTPUT_H

#include "table.h"

/* Write tables as --format and --out say; the exit code. */
int output_tables(session *s, int count, table *const *tables);

/* Whatever prints to a file. */
typedef void (*output_writer)(FILE *file, const void *user);

/* Write the same way to `path`, "-" or NULL for standard output. */
int output_write(session *s, const char *path, output_writer writer, const void *user);

/* May this path be written? Asked before long work; EXIT_DONE or, with a message, EXIT_FAILED. */
int output_check(session *s, const char *path);

#endif
