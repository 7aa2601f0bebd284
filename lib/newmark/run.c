/* SPDX-License-Identifier: MIT */
/* Steps in a row, and the choice of the way to take them. */
#include "base/processor.h"
#include "newmark/newmark.h"

#include <math.h>
#include <string.h>

/* The kernel of a number, NULL if this build or processor does not have it, and its width. */
static trk_fast_kernel find_kernel(int32_t kernel, int32_t *out_width)
{
    *out_width = 1 << kernel;
    if (kernel == TRK_KERNEL_PORTABLE)
        return trk_fast_kernel_base;
#ifdef TRK_X86_KERNELS
    if (kernel == TRK_KERNEL_AVX2 && trk_processor() >= TRK_PROCESSOR_AVX2)
        return trk_fast_kernel_avx2;
    if (kernel == TRK_KERNEL_AVX512 && trk_processor() >= TRK_PROCESSOR_AVX512)
        return trk_fast_kernel_avx512;
#endif
    return NULL;
}

bool trk_newmark_set_kernel(trk_newmark *stepper, int32_t kernel)
{
    int32_t width = 0;
    trk_fast_kernel found = NULL;
    if (kernel != TRK_KERNEL_GENERAL) {
        found = stepper->fast ? find_kernel(kernel, &width) : NULL;
        if (!found)
            return false;
        trk_fast_settle(stepper);
        trk_fast_pack(stepper->fast, stepper, width);
        trk_fast_adopt(stepper->fast, stepper, true);
    }
    stepper->kernel = found;
    return true;
}

void trk_newmark_choose_kernel(trk_newmark *stepper)
{
    enum { WIDE = 17 }; /* modes from which the sums need more registers than AVX2 has */
    bool is_wide = stepper->model->n >= WIDE;
    const int32_t order[] = {is_wide ? TRK_KERNEL_AVX512 : TRK_KERNEL_AVX2,
                             is_wide ? TRK_KERNEL_AVX2 : TRK_KERNEL_AVX512, TRK_KERNEL_PORTABLE,
                             TRK_KERNEL_GENERAL};
    for (int k = 0; !trk_newmark_set_kernel(stepper, order[k]); k++)
        continue;
}

/* Link on the row where the step with the most corrections had the largest last one. */
static int32_t worst_link(const trk_newmark *stepper)
{
    const trk_fast *s = stepper->fast;
    int32_t worst = 0;
    for (int32_t row = 1; row < s->rows; row++)
        if (s->worst[row] > s->worst[worst])
            worst = row;
    return stepper->model->nonlinear[s->first[worst]] + 1;
}

/* What the kernel did becomes what the stepper did. */
static void take_over(trk_newmark *stepper, int64_t taken)
{
    trk_fast *s = stepper->fast;
    trk_newmark_statistics *statistics = &stepper->statistics;
    stepper->taken += taken;
    statistics->steps += taken;
    statistics->iterations += s->iterations;
    s->iterations = 0;
    if (s->max_iterations > statistics->max_iterations) {
        statistics->max_iterations = s->max_iterations;
        statistics->worst_link = worst_link(stepper);
    }
}

static void copy_road(double *to, const double *from, int32_t count)
{
    if (from)
        memcpy(to, from, (size_t)count * sizeof *to);
    else
        memset(to, 0, (size_t)count * sizeof *to);
}

/* As many steps as the kernel can take. */
static int64_t run_fast(trk_newmark *stepper, const trk_fast_run *run)
{
    trk_fast *s = stepper->fast;
    int64_t taken = stepper->kernel(s, run);
    if (taken == 0)
        return 0;
    s->is_ahead = true;
    copy_road(stepper->now.height, run->height + (taken - 1) * run->height_stride, s->roads);
    copy_road(stepper->now.velocity, run->velocity + (taken - 1) * run->velocity_stride, s->roads);
    take_over(stepper, taken);
    return taken;
}

/* Row k of a matrix that may be missing. */
static const double *row_of(const double *matrix, int64_t k, int32_t columns)
{
    return matrix ? matrix + k * columns : NULL;
}

trk_status trk_newmark_record(trk_newmark *stepper, int64_t count, const double *height,
                              const double *velocity, const double *load, double *out_rows,
                              int64_t *out_taken)
{
    int32_t roads = stepper->model->names[TRK_PART_ROAD].count, ports = stepper->model->ports.count;
    int64_t width = out_rows ? trk_newmark_row_width(stepper) : 0;
    *out_taken = 0;
    while (*out_taken < count) {
        int64_t k = *out_taken;
        const double *u = row_of(height, k, roads), *du = row_of(velocity, k, roads),
                     *p = row_of(load, k, ports);
        if (stepper->kernel) {
            const double *zeros = stepper->fast->zeros;
            *out_taken += run_fast(
                stepper, &(trk_fast_run){count - k, u ? u : zeros, du ? du : zeros, p ? p : zeros,
                                         u ? roads : 0, du ? roads : 0, p ? ports : 0,
                                         out_rows ? out_rows + k * width : NULL, width});
            if (*out_taken > k)
                continue;
        }
        trk_status status = trk_newmark_step_general(stepper, u, du, p);
        if (status != TRK_OK)
            return status;
        if (out_rows)
            trk_newmark_get_row(stepper, out_rows + k * width);
        (*out_taken)++;
    }
    return TRK_OK;
}

trk_status trk_newmark_step(trk_newmark *stepper, const double *height, const double *velocity,
                            const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_newmark_step");
    int64_t taken;
    return trk_newmark_record(stepper, 1, height, velocity, load, NULL, &taken);
}
