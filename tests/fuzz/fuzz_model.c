/* SPDX-License-Identifier: MIT */
/* Random bytes as model files: refused with a place, or a spec that is written and read again alike. */
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>
#include <truckride/modelfile.h>

#define SEED(text)                                                                                 \
    {                                                                                              \
        text, sizeof text - 1                                                                      \
    }
#define HEAD "{\"truckride_model\": 1, \"name\": \"x\", "
const fuzz_seed fuzz_seeds[] = {
    SEED(HEAD "\"bodies\": {\"a\": {\"mass\": 1, \"inertia\": [1, 2, 3], \"cg\": [0, -1e-3, 2], "
              "\"freedoms\": [\"z\", \"yaw\"]}}}"),
    SEED(HEAD
         "\"bodies\": {\"a\": {}, \"w\": {\"mirror\": true, \"cg\": [1, 2, 3]}}, \"roads\": "
         "{\"r_*\": {\"mirror\": true, \"x\": 0, \"y\": 1}},"
         "\"links\": {\"l_*\": {\"mirror\": true, \"from\": {\"road\": \"r_*\"}, \"to\": \"w_*\", "
         "\"point\": [0, 1, 0], \"stiffness\": 1e5,"
         "\"spring_curve\": {\"points\": [[0, 0], [1, 1], [2, 5]], \"interpolation\": \"akima\"}}},"
         "\"sensors\": {\"f\": {\"quantity\": \"force\", \"link\": \"l_left\"}}, \"ports\": "
         "{\"p\": {\"body\": \"a\", \"direction\": \"-y\"}}}"),
    SEED(HEAD "\"curves\": {\"c\": {\"points\": [[-1, -1], [0, 0], [1, 1]], \"x_scale\": -2}}, "
              "\"laws\": {\"leaf\": {\"leaf\": {\"friction\": 1, \"approach_bump\": 0.1}},"
              "\"stop\": {\"stops\": {\"bump_clearance\": 1, \"rebound_stiffness\": 5}}, \"air\": "
              "{\"air_spring\": {\"pressure\": 5e5, \"volume\": 1, \"area\": 1}}},"
              "\"bodies\": {\"f\": {\"mass\": 9, \"freedoms\": [\"z\", \"roll\"]}}, \"axles\": "
              "{\"front\": {\"x\": 0, \"mass\": 1, \"roll_inertia\": 1, \"frame\": \"f\","
              "\"tires\": {\"y\": [1, 2], \"law\": {\"tire\": {\"stiffness\": 1}}}, \"springs\": "
              "{\"y\": 1, \"spring_curve\": \"c\", \"law\": \"leaf\"}, \"anti_roll_bar\": 3}}}"),
    SEED(HEAD "\"materials\": {\"steel\": {\"young\": 2e11, \"shear\": 8e10, \"density\": 7850}}, "
              "\"sections\": {\"s\": {\"tube\": {\"outer\": 0.1, \"wall\": 0.01}, \"material\": "
              "\"steel\"}},"
              "\"frames\": {\"f\": {\"stations\": [0, 1, 3], \"cross_members\": [0, 3], "
              "\"half_width\": 0.4, \"longest\": 1, \"rail\": {\"section\": \"s\"}, \"member\": "
              "{\"axial\": 1, \"torsion\": 2}}},"
              "\"masses\": {\"m\": {\"frame\": \"f\", \"mass\": 1, \"point\": [0, 0, 0]}}, "
              "\"mounts\": {\"m\": {\"from\": \"f\", \"to\": \"ground\", \"vertical\": "
              "{\"stiffness\": 1}, \"lateral\": {\"damping\": 2}}}}"),
    /* what a scan that does not know escapes takes for brackets and ends of texts */
    SEED(HEAD
         "\"notes\": [\"\\\"\", \"\\\\\", \"{[\\\",\"], \"bodies\": {\"a\\\"\\u00e4\": {\"mass\": "
         "1}, \"\\\\\": {\"mass\": 2, \"cg\": [1, 2, 3]}}}"),
    {NULL, 0},
};

static char *text_of(const trk_spec *spec)
{
    size_t length = 0;
    fuzz_check(trk_model_file_format(spec, 0, NULL, &length) == TRK_OK, "a spec that has no text");
    char *text = malloc(length + 1);
    fuzz_check(text && trk_model_file_format(spec, length + 1, text, NULL) == TRK_OK,
               "a text that does not fit");
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    enum { FRAMES = 1 << 20 }; /* a few bytes about a frame make up to 100000 beams */
    trk_context *context = fuzz_begin(size + 4 * FRAMES);
    trk_spec *spec, *back;
    const trk_status status =
        trk_model_file_parse(context, (const char *)bytes, size, "x", NULL, &spec);
    if (status == TRK_OK) {
        char *text = text_of(spec), *again;
        fuzz_check(trk_model_file_parse(context, text, strlen(text), "y", NULL, &back) == TRK_OK,
                   trk_context_message(context));
        again = text_of(back);
        fuzz_check(strcmp(text, again) == 0, "a text that changes when it is read");
        free(text);
        free(again);
        trk_spec_destroy(spec);
        trk_spec_destroy(back);
    } else {
        fuzz_check(strncmp(trk_context_message(context), "x:", 2) == 0,
                   "a message without a place");
        fuzz_check(status != TRK_E_ARGUMENT && status != TRK_E_MEMORY, "an odd status");
    }
    fuzz_end(context);
    return 0;
}
