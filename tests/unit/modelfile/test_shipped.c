/* SPDX-License-Identifier: MIT */
/* Needs JSON. The ready-made vehicles as files are those of the library, to the bit, and what would be
 * written now. `test_unit_modelfile_shipped write` writes them anew. */
#include "compare.h"

#include <truckride/vehicle.h>

#define FOLDER SUPPORT_ROOT "/examples/models/"

static const struct {
    const char *path;
    trk_vehicle vehicle;
    trk_variant variant;
} shipped[] = {
    {FOLDER "thesis_quarter.json", TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR},
    {FOLDER "reference_front.json", TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR},
    {FOLDER "reference_front_thesis_dampers.json", TRK_VEHICLE_REFERENCE_FRONT,
     TRK_VARIANT_THESIS_DAMPERS},
    {FOLDER "reference_front_nonlinear.json", TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_NONLINEAR},
    {FOLDER "reference_rear.json", TRK_VEHICLE_REFERENCE_REAR, TRK_VARIANT_LINEAR},
    {FOLDER "reference_rear_thesis_dampers.json", TRK_VEHICLE_REFERENCE_REAR,
     TRK_VARIANT_THESIS_DAMPERS},
    {FOLDER "reference_rear_nonlinear.json", TRK_VEHICLE_REFERENCE_REAR, TRK_VARIANT_NONLINEAR},
    {FOLDER "reference_half.json", TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR},
    {FOLDER "reference_half_thesis_dampers.json", TRK_VEHICLE_REFERENCE_HALF,
     TRK_VARIANT_THESIS_DAMPERS},
    {FOLDER "reference_half_nonlinear.json", TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR},
    {FOLDER "reference_truck.json", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR},
    {FOLDER "reference_truck_thesis_dampers.json", TRK_VEHICLE_REFERENCE_TRUCK,
     TRK_VARIANT_THESIS_DAMPERS},
    {FOLDER "reference_truck_nonlinear.json", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR},
    {FOLDER "half_car.json", 0, TRK_HALF_CAR_PITCH},
    {FOLDER "half_car_roll.json", 0, TRK_HALF_CAR_ROLL},
};
enum { SHIPPED = sizeof shipped / sizeof *shipped };

static trk_spec *ready_made(trk_context *c, int k)
{
    trk_half_car_parameters p;
    trk_spec *spec;
    trk_half_car_parameters_init(&p, sizeof p);
    p.layout = shipped[k].variant;
    if (shipped[k].vehicle == 0)
        assert_ok(c, trk_vehicle_create_half_car(c, &p, &spec));
    else
        assert_ok(c, trk_vehicle_create_builtin(c, shipped[k].vehicle, shipped[k].variant, &spec));
    return spec;
}

static void same_vehicles(void **state)
{
    trk_context *c = *state;
    for (int k = 0; k < SHIPPED; k++) {
        trk_spec *spec = ready_made(c, k), *file;
        assert_ok(c, trk_model_file_read(c, shipped[k].path, &file));
        same_specs(spec, file);
        char *text = text_of(c, spec), *kept = calloc(strlen(text) + 2, 1);
        FILE *stream = fopen(shipped[k].path, "rb");
        assert_non_null(kept);
        assert_non_null(stream);
        assert_int_equal(fread(kept, 1, strlen(text) + 1, stream), strlen(text));
        assert_string_equal(kept, text);
        fclose(stream);
        free(text);
        free(kept);
        trk_spec_destroy(spec);
        trk_spec_destroy(file);
    }
}

static void write_vehicles(void **state)
{
    trk_context *c = *state;
    for (int k = 0; k < SHIPPED; k++) {
        trk_spec *spec = ready_made(c, k);
        assert_ok(c, trk_model_file_write(c, spec, shipped[k].path));
        trk_spec_destroy(spec);
    }
}

int main(int count, char **arguments)
{
    const struct CMUnitTest reading[] = {
        cmocka_unit_test_setup_teardown(same_vehicles, support_setup, support_teardown)};
    const struct CMUnitTest writing[] = {
        cmocka_unit_test_setup_teardown(write_vehicles, support_setup, support_teardown)};
    if (count == 2 && strcmp(arguments[1], "write") == 0)
        return cmocka_run_group_tests(writing, NULL, NULL);
    return cmocka_run_group_tests(reading, NULL, NULL);
}
