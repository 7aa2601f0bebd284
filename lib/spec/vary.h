/* SPDX-License-Identifier: MIT */
/* Fields of parts found by pattern: what trk_spec_vary(), calibrations and studies share. */
#ifndef TRK_SPEC_VARY_H
#define TRK_SPEC_VARY_H

#include "spec/law_values.h"
#include "spec/spec.h"

/* Does a name match a pattern in which '*' stands for any text, also none? */
bool trk_spec_matches(const char *pattern, const char *name);

/* Kind of part that has the field; do two fields of one part share a number? */
trk_part trk_field_part(trk_field field);
bool trk_fields_overlap(trk_field a, trk_field b);

/* TRK_E_ARGUMENT unless there is such a field; `function` is put in front of the message. */
trk_status trk_check_field(trk_context *context, const char *function, trk_field field);

/*
 * May a field of a part be scaled, or with TRK_MEANING_VALUE replaced by one number?
 * TRK_E_MODEL if not, with `who` in front of the message. *out_value is the number.
 */
trk_status trk_spec_check_field(const trk_spec *spec, const char *who, trk_field field,
                                int32_t part, trk_meaning meaning, double *out_value);

/* A part with another number in one of its fields, made but not yet in a spec. */
typedef struct trk_varied_part {
    trk_part kind;
    int32_t id;
    trk_link_options link; /* law owned by this struct if law_is_new */
    trk_body_options body;
    trk_beam_options beam;
    bool law_is_new;
} trk_varied_part;

/*
 * Field of a part of `spec` = number times that of a part of `base`, or, with
 * TRK_MEANING_VALUE, the number itself in the place of the one that `base` has. TRK_E_RANGE: out
 * of range for the part; TRK_E_MODEL: a law of another kind than in `base`; TRK_E_MEMORY.
 */
trk_status trk_varied_make(const trk_spec *spec, int32_t part, trk_field field, trk_meaning meaning,
                           double number, const trk_spec *base, int32_t base_part,
                           trk_varied_part *out);

/* Put it into the spec; cannot fail. Or forget it. */
void trk_varied_put(trk_spec *spec, const trk_varied_part *varied);
void trk_varied_drop(const trk_varied_part *varied);

/* Make and put; on failure the part stays as it was. */
trk_status trk_spec_set_field(trk_spec *spec, int32_t part, trk_field field, trk_meaning meaning,
                              double number, const trk_spec *base, int32_t base_part);

#endif
