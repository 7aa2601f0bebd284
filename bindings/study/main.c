/* SPDX-License-Identifier: MIT */
/* truckride-study: a parameter study from the command line. */
#include "job.h"

int main(int argc, char **argv)
{
    return job_main("truckride-study", false, argc - 1, argv + 1);
}
