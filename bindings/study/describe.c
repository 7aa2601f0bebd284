/* SPDX-License-Identifier: MIT */
/* Roads, parameters and outputs from one word each. */
#include "common/text.h"
#include "common/vehicle.h"
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

/* "sweep:from=1" is called sweep, "kerb=step" kerb. */
static bool name_road(const char *text, char copy[TEXT], char **out_name, char **out_road)
{
    char named[TEXT];
    if (split(text, copy, out_name, out_road))
        return true;
    const int length =
        snprintf(named, sizeof named, "%.*s=%s", (int)strcspn(text, ":"), text, text);
    return length < TEXT && split(named, copy, out_name, out_road);
}

int job_add_road(job *j, const char *text)
{
    char copy[TEXT], *name, *word;
    complaint wrong;
    trk_status status;
    if (j->roads == JOB_MOST_ROADS || !name_road(text, copy, &name, &word))
        return job_usage(j, "too many roads, or no road:", text);
    road *r = &j->road[j->roads++];
    if (!road_open(j->context, j->model, word, j->study_options.duration, r, &wrong, &status)) {
        if (!wrong.text[0])
            return job_complain(j, status);
        fprintf(stderr, "%s: %s, in '%s' (see %s --help)\n", j->program, wrong.text, text,
                j->program);
        return JOB_USAGE;
    }
    status = trk_study_add_excitation(j->study, name, r->excitation, NULL);
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}

/* What may follow the bounds of a parameter. */
static bool read_parameter_setting(char *field, trk_study_parameter_options *o, double *power)
{
    double number, second;
    char *value = field;
    text_field(&value, '=');
    if (strcmp(field, "log") == 0 && !value)
        o->distribution |= TRK_DISTRIBUTION_LOG_UNIFORM;
    else if (strcmp(field, "value") == 0 && !value)
        o->meaning = TRK_MEANING_VALUE;
    else if (strcmp(field, "levels") == 0 && text_number(value, &number))
        o->levels = number >= 1 && number <= 1e6 && number == floor(number) ? (int32_t)number : 0;
    else if (strcmp(field, "power") == 0 && text_number(value, &number))
        *power = number;
    else if (strcmp(field, "normal") == 0 && value) {
        const char *mean = text_field(&value, ',');
        if (!text_number(mean, &number) || !text_number(value, &second))
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
    char copy[TEXT], *name, *rest, *setting;
    double power = 1;
    int32_t id = 0;
    trk_study_parameter_options o;
    trk_study_parameter_options_init(&o, sizeof o);
    if (!split(text, copy, &name, &rest))
        return job_usage(j, "expected NAME=FIELD:PATTERN:LOW..HIGH, not", text);
    const int32_t field = TRK_FIELD_STIFFNESS + text_index(vehicle_fields, text_field(&rest, ':'));
    char *patterns = text_field(&rest, ':');
    if (field < TRK_FIELD_STIFFNESS || !patterns ||
        !text_band(text_field(&rest, ':'), &o.lower, &o.upper))
        return job_usage(j, "expected NAME=FIELD:PATTERN:LOW..HIGH, not", text);
    while ((setting = text_field(&rest, ':')))
        if (!read_parameter_setting(setting, &o, &power))
            return job_usage(j, "unknown setting of a parameter in", text);
    trk_status status = trk_study_add_parameter(j->study, name, &o, &id);
    char *pattern;
    while (status == TRK_OK && (pattern = text_field(&patterns, ',')))
        status = trk_study_act_on(j->study, id, field, pattern, power, NULL);
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}

/* "4/1,8/1,80/0.1": frequency and weight */
static int64_t read_weight(char *text, double *frequency, double *weight)
{
    int64_t count = 0;
    char *point;
    while ((point = text_field(&text, ','))) {
        char *value = point;
        text_field(&value, '/');
        if (count == MOST_POINTS || !text_number(point, &frequency[count]) ||
            !text_number(value, &weight[count]))
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
    o.kind = choose(kinds, text_field(&rest, ':'));
    o.sensor = text_field(&rest, ':');
    if (o.kind < 0 || !o.sensor)
        return job_usage(j, "expected NAME=KIND:SENSOR, not", text);
    if (o.kind == TRK_OUTPUT_WEIGHTED_RMS) {
        o.count = read_weight(rest, frequency, weight);
        o.frequency = frequency;
        o.weight = weight;
        if (o.count == 0)
            return job_usage(j, "expected NAME=weighted:SENSOR:HZ/WEIGHT,HZ/WEIGHT,..., not", text);
    } else if (rest && !text_band(rest, &o.low, &o.high)) {
        return job_usage(j, "expected a band LOW..HIGH at the end of", text);
    }
    trk_status status = trk_study_add_output(j->study, name, &o, NULL);
    return status == TRK_OK ? JOB_DONE : job_complain(j, status);
}
