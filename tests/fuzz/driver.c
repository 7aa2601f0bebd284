/* SPDX-License-Identifier: MIT */
/*
 * Stands in for libFuzzer where there is none: fuzz_X SECONDS [FILE ...] mutates the seeds, and the
 * files, always in the same order. The environment variable TRUCKRIDE_FUZZ_SECONDS goes before
 * SECONDS. What ends the process is in fuzz_X.crash, to be handed over as the only FILE with
 * 0 seconds.
 */
#include "fuzz.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROOM = 1 << 16, MOST_SEEDS = 64 };

static uint8_t bytes[2 * ROOM];
static size_t size;
static char crash_path[4096];
static uint64_t random_state = 88172645463325252u;

static uint64_t draw(uint64_t below)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state % below;
}

static void keep_crash(int number)
{
    FILE *file = fopen(crash_path, "wb");
    if (file) {
        fwrite(bytes, 1, size, file);
        fclose(file);
    }
    signal(number, SIG_DFL);
    raise(number);
}

static void insert(size_t at, const void *text, size_t length)
{
    if (size + length > ROOM)
        return;
    memmove(bytes + at + length, bytes + at, size - at);
    memcpy(bytes + at, text, length);
    size += length;
}

static void mutate(void)
{
    static const char *const words[] = {"-1",
                                        "0",
                                        "999999999999",
                                        "1e300",
                                        "nan",
                                        "inf",
                                        "1e-320",
                                        ",",
                                        ";",
                                        "\t",
                                        "\n",
                                        "\r\n",
                                        "\"",
                                        "$",
                                        "*missing*",
                                        "!",
                                        "=",
                                        "END",
                                        "D:",
                                        "#",
                                        "\xff",
                                        " ",
                                        ".",
                                        "2147483648",
                                        "-9223372036854775808",
                                        "0.1",
                                        "4096",
                                        "\xef\xbb\xbf"};
    const size_t at = size ? draw(size) : 0,
                 length = size ? draw(size - at < 64 ? size - at + 1 : 64) : 0;
    switch (draw(6)) {
    case 0:
        if (size)
            bytes[at] ^= (uint8_t)(1u << draw(8));
        break;
    case 1:
        if (size)
            bytes[at] = (uint8_t)draw(256);
        break;
    case 2:
        memmove(bytes + at, bytes + at + length, size - at - length);
        size -= length;
        break;
    case 3: {
        uint8_t part[64];
        memcpy(part, bytes + at, length);
        insert(size ? draw(size) : 0, part, length);
        break;
    }
    case 4: {
        const char *word = words[draw(sizeof words / sizeof *words)];
        insert(at, word, strlen(word));
        break;
    }
    default:
        if (draw(8) == 0)
            size = at;
        else if (size) { /* a digit for a digit keeps the structure */
            size_t k = at;
            while (k < size && (bytes[k] < '0' || bytes[k] > '9'))
                k++;
            if (k < size)
                bytes[k] = (uint8_t)('0' + draw(10));
        }
    }
}

static fuzz_seed read_seed(const char *path)
{
    fuzz_seed seed = {NULL, 0};
    FILE *file = fopen(path, "rb");
    char *text = malloc(ROOM);
    if (file && text) {
        seed.size = fread(text, 1, ROOM, file);
        seed.bytes = text;
    } else {
        free(text);
    }
    if (file)
        fclose(file);
    return seed;
}

int main(int count, char **argument)
{
    fuzz_seed seed[MOST_SEEDS];
    int seeds = 0, from_files;
    for (; fuzz_seeds[seeds].bytes; seeds++)
        seed[seeds] = fuzz_seeds[seeds];
    from_files = seeds;
    for (int k = 2; k < count && seeds < MOST_SEEDS; k++) {
        seed[seeds] = read_seed(argument[k]);
        seeds += seed[seeds].bytes != NULL;
    }
    const char *seconds = getenv("TRUCKRIDE_FUZZ_SECONDS");
    seconds = seconds ? seconds : count > 1 ? argument[1] : "5";
    snprintf(crash_path, sizeof crash_path, "%s.crash", argument[0]);
    signal(SIGABRT, keep_crash);
    for (int k = 0; k < seeds; k++) {
        memcpy(bytes, seed[k].bytes, size = seed[k].size);
        LLVMFuzzerTestOneInput(bytes, size);
    }
    const time_t end = time(NULL) + strtol(seconds, NULL, 10);
    long long runs = 0;
    for (; time(NULL) < end; runs++) {
        const fuzz_seed *s = &seed[draw((uint64_t)seeds)];
        memcpy(bytes, s->bytes, size = s->size);
        for (uint64_t k = draw(8) + 1; k > 0; k--)
            mutate();
        LLVMFuzzerTestOneInput(bytes, size);
    }
    printf("%lld inputs from %d seeds\n", runs, seeds);
    for (int k = from_files; k < seeds; k++)
        free((void *)(uintptr_t)seed[k].bytes);
    return 0;
}
