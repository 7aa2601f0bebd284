/* SPDX-License-Identifier: MIT */
/* Shipped vehicles drive over a road of class C at 80 km/h. Needs JSON. */
#include <truckride/excitation.h>
#include <truckride/newmark.h>
#include <truckride/road.h>

#include "shipped.h"

enum { STEPS = 10000, CHUNK = 100 };

typedef struct drive {
    trk_context *context;
    trk_model *model;
    trk_newmark *stepper;
    trk_signal *track[2];
    trk_excitation *road;
    double *force, *mean, *at_rest, *mass, *v, *height, *velocity;
    double energy; /* [J] kinetic, the largest of the run */
} drive;

static double *numbers(int64_t count)
{
    double *block = calloc((size_t)count + 1, sizeof *block);
    assert_non_null(block);
    return block;
}

static void begin(drive *d, trk_context *context, const char *name)
{
    *d = (drive){.context = context, .model = shipped_model(context, name)};
    trk_road_options road;
    trk_road_options_init(&road, sizeof road);
    road.unevenness = trk_road_class_unevenness(TRK_ROAD_CLASS_C);
    road.ramp_length = 20;
    assert_ok(context, trk_road_create(context, &road, &d->track[0], &d->track[1]));
    assert_ok(context, trk_excitation_create(context, d->model, &d->road));
    for (int side = 0; side < 2; side++)
        assert_ok(context,
                  trk_excitation_add_profile(d->road, side ? TRK_ROAD_RIGHT : TRK_ROAD_LEFT,
                                             d->track[side], 1, 80 / 3.6, 0));
    assert_ok(context, trk_newmark_create(context, d->model, NULL, &d->stepper));
    const int32_t n = trk_model_count(d->model, TRK_PART_COORDINATE),
                  links = trk_model_count(d->model, TRK_PART_LINK),
                  roads = trk_model_count(d->model, TRK_PART_ROAD);
    d->at_rest = shipped_static(d->model);
    d->force = numbers(links);
    d->mean = numbers(links);
    d->v = numbers(n);
    d->mass = numbers((int64_t)n * n);
    trk_model_get_mass(d->model, d->mass);
    d->height = numbers((int64_t)CHUNK * roads);
    d->velocity = numbers((int64_t)CHUNK * roads);
}

static void end(drive *d)
{
    free(d->force);
    free(d->mean);
    free(d->at_rest);
    free(d->mass);
    free(d->v);
    free(d->height);
    free(d->velocity);
    trk_newmark_destroy(d->stepper);
    trk_excitation_destroy(d->road);
    trk_signal_destroy(d->track[0]);
    trk_signal_destroy(d->track[1]);
    trk_model_destroy(d->model);
}

static void note_energy(drive *d)
{
    const int32_t n = trk_model_count(d->model, TRK_PART_COORDINATE);
    double energy = 0;
    trk_newmark_get_state(d->stepper, NULL, d->v, NULL);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            energy += d->v[i] * d->mass[i * n + j] * d->v[j] / 2;
    assert_true(isfinite(energy));
    d->energy = fmax(d->energy, energy);
}

static void go(drive *d)
{
    const int32_t links = trk_model_count(d->model, TRK_PART_LINK),
                  roads = trk_model_count(d->model, TRK_PART_ROAD);
    for (int64_t done = 0; done < STEPS; done += CHUNK) {
        const double h = trk_newmark_step_size(d->stepper), start = (double)(done + 1) * h;
        trk_excitation_evaluate(d->road, CHUNK, start, h, d->height, d->velocity, NULL);
        for (int k = 0; k < CHUNK; k++) {
            assert_ok(d->context, trk_newmark_step(d->stepper, d->height + k * roads,
                                                   d->velocity + k * roads, NULL));
            trk_newmark_get_links(d->stepper, NULL, NULL, d->force);
            for (int32_t link = 0; link < links; link++)
                d->mean[link] += d->force[link] / STEPS;
        }
        note_energy(d);
    }
}

static void ten_seconds_of_class_c(void **state)
{
    for (int k = 0; k < SHIPPED; k++) {
        drive d;
        begin(&d, *state, shipped_name[k]);
        go(&d);
        assert_true(d.energy > 10 && d.energy < 1e4); /* as 10 t at 1.4 m/s */
        double load = 0, change = 0;
        for (int32_t link = 1; link <= trk_model_count(d.model, TRK_PART_LINK); link++)
            if (shipped_is_tire(d.model, link)) {
                assert_true(d.mean[link - 1] < 0);
                load -= d.at_rest[link - 1];
                change += d.mean[link - 1] - d.at_rest[link - 1];
            }
        assert_near(change / load, 0, 0.02);
        end(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(ten_seconds_of_class_c, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
