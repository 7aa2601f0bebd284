/* SPDX-License-Identifier: MIT */
/* Parameters and targets from one word each. */
#include "calibrate.h"
#include "common/text.h"
#include "common/vehicle.h"

#include <stdlib.h>
#include <string.h>

static int no_parameter(session *s, const char *text)
{
    return session_usage(s,
                         "a parameter is PATTERN[,PATTERN...]:FIELD:LOW..HIGH[:start=X][:value]"
                         "[:name=NAME], not '%s'",
                         text);
}

/* What may follow the bounds. */
static bool read_setting(char *field, trk_parameter_options *o, const char **name)
{
    char *value = field;
    text_field(&value, '=');
    if (strcmp(field, "start") == 0)
        return text_number(value, &o->start);
    if (strcmp(field, "name") == 0 && value)
        return *name = value, true;
    if (strcmp(field, "value") != 0 || value)
        return false;
    o->meaning = TRK_MEANING_VALUE;
    return true;
}

static int add_parameter(session *s, trk_calibration *calibration, const char *text, char *rest)
{
    trk_parameter_options o;
    const char *name = text, *pattern;
    char *patterns = text_field(&rest, ':'), *setting;
    const char *field = text_field(&rest, ':');
    const int place = field ? text_index(vehicle_fields, field) : -1;
    int32_t id = 0;
    bool started = false;
    trk_parameter_options_init(&o, sizeof o);
    if (field && place < 0 && text_nearest(vehicle_fields, field))
        return session_usage(s, "there is no field '%s'; did you mean '%s'?", field,
                             text_nearest(vehicle_fields, field));
    if (place < 0 || !text_band(text_field(&rest, ':'), &o.lower, &o.upper))
        return no_parameter(s, text);
    while ((setting = text_field(&rest, ':'))) {
        started = started || strncmp(setting, "start=", 6) == 0;
        if (!read_setting(setting, &o, &name))
            return no_parameter(s, text);
    }
    if (!started && (o.meaning == TRK_MEANING_VALUE || o.start < o.lower || o.start > o.upper))
        o.start = (o.lower + o.upper) / 2;
    trk_status status = trk_calibration_add_parameter(calibration, name, &o, &id);
    while (status == TRK_OK && (pattern = text_field(&patterns, ',')))
        status =
            trk_calibration_act_on(calibration, id, TRK_FIELD_STIFFNESS + place, pattern, 1, NULL);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}

int calibrate_parameter(session *s, trk_calibration *calibration, const char *text)
{
    char *copy = text_copy(text);
    const int code = add_parameter(s, calibration, text, copy);
    free(copy);
    return code;
}

static int no_target(session *s, const char *text)
{
    return session_usage(s,
                         "a target is COORDINATE=HZ, damped:COORDINATE=HZ, ratio:COORDINATE=X or "
                         "peak:SENSOR:LOW..HIGH=HZ, then [:uncertainty=X][:weight=X], not '%s'",
                         text);
}

/* "peak:cab_z:8..20" before the sign; names of coordinates have no colon. */
static bool read_subject(char *subject, trk_target_options *o)
{
    static const char *const kinds[] = {"undamped", "damped", "ratio", "peak", NULL};
    char *rest = subject;
    const char *name = text_field(&rest, ':');
    const int kind = rest ? text_index(kinds, name) : 0;
    if (kind < 0)
        return false;
    name = rest ? text_field(&rest, ':') : name;
    o->kind = TRK_TARGET_UNDAMPED_FREQUENCY + kind;
    if (o->kind == TRK_TARGET_PSD_PEAK) {
        o->sensor = name;
        return *name && text_band(rest, &o->low, &o->high);
    }
    o->coordinate = name;
    return *name && !rest;
}

static int add_target(session *s, trk_calibration *calibration, const char *text, char *subject,
                      bool *out_needs_run)
{
    static const char *const names[] = {"uncertainty", "weight", NULL};
    trk_target_options o;
    char *rest = strchr(subject, '='), *setting;
    trk_target_options_init(&o, sizeof o);
    if (!rest)
        return no_target(s, text);
    *rest++ = 0;
    if (!text_number(text_field(&rest, ':'), &o.value) || !read_subject(subject, &o))
        return no_target(s, text);
    while ((setting = text_field(&rest, ':'))) {
        char *value = setting;
        text_field(&value, '=');
        const int k = text_index(names, setting);
        if (k < 0 || !text_number(value, k ? &o.weight : &o.uncertainty))
            return no_target(s, text);
    }
    *out_needs_run = *out_needs_run || o.kind == TRK_TARGET_PSD_PEAK;
    const trk_status status = trk_calibration_add_target(calibration, text, &o, NULL);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}

int calibrate_target(session *s, trk_calibration *calibration, const char *text,
                     bool *out_needs_run)
{
    char *copy = text_copy(text);
    const int code = add_target(s, calibration, text, copy, out_needs_run);
    free(copy);
    return code;
}
