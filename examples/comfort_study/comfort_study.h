/* SPDX-License-Identifier: MIT */
/* The parts of the comfort study. */
#ifndef COMFORT_STUDY_H
#define COMFORT_STUDY_H

#include "common/common.h"

enum { STANDARD, HARDER, UNDAMPED, DAMPERS };
enum { CLASS_B, CLASS_C, CLASSES };
enum { SPEEDS = 3, CASES = CLASSES * SPEEDS * DAMPERS };
enum { THESIS_DAMPERS, LINEAR, TRUCKS };
enum { CAB_X, CAB_Y, CAB_Z, FRONT_TIRE, REAR_TIRE, FRONT_TRAVEL, REAR_TRAVEL, CHANNELS };
enum { AXLES = 2 };

extern const char *const truck_names[TRUCKS], *const damper_names[DAMPERS];
extern const char *const class_names[CLASSES];
extern const char *const channel_names[CHANNELS];
extern const double speeds[SPEEDS]; /* [km/h] */

/* What is measured of a run: after the truck and the filters have settled [s], for [s]. */
extern const double settling, duration;

/* Samples of a second: waves of the road at the highest speed end at 71 Hz. */
enum { RECORD_EVERY = 4, RATE = 1000 / RECORD_EVERY };

/* A number, and its standard error by chance in a run of the duration. */
typedef struct estimate {
    double value, error;
} estimate;

/* One truck on one road at one speed. */
typedef struct judgement {
    estimate weighted[3];   /* [m/s^2] cab x, y weighted Wd, z Wk                  */
    estimate total;         /* [m/s^2] sum of the three                            */
    double freedoms;        /* [-] degrees of freedom in the mean square of cab z  */
    double vdv;             /* [m/s^1.75] of cab z, for the duration; NaN: no run  */
    estimate load[AXLES];   /* [-] dynamic load coefficient of the left tire       */
    estimate travel[AXLES]; /* [m] RMS of the left spring's travel about its mean  */
    double peak[AXLES];     /* [m] largest travel from the mean; NaN: no run       */
    double lift_off[AXLES]; /* [-] share of time in which the left tire pulls; NaN: no run */
} judgement;

/* The estimates of a judgement one after the other. */
enum {
    WEIGHTED_X,
    WEIGHTED_Y,
    WEIGHTED_Z,
    TOTAL,
    FRONT_DLC,
    REAR_DLC,
    FRONT_RMS,
    REAR_RMS,
    ESTIMATES
};
const estimate *pick(const judgement *j, int which);

typedef struct study {
    judgement driven[TRUCKS][CASES]; /* in time steps                   */
    judgement computed[CASES];       /* the linear truck, from spectra  */
} study;

/* Number of a case; dampers next to each other, as they share a road. */
int case_of(int class, int speed, int damper);

/* A truck with a sensor for each channel, compiled with gravity. */
trk_model *create_truck(trk_context *context, int truck, int damper);

/* Sensor of a channel. */
int32_t sensor_of(const trk_model *model, int channel);

/* Axis of the seat that a channel of the cab stands for. */
trk_axis axis_of(int channel);

/* Load of the left tire of an axle at rest [N]. */
double static_load(const trk_model *model, int axle);

/* A road with a truck on it. */
typedef struct drive {
    trk_signal *left, *right;
    trk_excitation *excitation;
} drive;

void create_drive(trk_context *context, const trk_model *model, int class, int speed, drive *out);
void destroy_drive(drive *d);

/* Frequencies [Hz] step apart that the road excites at a speed: how many, from 0 on. */
int64_t road_frequencies(int speed, double step);

/* Spectra of all wheels of a model at the frequencies k step, k = 1 .. count - 1, as
 * trk_response_psd() takes them, for the caller to free(). */
double *road_spectra(trk_context *context, const trk_model *model, int class, int speed,
                     int64_t count, double step);

/* All cases of a truck, channel after channel of case after case, for the caller to free(). */
double *drive_all(trk_context *context, int truck, int64_t *out_samples);

/* Judge a run: CHANNELS rows of samples. */
void judge_run(trk_context *context, int64_t samples, const double *x, judgement *out);

/* Welch PSD of a settled channel, for the caller to free(). */
double *run_psd(trk_context *context, int64_t count, const double *x, int64_t *out_length,
                double *out_step);

/* Judge a case of the linear truck by its spectra. out_density: PSD of the cab's vertical
 * acceleration at the frequencies k step, for the caller to free(); NULL to skip. */
void judge_spectra(trk_context *context, int class, int speed, int damper, double step,
                   judgement *out, double **out_density);

/* Relative standard error of an RMS from its PSD, whose bins are averages over segments (0: it is
 * exact), and the degrees of freedom of the mean square (NULL: skip). */
double rms_error(int64_t length, const double *density, double step, double segments,
                 double *out_freedoms);

/* Sum of the axes with its error, that of axes which deviate together: the largest there can be. */
void add_axes(trk_context *context, judgement *j);

/* Words of a vibration total value [m/s^2]: "a little uncomfortable / fairly uncomfortable". */
void describe(double total, char *out, size_t size);

void write_table(const study *s, const char *directory);
void write_agreement(const study *s, const char *directory);
void write_findings(const study *s, const char *directory);

/* Spectra of the cab at one speed and class with the standard damper. */
enum { SHOWN_CLASS = CLASS_B, SHOWN_SPEED = 1 };
void write_run_psd(int64_t length, double step, double *const *density, const char *directory);
void write_computed_psd(int64_t length, double step, const double *density, const char *directory);

#endif
