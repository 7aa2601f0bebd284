/* SPDX-License-Identifier: MIT */
/* Lines of a journal (STUDY.10). */
#ifndef TRK_STUDY_LINE_H
#define TRK_STUDY_LINE_H

#include "study/study.h"

/* Room that a line of this study needs, the line feed and a 0 included. */
int64_t trk_line_room(const trk_study *study);

/* The first line, and that of a finished case; the length, line feed included. The caller
 * has entered the C locale. */
int64_t trk_line_header(const trk_study *study, char *out);
int64_t trk_line_case(const trk_study *study, int64_t number, char *out);

/* What a line turned out to be. */
typedef enum trk_line_kind { TRK_LINE_GOOD, TRK_LINE_DAMAGED, TRK_LINE_FOREIGN } trk_line_kind;

/* Read lines without their line feed, 0-terminated; they are changed. */
trk_line_kind trk_line_read_header(const trk_study *study, char *line);
trk_line_kind trk_line_read_case(const trk_study *study, char *line, int64_t *out_number,
                                 trk_status *out_status, double *out_values);

#endif
