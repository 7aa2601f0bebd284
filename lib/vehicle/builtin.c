/* SPDX-License-Identifier: MIT */
/* Built-in vehicles: parameters and curves put together. */
#include "vehicle/parameters.h"

#include <truckride/model.h>

#include <string.h>

/* Lengths of the reference tractor's axle springs [m]: free, and where the bump stop touches. */
static const double free_length[2] = {0.667, 0.633}, stop_length[2] = {0.335, 0.380};

/* Curves that a parameter struct borrows while a spec is made. */
typedef struct curves {
    trk_curve *spring[2], *damper[2], *cab_spring[2], *cab_damper[2], *bump_stop;
} curves;

static void destroy_curves(curves *c)
{
    for (int end = 0; end < 2; end++) {
        trk_curve_destroy(c->spring[end]);
        trk_curve_destroy(c->damper[end]);
        trk_curve_destroy(c->cab_spring[end]);
        trk_curve_destroy(c->cab_damper[end]);
    }
    trk_curve_destroy(c->bump_stop);
}

/* Create a curve unless something failed before. */
static void create_curve(trk_context *context, trk_status *status, trk_table table, trk_curve **out)
{
    if (*status == TRK_OK)
        *status = trk_vehicle_create_curve(context, table, NULL, out);
}

/* Curves replace the linear dampers of axles and vertical cab mounts. */
static void use_dampers(trk_truck_parameters *p, const curves *c)
{
    memset(p->damping, 0, sizeof p->damping);
    memset(p->cab_vertical_damping, 0, sizeof p->cab_vertical_damping);
    for (int end = 0; end < 2; end++) {
        p->damper_curve[end] = c->damper[end];
        p->cab_damper_curve[end] = c->cab_damper[end];
    }
}

static trk_status set_thesis_dampers(trk_context *context, trk_truck_parameters *p, curves *c)
{
    trk_status status = TRK_OK;
    create_curve(context, &status, TRK_TABLE_THESIS_FRONT_AXLE_DAMPER, &c->damper[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_THESIS_REAR_AXLE_DAMPER, &c->damper[TRK_REAR]);
    create_curve(context, &status, TRK_TABLE_THESIS_FRONT_CAB_DAMPER, &c->cab_damper[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_THESIS_REAR_CAB_DAMPER, &c->cab_damper[TRK_REAR]);
    use_dampers(p, c);
    return status;
}

/* Places on the spring curves where each carries its static load. */
static trk_status find_offsets(trk_context *context, trk_truck_parameters *p, const curves *c)
{
    double axle[2], cab[2];
    trk_truck_axle_share(p, axle);
    trk_truck_cab_share(p, cab);
    trk_status status = TRK_OK;
    for (int end = 0; status == TRK_OK && end < 2; end++) {
        status = trk_curve_solve(context, c->spring[end], -axle[end] * TRK_STANDARD_GRAVITY / 2,
                                 &p->spring_offset[end]);
        if (status == TRK_OK)
            status =
                trk_curve_solve(context, c->cab_spring[end], -cab[end] * TRK_STANDARD_GRAVITY / 2,
                                &p->cab_spring_offset[end]);
        p->bump_stop_offset[end] = free_length[end] - stop_length[end] + p->spring_offset[end];
    }
    return status;
}

static trk_status set_nonlinear(trk_context *context, trk_truck_parameters *p, curves *c)
{
    trk_status status = TRK_OK;
    create_curve(context, &status, TRK_TABLE_REFERENCE_FRONT_SPRING, &c->spring[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_REAR_SPRING, &c->spring[TRK_REAR]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_AXLE_DAMPER, &c->damper[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_AXLE_DAMPER, &c->damper[TRK_REAR]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_FRONT_CAB_SPRING, &c->cab_spring[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_REAR_CAB_SPRING, &c->cab_spring[TRK_REAR]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_FRONT_CAB_DAMPER, &c->cab_damper[TRK_FRONT]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_REAR_CAB_DAMPER, &c->cab_damper[TRK_REAR]);
    create_curve(context, &status, TRK_TABLE_REFERENCE_BUMP_STOP, &c->bump_stop);
    if (status == TRK_OK)
        status = find_offsets(context, p, c);
    use_dampers(p, c);
    memset(p->spring_stiffness, 0, sizeof p->spring_stiffness);
    memset(p->cab_vertical_stiffness, 0, sizeof p->cab_vertical_stiffness);
    for (int end = 0; end < 2; end++) {
        p->spring_curve[end] = c->spring[end];
        p->cab_spring_curve[end] = c->cab_spring[end];
        p->bump_stop_curve[end] = c->bump_stop;
    }
    return status;
}

static trk_status create_thesis_quarter(trk_context *context, trk_spec **out_spec)
{
    trk_quarter_car_parameters p;
    trk_quarter_car_parameters_init(&p, sizeof p);
    trk_curve *damper;
    trk_status status =
        trk_vehicle_create_curve(context, TRK_TABLE_THESIS_FRONT_AXLE_DAMPER, NULL, &damper);
    if (status != TRK_OK)
        return status;
    p.damper_curve = damper;
    status = trk_vehicle_create_quarter_car(context, &p, out_spec);
    trk_curve_destroy(damper);
    return status;
}

static trk_status create_reference(trk_context *context, trk_vehicle vehicle,
                                   const trk_truck_parameters *p, trk_spec **out_spec)
{
    switch (vehicle) {
    case TRK_VEHICLE_REFERENCE_FRONT:
        return trk_vehicle_create_axle_quarter(context, p, TRK_FRONT, out_spec);
    case TRK_VEHICLE_REFERENCE_REAR:
        return trk_vehicle_create_axle_quarter(context, p, TRK_REAR, out_spec);
    case TRK_VEHICLE_REFERENCE_HALF: return trk_vehicle_create_half_truck(context, p, out_spec);
    default: return trk_vehicle_create_truck(context, p, out_spec);
    }
}

trk_status trk_vehicle_create_builtin(trk_context *context, trk_vehicle vehicle,
                                      trk_variant variant, trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_builtin");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_builtin");
    if (vehicle < TRK_VEHICLE_THESIS_QUARTER || vehicle > TRK_VEHICLE_REFERENCE_TRUCK)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_vehicle_create_builtin: there is no vehicle %d", vehicle);
    if (variant < TRK_VARIANT_LINEAR || variant > TRK_VARIANT_NONLINEAR)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_vehicle_create_builtin: there is no variant %d", variant);
    if (vehicle == TRK_VEHICLE_THESIS_QUARTER)
        return create_thesis_quarter(context, out_spec);
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    curves c = {0};
    trk_status status = variant == TRK_VARIANT_THESIS_DAMPERS ? set_thesis_dampers(context, &p, &c)
                        : variant == TRK_VARIANT_NONLINEAR    ? set_nonlinear(context, &p, &c)
                                                              : TRK_OK;
    if (status == TRK_OK)
        status = create_reference(context, vehicle, &p, out_spec);
    destroy_curves(&c);
    return status;
}
