/* SPDX-License-Identifier: MIT */
/* The table of a study (CSV, RFC 4180, lines ended by a line feed). */
#define _POSIX_C_SOURCE 200809L
#include "study/study.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

/* name, or name [unit], quoted where a reader would take it apart otherwise */
static void put_label(FILE *file, const char *name, const char *unit)
{
    const bool quoted = strpbrk(name, ",\"\r\n") != NULL;
    if (quoted)
        putc('"', file);
    for (; *name; name++) {
        if (*name == '"')
            putc('"', file);
        putc(*name, file);
    }
    if (unit)
        fprintf(file, " [%s]", unit);
    if (quoted)
        putc('"', file);
}

static void put_number(FILE *file, double number)
{
    if (isnan(number)) /* printf may write a sign */
        fputs(",nan", file);
    else
        fprintf(file, ",%.17g", number);
}

static void put_heading(FILE *file, const trk_study *study)
{
    fputs("case,road", file);
    for (int32_t k = 1; k <= trk_study_parameters(study); k++) {
        putc(',', file);
        put_label(file, trk_study_part_name(study, TRK_STUDY_PARAMETER, k), NULL);
    }
    for (int32_t k = 1; k <= trk_study_outputs(study); k++) {
        putc(',', file);
        put_label(file, trk_study_part_name(study, TRK_STUDY_OUTPUT, k),
                  trk_study_output_unit(study, k));
    }
    fputs(",status\n", file);
}

static void put_case(FILE *file, const trk_study *study, int64_t number, double *parameters)
{
    int32_t road;
    (void)!trk_study_get_case(study, number, parameters, &road);
    fprintf(file, "%" PRId64 ",", number);
    put_label(file, trk_study_part_name(study, TRK_STUDY_EXCITATION, road), NULL);
    for (int32_t k = 0; k < trk_study_parameters(study); k++)
        put_number(file, parameters[k]);
    for (int32_t k = 0; k < trk_study_outputs(study); k++)
        put_number(file, study->values[number * trk_study_outputs(study) + k]);
    fprintf(file, ",%" PRId32 "\n", study->state[number] - 1);
}

/* Close, and take back an incomplete file; a device or a pipe stays where it is. The first
 * error of both, 0 if none. */
static int finish(FILE *file, const char *path)
{
    struct stat about;
    const bool regular = fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode);
    int error = ferror(file) ? (errno ? errno : EIO) : 0;
    if (fclose(file) != 0 && !error)
        error = errno ? errno : EIO;
    if (error && regular)
        remove(path);
    return error;
}

trk_status trk_study_write_csv(trk_study *study, const char *path)
{
    TRK_REQUIRE(NULL, study, "trk_study_write_csv");
    trk_context *context = study->context;
    TRK_REQUIRE(context, path, "trk_study_write_csv");
    double *parameters = trk_new(context, trk_study_parameters(study), sizeof *parameters);
    if (!parameters)
        return TRK_E_MEMORY;
    trk_locale locale; /* for the numbers, and for the system's reason below */
    trk_locale_enter(&locale);
    errno = 0;
    FILE *file = fopen(path, "wb");
    int error = file ? 0 : errno;
    if (file) {
        put_heading(file, study);
        for (int64_t k = 0; study->ready && !ferror(file) && k < trk_study_cases(study); k++)
            if (study->state[k])
                put_case(file, study, k, parameters);
        error = finish(file, path);
    }
    trk_status status = TRK_OK;
    if (error) {
        char reason[256] = "";
        strerror_r(error, reason, sizeof reason);
        status = trk_fail(context, TRK_E_FILE, "%s: cannot be written (%s)", path, reason);
    }
    trk_locale_leave(&locale);
    trk_free(context, parameters);
    return status;
}
