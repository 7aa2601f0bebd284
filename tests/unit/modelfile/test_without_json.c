/* SPDX-License-Identifier: MIT */
/* A build without jansson writes model files and says that it reads none. */
#include "compare.h"

#include <truckride/vehicle.h>

static void reading(void **state)
{
    static const char text[] = "{\"truckride_model\": 1, \"name\": \"x\"}";
    trk_context *c = *state;
    trk_spec *spec = (trk_spec *)c;
    const trk_status wanted = trk_has_feature(TRK_FEATURE_JSON) ? TRK_OK : TRK_E_UNSUPPORTED;
    assert_status(c, trk_model_file_parse(c, text, sizeof text - 1, "x.json", NULL, &spec), wanted);
    if (wanted) {
        assert_message(c, "x.json: this build has no jansson");
        assert_null(spec);
    }
    trk_spec_destroy(spec);
}

static void writing(void **state)
{
    trk_context *c = *state;
    trk_spec *spec;
    assert_ok(c, trk_vehicle_create_builtin(c, TRK_VEHICLE_THESIS_QUARTER, 0, &spec));
    char *text = text_of(c, spec);
    assert_non_null(strstr(text, "\"sprung\": {\"mass\": 5000}"));
    assert_non_null(strstr(text, "\"tire_force\": {\"quantity\": \"force\", \"link\": \"tire\"}"));
    free(text);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reading, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(writing, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
