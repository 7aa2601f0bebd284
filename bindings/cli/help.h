/* SPDX-License-Identifier: MIT */
/* What the command says about itself. */
#ifndef TRUCKRIDE_CLI_HELP_H
#define TRUCKRIDE_CLI_HELP_H

#include "session.h"

/* All subcommands, ended by NULL. */
extern const command *const commands[];

/* What MODEL may be. */
extern const char help_model[];

void help_all(FILE *file);
void help_command(FILE *file, const command *c);

/* The manual page, in roff. */
void help_manual(FILE *file);

#endif
