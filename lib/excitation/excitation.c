/* SPDX-License-Identifier: MIT */
/* Signals routed to road inputs and force ports (EXCITATION.1). */
#include "signal/signal.h"

#include <truckride/excitation.h>

#include <math.h>
#include <string.h>

/* A signal read at offset + rate t; inputs that share it are evaluated once. */
typedef struct source {
    const trk_signal *signal; /* borrowed */
    double offset, rate;
} source;

/* Where a source goes: a road input or, counted behind those, a force port. */
typedef struct route {
    int32_t source, target;
    double gain;
} route;

struct trk_excitation {
    trk_context *context;
    int32_t roads, ports;
    double *road_x, *road_y;
    source *sources;
    route *routes;
    int32_t source_count, route_count;
    int64_t source_capacity, route_capacity;
};

trk_status trk_excitation_create(trk_context *context, const trk_model *model,
                                 trk_excitation **out_excitation)
{
    TRK_REQUIRE(context, out_excitation, "trk_excitation_create");
    *out_excitation = NULL;
    TRK_REQUIRE(context, context, "trk_excitation_create");
    TRK_REQUIRE(context, model, "trk_excitation_create");
    trk_excitation *excitation = trk_new(context, 1, sizeof *excitation);
    if (!excitation)
        return TRK_E_MEMORY;
    excitation->context = context;
    excitation->roads = trk_model_count(model, TRK_PART_ROAD);
    excitation->ports = trk_model_count(model, TRK_PART_PORT);
    excitation->road_x = trk_new(context, excitation->roads, sizeof(double));
    excitation->road_y = trk_new(context, excitation->roads, sizeof(double));
    if (!excitation->road_x || !excitation->road_y) {
        trk_excitation_destroy(excitation);
        return TRK_E_MEMORY;
    }
    for (int32_t k = 0; k < excitation->roads; k++)
        (void)!trk_model_get_road_place(model, k + 1, &excitation->road_x[k],
                                        &excitation->road_y[k]);
    *out_excitation = excitation;
    return TRK_OK;
}

void trk_excitation_destroy(trk_excitation *excitation)
{
    if (!excitation)
        return;
    trk_free(excitation->context, excitation->road_x);
    trk_free(excitation->context, excitation->road_y);
    trk_free(excitation->context, excitation->sources);
    trk_free(excitation->context, excitation->routes);
    trk_free(excitation->context, excitation);
}

/* Room for more routes is made before anything is added, so that nothing is half done. */
static trk_status reserve(trk_excitation *excitation, int32_t more)
{
    trk_status status =
        trk_grow(excitation->context, (void **)&excitation->sources, &excitation->source_capacity,
                 (int64_t)excitation->source_count + more, sizeof *excitation->sources);
    if (status == TRK_OK)
        status =
            trk_grow(excitation->context, (void **)&excitation->routes, &excitation->route_capacity,
                     (int64_t)excitation->route_count + more, sizeof *excitation->routes);
    return status;
}

static void add_route(trk_excitation *excitation, const trk_signal *signal, double offset,
                      double rate, int32_t target, double gain)
{
    int32_t k = 0;
    for (; k < excitation->source_count; k++) {
        const source *s = &excitation->sources[k];
        if (s->signal == signal && s->offset == offset && s->rate == rate)
            break;
    }
    if (k == excitation->source_count)
        excitation->sources[excitation->source_count++] = (source){signal, offset, rate};
    excitation->routes[excitation->route_count++] = (route){k, target, gain};
}

static bool selects(int32_t road, int32_t k, double y)
{
    return road == k + 1 || road == TRK_ROAD_ALL || (road == TRK_ROAD_LEFT && y >= 0) ||
           (road == TRK_ROAD_RIGHT && y < 0);
}

/* `shift` is the delay or the start. */
static trk_status check(const trk_excitation *excitation, const char *what, int32_t id,
                        int32_t first, int32_t count, double gain, const char *shift_name,
                        double shift)
{
    if (id < first || id > count || id == 0)
        return trk_fail(excitation->context, TRK_E_ARGUMENT,
                        "excitation: there is no %s %d (1 to %d)", what, id, count);
    if (!isfinite(gain))
        return trk_fail(excitation->context, TRK_E_RANGE,
                        "excitation: gain is %g; a finite number is needed", gain);
    if (!isfinite(shift))
        return trk_fail(excitation->context, TRK_E_RANGE,
                        "excitation: %s is %g; a finite number is needed", shift_name, shift);
    return TRK_OK;
}

/* Add a signal at offset + along x + rate t to the roads that `road` selects. */
static trk_status add_roads(trk_excitation *excitation, int32_t road, const trk_signal *signal,
                            double gain, double offset, double along, double rate)
{
    bool any = false;
    for (int32_t k = 0; k < excitation->roads; k++)
        any |= selects(road, k, excitation->road_y[k]);
    if (!any)
        return trk_fail(excitation->context, TRK_E_ARGUMENT, "excitation: no road lies %s",
                        road == TRK_ROAD_RIGHT  ? "on the right, y < 0"
                        : road == TRK_ROAD_LEFT ? "on the left, y >= 0"
                                                : "anywhere: the model has none");
    trk_status status = reserve(excitation, excitation->roads);
    if (status != TRK_OK)
        return status;
    for (int32_t k = 0; k < excitation->roads; k++)
        if (selects(road, k, excitation->road_y[k]))
            add_route(excitation, signal, offset + along * excitation->road_x[k], rate, k, gain);
    return TRK_OK;
}

static trk_status check_road(const trk_excitation *excitation, int32_t road, double gain,
                             const char *shift_name, double shift)
{
    return check(excitation, "road", road, TRK_ROAD_RIGHT, excitation->roads, gain, shift_name,
                 shift);
}

trk_status trk_excitation_add_motion(trk_excitation *excitation, int32_t road,
                                     const trk_signal *signal, double gain, double delay)
{
    TRK_REQUIRE(NULL, excitation, "trk_excitation_add_motion");
    TRK_REQUIRE(excitation->context, signal, "trk_excitation_add_motion");
    trk_status status = check_road(excitation, road, gain, "delay", delay);
    return status == TRK_OK ? add_roads(excitation, road, signal, gain, -delay, 0, 1) : status;
}

trk_status trk_excitation_add_profile(trk_excitation *excitation, int32_t road,
                                      const trk_signal *profile, double gain, double speed,
                                      double start)
{
    TRK_REQUIRE(NULL, excitation, "trk_excitation_add_profile");
    TRK_REQUIRE(excitation->context, profile, "trk_excitation_add_profile");
    if (!isfinite(speed) || speed <= 0)
        return trk_fail(excitation->context, TRK_E_RANGE,
                        "excitation: speed is %g m/s; a finite number > 0 is needed", speed);
    trk_status status = check_road(excitation, road, gain, "start", start);
    return status == TRK_OK ? add_roads(excitation, road, profile, gain, start, 1, speed) : status;
}

trk_status trk_excitation_add_load(trk_excitation *excitation, int32_t port,
                                   const trk_signal *signal, double gain, double delay)
{
    TRK_REQUIRE(NULL, excitation, "trk_excitation_add_load");
    TRK_REQUIRE(excitation->context, signal, "trk_excitation_add_load");
    trk_status status =
        check(excitation, "force port", port, 1, excitation->ports, gain, "delay", delay);
    if (status == TRK_OK)
        status = reserve(excitation, 1);
    if (status == TRK_OK)
        add_route(excitation, signal, -delay, 1, excitation->roads + port - 1, gain);
    return status;
}

int32_t trk_excitation_roads(const trk_excitation *excitation)
{
    return excitation ? excitation->roads : 0;
}

int32_t trk_excitation_ports(const trk_excitation *excitation)
{
    return excitation ? excitation->ports : 0;
}

/* out[k stride + target] += gain values[k] */
static void spread(int64_t count, double gain, const double *values, int32_t stride, int32_t target,
                   double *out)
{
    for (int64_t k = 0; out && k < count; k++)
        out[k * stride + target] += gain * values[k];
}

/* Values of one block, count <= TRK_SIGNAL_BLOCK, added to rows of roads, roads and ports. */
static void add_block(const trk_excitation *excitation, int64_t count, const double *t,
                      double *height, double *velocity, double *load)
{
    double x[TRK_SIGNAL_BLOCK], value[TRK_SIGNAL_BLOCK], rate[TRK_SIGNAL_BLOCK];
    int32_t roads = excitation->roads, ports = excitation->ports;
    for (int32_t k = 0; k < excitation->source_count; k++) {
        const source *s = &excitation->sources[k];
        for (int64_t j = 0; j < count; j++)
            x[j] = s->offset + s->rate * t[j];
        s->signal->kind->evaluate(s->signal, count, x, value, rate);
        for (int32_t r = 0; r < excitation->route_count; r++) {
            const route *to = &excitation->routes[r];
            if (to->source != k)
                continue;
            if (to->target < roads) {
                spread(count, to->gain, value, roads, to->target, height);
                spread(count, to->gain * s->rate, rate, roads, to->target, velocity);
            } else {
                spread(count, to->gain, value, ports, to->target - roads, load);
            }
        }
    }
}

void trk_excitation_evaluate(const trk_excitation *excitation, int64_t count, double start,
                             double step, double *out_height, double *out_velocity,
                             double *out_load)
{
    double t[TRK_SIGNAL_BLOCK];
    if (!excitation || count < 1)
        return;
    int32_t roads = excitation->roads, ports = excitation->ports;
    if (out_height)
        memset(out_height, 0, (size_t)count * (size_t)roads * sizeof *out_height);
    if (out_velocity)
        memset(out_velocity, 0, (size_t)count * (size_t)roads * sizeof *out_velocity);
    if (out_load)
        memset(out_load, 0, (size_t)count * (size_t)ports * sizeof *out_load);
    for (int64_t first = 0; first < count; first += TRK_SIGNAL_BLOCK) {
        int64_t length = count - first < TRK_SIGNAL_BLOCK ? count - first : TRK_SIGNAL_BLOCK;
        /* Values depend on their time alone, not on the place in a block. */
        for (int64_t j = 0; j < length; j++)
            t[j] = start + (double)(first + j) * step;
        add_block(excitation, length, t, out_height ? out_height + first * roads : NULL,
                  out_velocity ? out_velocity + first * roads : NULL,
                  out_load ? out_load + first * ports : NULL);
    }
}
