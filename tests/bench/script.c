/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "script.h"

int script_run(const char *interpreter, const char *script, const char *argument, int capacity,
               script_line *lines)
{
    char command[4096], text[256];
    int length = snprintf(command, sizeof command, "%s '%s/%s' '%s'", interpreter, BENCH_SCRIPTS,
                          script, argument),
        count = 0;
    if (!*interpreter || length < 0 || (size_t)length >= sizeof command)
        return -1;
    FILE *pipe = popen(command, "r");
    if (!pipe)
        return -1;
    while (fgets(text, sizeof text, pipe)) {
        script_line *l = &lines[count];
        if (count < capacity &&
            sscanf(text, "%63[^;];%lf;%lf", l->name, &l->seconds, &l->error) == 3)
            count++;
    }
    return pclose(pipe) == 0 ? count : -1;
}
