/* SPDX-License-Identifier: MIT */
/* The roads, as heights to drive over and as spectra. */
#include "comfort_study.h"

#include <math.h>
#include <stdlib.h>

const char *const class_names[CLASSES] = {"B", "C"};
const double speeds[SPEEDS] = {50, 70, 90};

static const trk_road_class classes[CLASSES] = {TRK_ROAD_CLASS_B, TRK_ROAD_CLASS_C};

/* Each speed has a road of its own, all dampers and both classes the same one: what differs
 * between them is the truck, not chance. */
static void shape_road(int class, int speed, trk_road_options *out)
{
    trk_road_options_init(out, sizeof *out);
    out->unevenness = trk_road_class_unevenness(classes[class]);
    out->seed = 8608 + speed;
    out->track_width = 2.066;
    out->contact_length = 0.2;
    out->ramp_start = 10;
    out->ramp_length = 50;
}

static double metres_per_second(int speed)
{
    return speeds[speed] / 3.6;
}

void create_drive(trk_context *context, const trk_model *model, int class, int speed, drive *out)
{
    trk_road_options shape;
    double v = metres_per_second(speed);
    shape_road(class, speed, &shape);
    check(context, trk_road_create(context, &shape, &out->left, &out->right));
    check(context, trk_excitation_create(context, model, &out->excitation));
    check(context, trk_excitation_add_profile(out->excitation, TRK_ROAD_LEFT, out->left, 1, v, 0));
    check(context,
          trk_excitation_add_profile(out->excitation, TRK_ROAD_RIGHT, out->right, 1, v, 0));
}

void destroy_drive(drive *d)
{
    trk_excitation_destroy(d->excitation);
    trk_signal_destroy(d->left);
    trk_signal_destroy(d->right);
}

int64_t road_frequencies(int speed, double step)
{
    trk_road_options shape;
    shape_road(CLASS_B, speed, &shape);
    return (int64_t)ceil(shape.high * metres_per_second(speed) / step) + 1;
}

double *road_spectra(trk_context *context, const trk_model *model, int class, int speed,
                     int64_t count, double step)
{
    trk_road_options shape;
    size_t lines = (size_t)count - 1, block = lines * sizeof(double);
    size_t inputs =
        (size_t)(trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT));
    double v = metres_per_second(speed), *frequency = allocate(block),
           *wavenumber = allocate(block);
    double *density = allocate(block), *coherence = allocate(block);
    double *input = allocate(2 * inputs * inputs * block);
    shape_road(class, speed, &shape);
    for (size_t k = 0; k < lines; k++) {
        frequency[k] = (double)(k + 1) * step;
        wavenumber[k] = frequency[k] / v;
    }
    check(context, trk_road_density(context, &shape, count - 1, wavenumber, density));
    check(context, trk_road_coherence(context, &shape, count - 1, wavenumber, coherence));
    for (size_t k = 0; k < lines; k++)
        density[k] /= v; /* m^3, over cycles/m, to m^2/Hz */
    check(context, trk_road_cross_spectra(context, model, count - 1, frequency, density, v,
                                          coherence, input));
    free(frequency);
    free(wavenumber);
    free(density);
    free(coherence);
    return input;
}
