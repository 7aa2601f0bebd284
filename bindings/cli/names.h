/* SPDX-License-Identifier: MIT */
/* Parts chosen by patterns of their names. */
#ifndef TRUCKRIDE_CLI_NAMES_H
#define TRUCKRIDE_CLI_NAMES_H

#include "session.h"

/* Set the flags of names that match "a,b_*"; NULL means all. A pattern that matches none is wrong
 * usage: the message calls it `what` and suggests a name. */
int names_select(session *s, const char *what, int32_t count, const char *const *names,
                 const char *patterns, bool *flags);

/* The same for parts of a model; flags may be NULL: only look whether the patterns are right. */
int names_of_model(session *s, const trk_model *model, trk_part part, const char *patterns,
                   bool *flags);

#endif
