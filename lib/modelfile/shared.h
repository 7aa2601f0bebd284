/* SPDX-License-Identifier: MIT */
/* Curves and laws that links of a spec have in common: they are written once, with a name. */
#ifndef TRK_MODELFILE_SHARED_H
#define TRK_MODELFILE_SHARED_H

#include "modelfile/table.h"

/*
 * Curves are used by links in four places, laws in one: use k is place k of the spec, NULL if nothing is
 * there. A curve or law is written into the section if its name is not empty and the first with
 * that name; equal ones are written as that name, others where they act.
 */
int64_t trk_curve_uses(const trk_spec *spec);
const trk_curve *trk_curve_use(const trk_spec *spec, int64_t use);
int64_t trk_law_uses(const trk_spec *spec);
const trk_law *trk_law_use(const trk_spec *spec, int64_t use);

/* Whether the use is the first of its name, so that it belongs into the section. */
bool trk_curve_leads(const trk_spec *spec, int64_t use);
bool trk_law_leads(const trk_spec *spec, int64_t use);

/* Whether the name stands for this curve or law. */
bool trk_curve_is_named(const trk_spec *spec, const trk_curve *curve);
bool trk_law_is_named(const trk_spec *spec, const trk_law *law);

/* Form and options of a law. */
const trk_law_form *trk_law_read_form(const trk_law *law, trk_law_options *out_options);

#endif
