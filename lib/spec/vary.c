/* SPDX-License-Identifier: MIT */
/* Multiply or replace a field of parts chosen by name. */
#include "spec/vary.h"

#include <math.h>

enum { MOST_NUMBERS = 4 }; /* of a field: mass and three moments of inertia */

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
    return field == TRK_FIELD_STIFFNESS || field == TRK_FIELD_DAMPING ? TRK_PART_LINK
                                                                      : TRK_PART_BODY;
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
    if (field >= TRK_FIELD_STIFFNESS && field <= TRK_FIELD_MASS_INERTIA)
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT, "%s: there is no field %d", function, field);
}

/* Numbers of a field: the plain ones first; of a link the scale of its curve comes last. */
static int list_numbers(trk_field field, trk_link_options *link, trk_body_options *body,
                        double *out[MOST_NUMBERS])
{
    int count = 0;
    if (field == TRK_FIELD_STIFFNESS) {
        out[count++] = &link->stiffness;
        out[count++] = &link->spring_scale;
    } else if (field == TRK_FIELD_DAMPING) {
        out[count++] = &link->damping;
        out[count++] = &link->damper_scale;
    }
    if (field == TRK_FIELD_MASS || field == TRK_FIELD_MASS_INERTIA)
        out[count++] = &body->mass;
    for (int k = 0; k < 3; k++)
        if (field == TRK_FIELD_INERTIA || field == TRK_FIELD_MASS_INERTIA)
            out[count++] = &body->inertia[k];
    return count;
}

/* Copies of the options of a part that has the field. */
static void read_part(const trk_spec *spec, trk_field field, int32_t part, trk_link_options *link,
                      trk_body_options *body)
{
    if (trk_field_part(field) == TRK_PART_LINK)
        *link = spec->links[part - 1];
    else
        *body = spec->bodies[part - 1];
}

trk_status trk_spec_check_field(const trk_spec *spec, const char *who, trk_field field,
                                int32_t part, trk_meaning meaning, double *out_value)
{
    trk_link_options link;
    trk_body_options body;
    double *number[MOST_NUMBERS];
    read_part(spec, field, part, &link, &body);
    int plain = list_numbers(field, &link, &body, number);
    bool curve = false;
    if (trk_field_part(field) == TRK_PART_LINK) {
        const trk_curve *c = field == TRK_FIELD_STIFFNESS ? link.spring_curve : link.damper_curve;
        plain--; /* a scale without a curve is no number of the field */
        curve = c && *number[plain] != 0;
    }
    int count = 0;
    *out_value = 0;
    for (int k = plain - 1; k >= 0; k--)
        if (*number[k] != 0) {
            *out_value = *number[k];
            count++;
        }
    const char *name = trk_spec_part_name(spec, trk_field_part(field), part);
    if (count == 0 && !curve)
        return trk_fail(spec->context, TRK_E_MODEL, "%s: '%s' has nothing to scale in this field",
                        who, name);
    if (meaning == TRK_MEANING_VALUE && (count != 1 || curve || *out_value < 0))
        return trk_fail(spec->context, TRK_E_MODEL,
                        "%s is a value, but '%s' has not one positive number in this field", who,
                        name);
    return TRK_OK;
}

/* The number that a value replaces is the one that is not zero. */
static void change_numbers(trk_field field, trk_meaning meaning, double number,
                           trk_link_options *link, trk_body_options *body,
                           trk_link_options *base_link, trk_body_options *base_body)
{
    double *to[MOST_NUMBERS], *from[MOST_NUMBERS];
    int count = list_numbers(field, link, body, to);
    list_numbers(field, base_link, base_body, from);
    if (meaning == TRK_MEANING_FACTOR) {
        for (int k = 0; k < count; k++)
            *to[k] = number * *from[k];
        return;
    }
    int plain = trk_field_part(field) == TRK_PART_LINK ? count - 1 : count;
    for (int k = 0; k < plain; k++)
        if (*from[k] != 0) {
            *to[k] = number;
            return;
        }
}

trk_status trk_spec_set_field(trk_spec *spec, int32_t part, trk_field field, trk_meaning meaning,
                              double number, const trk_spec *base, int32_t base_part, bool commit)
{
    trk_link_options link, base_link;
    trk_body_options body, base_body;
    read_part(spec, field, part, &link, &body);
    read_part(base, field, base_part, &base_link, &base_body);
    change_numbers(field, meaning, number, &link, &body, &base_link, &base_body);
    const bool is_link = trk_field_part(field) == TRK_PART_LINK;
    const char *name = trk_spec_part_name(spec, trk_field_part(field), part);
    trk_status status = is_link ? trk_check_link_values(spec->context, name, &link)
                                : trk_check_body(spec->context, name, &body);
    if (status != TRK_OK || !commit)
        return status;
    if (is_link)
        spec->links[part - 1] = link;
    else
        spec->bodies[part - 1] = body;
    return TRK_OK;
}

/* Check, or with commit change, all parts that match. */
static trk_status vary(trk_spec *spec, trk_field field, const char *pattern, trk_meaning meaning,
                       double value, bool commit, int32_t *out_count)
{
    static const char what[] = "the number given to trk_spec_vary";
    const trk_part kind = trk_field_part(field);
    trk_status status = TRK_OK;
    *out_count = 0;
    for (int32_t part = 1; status == TRK_OK && part <= trk_spec_count(spec, kind); part++) {
        double before;
        if (!trk_spec_matches(pattern, trk_spec_part_name(spec, kind, part)))
            continue;
        ++*out_count;
        if (!commit)
            status = trk_spec_check_field(spec, what, field, part, meaning, &before);
        if (status == TRK_OK)
            status = trk_spec_set_field(spec, part, field, meaning, value, spec, part, commit);
    }
    return status;
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
    status = vary(spec, field, pattern, meaning, value, false, &count);
    if (status == TRK_OK && count == 0)
        return trk_fail(context, TRK_E_NAME, "trk_spec_vary: no %s of '%s' is called '%s'",
                        trk_part_word(trk_field_part(field)), spec->name, pattern);
    if (status == TRK_OK)
        status = vary(spec, field, pattern, meaning, value, true, &count);
    if (status == TRK_OK && out_count)
        *out_count = count;
    return status;
}
