/* SPDX-License-Identifier: MIT */
/* Patterns of names. */
#include "names.h"
#include "common/text.h"

#include <stdlib.h>

int names_select(session *s, const char *what, int32_t count, const char *const *names,
                 const char *patterns, bool *flags)
{
    const char **list = need((size_t)count + 1, sizeof *list);
    char *copy = text_copy(patterns ? patterns : "*"), *rest = copy;
    const char *pattern;
    int code = EXIT_DONE;
    for (int32_t k = 0; k < count; k++)
        list[k] = names[k];
    while (code == EXIT_DONE && (pattern = text_field(&rest, ','))) {
        bool found = false;
        for (int32_t k = 0; k < count; k++)
            if (text_match(pattern, names[k]))
                flags[k] = found = true;
        const char *nearest = text_nearest(list, pattern);
        if (!found && nearest)
            code = session_usage(s, "no %s is called '%s'; did you mean '%s'?", what, pattern,
                                 nearest);
        else if (!found && patterns)
            code = session_usage(s, "no %s is called '%s'", what, pattern);
    }
    free(copy);
    free(list);
    return code;
}

int names_of_model(session *s, const trk_model *model, trk_part part, const char *patterns,
                   bool *flags)
{
    const int32_t count = trk_model_count(model, part);
    const char **names = need((size_t)count, sizeof *names);
    bool *own = flags ? flags : need((size_t)count, sizeof *own);
    for (int32_t k = 0; k < count; k++)
        names[k] = trk_model_part_name(model, part, k + 1);
    const int code = names_select(s, part == TRK_PART_ROAD ? "road input" : "sensor", count, names,
                                  patterns, own);
    if (!flags)
        free(own);
    free(names);
    return code;
}
