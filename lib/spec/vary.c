/* SPDX-License-Identifier: MIT */
/* Multiply or replace a field of parts chosen by name. */
#include "spec/vary.h"

#include <math.h>

bool trk_spec_matches(const char *pattern, const char *name)
{
    const char *star = NULL, *retry = NULL;
    while (*name) {
        if (*pattern == '*') {
            star = ++pattern;
            retry = name;
        } else if (*pattern == *name) {
            pattern++;
            name++;
        } else if (star) {
            pattern = star;
            name = ++retry;
        } else {
            return false;
        }
    }
    while (*pattern == '*')
        pattern++;
    return !*pattern;
}

trk_part trk_field_part(trk_field field)
{
    switch (field) {
    case TRK_FIELD_STIFFNESS:
    case TRK_FIELD_DAMPING:
    case TRK_FIELD_FRICTION:
    case TRK_FIELD_APPROACH: return TRK_PART_LINK;
    case TRK_FIELD_BENDING: return TRK_PART_BEAM;
    default: return TRK_PART_BODY;
    }
}

bool trk_fields_overlap(trk_field a, trk_field b)
{
    bool mass_a = a == TRK_FIELD_MASS || a == TRK_FIELD_INERTIA;
    bool mass_b = b == TRK_FIELD_MASS || b == TRK_FIELD_INERTIA;
    return a == b || (a == TRK_FIELD_MASS_INERTIA && mass_b) ||
           (b == TRK_FIELD_MASS_INERTIA && mass_a);
}

trk_status trk_check_field(trk_context *context, const char *function, trk_field field)
{
    if (field >= TRK_FIELD_STIFFNESS && field <= TRK_FIELD_BENDING)
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT, "%s: there is no field %d", function, field);
}

/* Make all parts that match anew; none is put in its place yet. */
static trk_status make_all(const trk_spec *spec, trk_field field, const char *pattern,
                           trk_meaning meaning, double value, trk_varied_part *made,
                           int32_t *out_count)
{
    static const char what[] = "the number given to trk_spec_vary";
    const trk_part kind = trk_field_part(field);
    trk_status status = TRK_OK;
    *out_count = 0;
    for (int32_t part = 1; status == TRK_OK && part <= trk_spec_count(spec, kind); part++) {
        double before;
        if (!trk_spec_matches(pattern, trk_spec_part_name(spec, kind, part)))
            continue;
        status = trk_spec_check_field(spec, what, field, part, meaning, &before);
        if (status == TRK_OK)
            status =
                trk_varied_make(spec, part, field, meaning, value, spec, part, &made[*out_count]);
        *out_count += status == TRK_OK;
    }
    return status;
}

/* Put all that were made into the spec, or with status forget them. */
static void finish_all(trk_spec *spec, trk_varied_part *made, int32_t count, trk_status status)
{
    for (int32_t k = 0; k < count; k++)
        if (status == TRK_OK)
            trk_varied_put(spec, &made[k]);
        else
            trk_varied_drop(&made[k]);
    trk_free(spec->context, made);
}

trk_status trk_spec_vary(trk_spec *spec, trk_field field, const char *pattern, trk_meaning meaning,
                         double value, int32_t *out_count)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_vary");
    trk_context *context = spec->context;
    TRK_REQUIRE(context, pattern, "trk_spec_vary");
    trk_status status = trk_check_field(context, "trk_spec_vary", field);
    if (status != TRK_OK)
        return status;
    if (meaning != TRK_MEANING_FACTOR && meaning != TRK_MEANING_VALUE)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_spec_vary: there is no meaning %d", meaning);
    if (!isfinite(value))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_spec_vary: value is %g; a finite number is needed", value);
    int32_t count;
    trk_varied_part *made =
        trk_new(context, trk_spec_count(spec, trk_field_part(field)), sizeof *made);
    if (!made)
        return TRK_E_MEMORY;
    status = make_all(spec, field, pattern, meaning, value, made, &count);
    finish_all(spec, made, count, status);
    if (status == TRK_OK && count == 0)
        return trk_fail(context, TRK_E_NAME, "trk_spec_vary: no %s of '%s' is called '%s'",
                        trk_part_word(trk_field_part(field)), spec->name, pattern);
    if (status == TRK_OK && out_count)
        *out_count = count;
    return status;
}
