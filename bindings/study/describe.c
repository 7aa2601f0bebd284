/* SPDX-License-Identifier: MIT */
/* Roads, parameters and outputs from one word each. */
#include "job.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 512, MOST_POINTS = 64 };

typedef struct choice {
    const char *name;
    int32_t value;
} choice;

/* Value of a name in a list that ends with NULL; -1 if it is not there. */
static int32_t choose(const choice *list, const char *name)
{
    for (; list->name; list++)
        if (strcmp(list->name, name) == 0)
            return list->value;
    return -1;
}

/* The next field of "a:b:c", cut out of the text; NULL at the end. */
static char *next_field(char **rest, char separator)
{
    char *field = *rest;
    if (!field)
        return NULL;
    char *end = strchr(field, separator);
    if (end)
        *end++ = 0;
    *rest = end;
    return field;
}

static bool read_number(const char *text, double *out)
{
    char *end;
    *out = text ? strtod(text, &end) : 0;
    return text && end != text && !*end && isfinite(*out);
}

/* "0.8..1.2" */
static bool read_band(char *text, double *low, double *high)
{
    char *dots = text ? strstr(text, "..") : NULL;
    if (!dots)
        return false;
    *dots = 0;
    return read_number(text, low) && read_number(dots + 2, high);
}

/* Copy "name=rest" and take it apart; false without a name. */
static bool split(const char *text, char copy[TEXT], char **out_name, char **out_rest)
{
    if (strlen(text) >= TEXT)
        return false;
    strcpy(copy, text);
    char *sign = strchr(copy, '=');
    if (!sign || sign == copy || memchr(copy, ':', (size_t)(sign - copy)))
        return false;
    *sign = 0;
    *out_name = copy;
    *out_rest = sign + 1;
    return true;
}

/* Settings of a road by name; each has its place in `value`. */
static bool read_settings(char *rest, const char *const *names, double *value)
{
    char *field;
    while ((field = next_field(&rest, ':'))) {
        char *number = field;
        next_field(&number, '=');
        int k = 0;
        while (names[k] && strcmp(names[k], field) != 0)
            k++;
        if (!names[k] || !read_number(number, &value[k]))
            return false;
    }
    return true;
}

static trk_status create_signal(const job *j, const char *kind, char *rest, bool *out_valid,
                                trk_signal **out)
{
    *out = NULL;
    *out_valid = true;
    if (strcmp(kind, "sweep") == 0) {
        static const char *const names[] = {"from",      "to",       "duration",
                                            "amplitude", "exponent", NULL};
        trk_sweep_options o;
        trk_sweep_options_init(&o, sizeof o);
        double v[] = {o.start_frequency, o.end_frequency, j->study_options.duration, o.amplitude,
                      o.amplitude_exponent};
        *out_valid = read_settings(rest, names, v);
        o.start_frequency = v[0];
        o.end_frequency = v[1];
        o.duration = v[2];
        o.amplitude = v[3];
        o.amplitude_exponent = v[4];
        return *out_valid ? trk_signal_create_sweep(j->context, &o, out) : TRK_OK;
    }
    if (strcmp(kind, "sine") == 0) {
        static const char *const names[] = {"frequency", "amplitude", NULL};
        double v[] = {1.5, 0.01};
        *out_valid = read_settings(rest, names, v);
        return *out_valid ? trk_signal_create_sine(j->context, v[1], v[0], 0, 0, out) : TRK_OK;
    }
    static const char *const names[] = {"start", "length", "height", NULL};
    double v[] = {1, 0.1, 0.05};
    *out_valid = strcmp(kind, "step") == 0 && read_settings(rest, names, v);
    return *out_valid ? trk_signal_create_step(j->context, v[0], v[1], v[2], out) : TRK_OK;
}

/* A random road of ISO 8608 under both tracks, from level ground on; speed in km/h. */
static trk_status add_iso_road(job *j, char *rest, bool *out_valid, trk_excitation *excitation,
                               trk_signal **out_left, trk_signal **out_right)
{
    static const char *const names[] = {"class", "speed", "seed", "waviness", NULL};
    double v[] = {2, 80, 1, 2};
    const double run_in = 20;
    for (char *letter = rest; letter && (letter = strstr(letter, "class=")); letter += 6)
        if (letter[6] >= 'A' && letter[6] <= 'H')
            letter[6] = (char)(letter[6] - 'A' + '1');
    *out_valid = read_settings(rest, names, v) && v[0] == (int)v[0] && v[0] >= 1 && v[0] <= 8 &&
                 v[2] == (int)v[2] && v[1] > 0;
    if (!*out_valid)
        return TRK_OK;
    trk_road_options o;
    trk_road_options_init(&o, sizeof o);
    o.unevenness = trk_road_class_unevenness((int)v[0]);
    o.waviness = v[3];
    o.seed = (int64_t)v[2];
    o.ramp_length = run_in;
    trk_status status = trk_road_create(j->context, &o, out_left, out_right);
    for (int side = 0; status == TRK_OK && side < 2; side++)
        status = trk_excitation_add_profile(excitation, side ? TRK_ROAD_RIGHT : TRK_ROAD_LEFT,
                                            side ? *out_right : *out_left, 1, v[1] / 3.6, 0);
    return status;
}

int job_add_road(job *j, const char *text)
{
    char copy[TEXT], named[TEXT], *name, *rest;
    bool valid = true;
    if (j->roads == JOB_MOST_ROADS || strlen(text) > TEXT - 8)
        return job_usage(j, "too many roads, or too long:", text);
    /* "sweep:from=1" is called sweep */
    snprintf(named, sizeof named, "%s", text);
    if (!split(text, copy, &name, &rest)) {
        snprintf(named, sizeof named, "%.*s=%s", (int)strcspn(text, ":"), text, text);
        if (strlen(named) >= TEXT - 1 || !split(named, copy, &name, &rest))
            return job_usage(j, "this is no road:", text);
    }
    const char *kind = next_field(&rest, ':');
    trk_signal **signal = j->signal[j->roads];
    trk_excitation *excitation = NULL;
    trk_status status = trk_excitation_create(j->context, j->model, &excitation);
    j->excitation[j->roads] = excitation;
    if (status == TRK_OK && strcmp(kind, "iso") == 0) {
        status = add_iso_road(j, rest, &valid, excitation, &signal[0], &signal[1]);
    } else if (status == TRK_OK) {
        status = create_signal(j, kind, rest, &valid, &signal[0]);
        if (status == TRK_OK && valid)
            status = trk_excitation_add_motion(excitation, TRK_ROAD_ALL, signal[0], 1, 0);
    }
    if (status == TRK_OK && !valid)
        return job_usage(j, "this is no road:", text);
    if (status == TRK_OK)
        status = trk_study_add_excitation(j->study, name, j->excitation[j->roads], NULL);
    j->roads++;
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}

/* What may follow the bounds of a parameter. */
static bool read_parameter_setting(char *field, trk_study_parameter_options *o, double *power)
{
    double number, second;
    char *value = field;
    next_field(&value, '=');
    if (strcmp(field, "log") == 0 && !value)
        o->distribution |= TRK_DISTRIBUTION_LOG_UNIFORM;
    else if (strcmp(field, "value") == 0 && !value)
        o->meaning = TRK_MEANING_VALUE;
    else if (strcmp(field, "levels") == 0 && read_number(value, &number))
        o->levels = number >= 1 && number <= 1e6 && number == floor(number) ? (int32_t)number : 0;
    else if (strcmp(field, "power") == 0 && read_number(value, &number))
        *power = number;
    else if (strcmp(field, "normal") == 0 && value) {
        const char *mean = next_field(&value, ',');
        if (!read_number(mean, &number) || !read_number(value, &second))
            return false;
        o->distribution |= TRK_DISTRIBUTION_NORMAL;
        o->mean = number;
        o->deviation = second;
    } else {
        return false;
    }
    return true;
}

int job_add_parameter(job *j, const char *text)
{
    static const choice fields[] = {{"stiffness", TRK_FIELD_STIFFNESS},
                                    {"damping", TRK_FIELD_DAMPING},
                                    {"mass", TRK_FIELD_MASS},
                                    {"inertia", TRK_FIELD_INERTIA},
                                    {"mass_inertia", TRK_FIELD_MASS_INERTIA},
                                    {NULL, 0}};
    char copy[TEXT], *name, *rest, *setting;
    double power = 1;
    int32_t id = 0;
    trk_study_parameter_options o;
    trk_study_parameter_options_init(&o, sizeof o);
    if (!split(text, copy, &name, &rest))
        return job_usage(j, "expected NAME=FIELD:PATTERN:LOW..HIGH, not", text);
    const int32_t field = choose(fields, next_field(&rest, ':'));
    char *patterns = next_field(&rest, ':');
    if (field < 0 || !patterns || !read_band(next_field(&rest, ':'), &o.lower, &o.upper))
        return job_usage(j, "expected NAME=FIELD:PATTERN:LOW..HIGH, not", text);
    while ((setting = next_field(&rest, ':')))
        if (!read_parameter_setting(setting, &o, &power))
            return job_usage(j, "unknown setting of a parameter in", text);
    trk_status status = trk_study_add_parameter(j->study, name, &o, &id);
    char *pattern;
    while (status == TRK_OK && (pattern = next_field(&patterns, ',')))
        status = trk_study_act_on(j->study, id, field, pattern, power, NULL);
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}

/* "4/1,8/1,80/0.1": frequency and weight */
static int64_t read_weight(char *text, double *frequency, double *weight)
{
    int64_t count = 0;
    char *point;
    while ((point = next_field(&text, ','))) {
        char *value = point;
        next_field(&value, '/');
        if (count == MOST_POINTS || !read_number(point, &frequency[count]) ||
            !read_number(value, &weight[count]))
            return 0;
        count++;
    }
    return count;
}

int job_add_output(job *j, const char *text)
{
    static const choice kinds[] = {{"max", TRK_OUTPUT_MAXIMUM},
                                   {"min", TRK_OUTPUT_MINIMUM},
                                   {"peak", TRK_OUTPUT_PEAK},
                                   {"mean", TRK_OUTPUT_MEAN},
                                   {"rms", TRK_OUTPUT_RMS},
                                   {"std", TRK_OUTPUT_DEVIATION},
                                   {"band", TRK_OUTPUT_BAND_RMS},
                                   {"psd_peak", TRK_OUTPUT_PSD_PEAK_FREQUENCY},
                                   {"psd_height", TRK_OUTPUT_PSD_PEAK_HEIGHT},
                                   {"weighted", TRK_OUTPUT_WEIGHTED_RMS},
                                   {NULL, 0}};
    char copy[TEXT], *name, *rest;
    double frequency[MOST_POINTS], weight[MOST_POINTS];
    trk_study_output_options o;
    trk_study_output_options_init(&o, sizeof o);
    if (!split(text, copy, &name, &rest))
        return job_usage(j, "expected NAME=KIND:SENSOR, not", text);
    o.kind = choose(kinds, next_field(&rest, ':'));
    o.sensor = next_field(&rest, ':');
    if (o.kind < 0 || !o.sensor)
        return job_usage(j, "expected NAME=KIND:SENSOR, not", text);
    if (o.kind == TRK_OUTPUT_WEIGHTED_RMS) {
        o.count = read_weight(rest, frequency, weight);
        o.frequency = frequency;
        o.weight = weight;
        if (o.count == 0)
            return job_usage(j, "expected NAME=weighted:SENSOR:HZ/WEIGHT,HZ/WEIGHT,..., not", text);
    } else if (rest && !read_band(rest, &o.low, &o.high)) {
        return job_usage(j, "expected a band LOW..HIGH at the end of", text);
    }
    trk_status status = trk_study_add_output(j->study, name, &o, NULL);
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}
