/* SPDX-License-Identifier: MIT */
/* Calibration by words. */
#ifndef TRUCKRIDE_CLI_CALIBRATE_H
#define TRUCKRIDE_CLI_CALIBRATE_H

#include "run.h"
#include "table.h"

/* Add what one word describes (calibrate_words.c); EXIT_DONE or the exit code. */
int calibrate_parameter(session *s, trk_calibration *calibration, const char *text);
int calibrate_target(session *s, trk_calibration *calibration, const char *text,
                     bool *out_needs_run);

#endif
