/* SPDX-License-Identifier: MIT */
/* Writing and reading the lines of a journal. */
#include "study/line.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char magic[] = "truckride-study-journal 1 ";

/* FNV-1a, 64 bit: a change of any one byte changes it. */
static uint64_t checksum(uint64_t seed, size_t length, const char *text)
{
    uint64_t h = UINT64_C(14695981039346656037) ^ seed;
    for (size_t k = 0; k < length; k++)
        h = (h ^ (unsigned char)text[k]) * UINT64_C(1099511628211);
    return h;
}

int64_t trk_line_room(const trk_study *study)
{
    /* case, status and checksum; a number takes at most 24 characters and a blank */
    return 128 + 25 * (int64_t)trk_study_outputs(study);
}

/* Add the checksum of what stands there. */
static int64_t close_line(char *out, int64_t length, int64_t room, uint64_t seed)
{
    const uint64_t sum = checksum(seed, (size_t)length, out);
    return length + snprintf(out + length, (size_t)(room - length), " %016" PRIx64 "\n", sum);
}

int64_t trk_line_header(const trk_study *study, char *out)
{
    const int64_t room = trk_line_room(study);
    const int length = snprintf(out, (size_t)room, "%s%016" PRIx64 " %" PRId32, magic,
                                study->fingerprint, trk_study_outputs(study));
    return close_line(out, length, room, 0);
}

int64_t trk_line_case(const trk_study *study, int64_t number, char *out)
{
    const int64_t room = trk_line_room(study);
    const int32_t outputs = trk_study_outputs(study);
    const double *values = study->values + number * outputs;
    int64_t length =
        snprintf(out, (size_t)room, "%" PRId64 " %" PRId32, number, study->state[number] - 1);
    for (int32_t k = 0; k < outputs; k++) {
        if (isnan(values[k])) /* printf may write a sign */
            length += snprintf(out + length, (size_t)(room - length), " nan");
        else
            length += snprintf(out + length, (size_t)(room - length), " %.17g", values[k]);
    }
    return close_line(out, length, room, study->fingerprint);
}

/* Cut the checksum off; false if it is not that of the rest. */
static bool open_line(char *line, uint64_t seed)
{
    char *last = strrchr(line, ' ');
    if (!last || strlen(last + 1) != 16 || strspn(last + 1, "0123456789abcdef") != 16)
        return false;
    *last = 0;
    return strtoull(last + 1, NULL, 16) == checksum(seed, (size_t)(last - line), line);
}

trk_line_kind trk_line_read_header(const trk_study *study, char *line)
{
    char own[192];
    if (!open_line(line, 0) || strncmp(line, magic, sizeof magic - 1) != 0)
        return TRK_LINE_DAMAGED;
    snprintf(own, sizeof own, "%s%016" PRIx64 " %" PRId32, magic, study->fingerprint,
             trk_study_outputs(study));
    return strcmp(line, own) == 0 ? TRK_LINE_GOOD : TRK_LINE_FOREIGN;
}

/* One whole number and the blank or end behind it. */
static bool read_integer(char **at, int64_t *out)
{
    char *end;
    errno = 0;
    if (strspn(*at, "0123456789") == 0)
        return false;
    const long long value = strtoll(*at, &end, 10);
    if (errno || (*end && *end != ' '))
        return false;
    *at = *end ? end + 1 : end;
    *out = value;
    return true;
}

static bool read_number(char **at, double *out)
{
    char *end;
    if (strspn(*at, "-+.0123456789enai") == 0) /* neither blanks nor hexadecimal */
        return false;
    *out = strtod(*at, &end);
    if (end == *at || (*end && *end != ' ') || isinf(*out))
        return false;
    *at = *end ? end + 1 : end;
    return true;
}

trk_line_kind trk_line_read_case(const trk_study *study, char *line, int64_t *out_number,
                                 trk_status *out_status, double *out_values)
{
    int64_t status;
    if (!open_line(line, study->fingerprint))
        return TRK_LINE_DAMAGED;
    if (!read_integer(&line, out_number) || !read_integer(&line, &status) || status > INT32_MAX ||
        !trk_study_is_outcome((trk_status)status))
        return TRK_LINE_DAMAGED;
    *out_status = (trk_status)status;
    for (int32_t k = 0; k < trk_study_outputs(study); k++)
        if (!read_number(&line, &out_values[k]))
            return TRK_LINE_DAMAGED;
    if (*line)
        return TRK_LINE_DAMAGED;
    return *out_number < trk_study_cases(study) ? TRK_LINE_GOOD : TRK_LINE_FOREIGN;
}
