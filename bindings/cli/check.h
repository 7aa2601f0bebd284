/* SPDX-License-Identifier: MIT */
/* What truckride check finds out about a vehicle. */
#ifndef TRUCKRIDE_CLI_CHECK_H
#define TRUCKRIDE_CLI_CHECK_H

#include "table.h"

/* Its tables. */
typedef struct check_report {
    table *vehicles, *tires, *axles, *modes, *warnings;
} check_report;

/* A vehicle that is looked at, compiled with gravity. */
typedef struct check_subject {
    const char *label;
    const trk_spec *spec;
    const trk_model *model;
    double *force;       /* [N, N m] of every link at rest */
    double weight;       /* [N] of all that can move up and down */
    double road, ground; /* [N] carried by roads and ground */
} check_subject;

/* Add a warning about the subject. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void check_warn(check_report *r, const check_subject *c, const char *format, ...);

/* Masses and what carries them (check_loads.c): fills in weight, road and ground. */
void check_loads(check_report *r, check_subject *c);

/* Parts that do nothing, and what else is likely a mistake (check_parts.c). */
void check_parts(check_report *r, const check_subject *c);

#endif
