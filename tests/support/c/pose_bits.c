/* Counts poses whose forces or status differ between one pose, a batch, parts of it, and columns. See pose_bits.py. */
#include <stdlib.h>
#include <string.h>
#include HEADER

#define JOIN(a, b, c) a##b##c
#define JOINED(a, b, c) JOIN(a, b, c)
#define KERNEL_NAME(part) JOINED(stewart_, KERNEL, part)
#define MODEL JOINED(stewart_, KERNEL, _model)

enum { ARRAYS = 8, MOST = 37 };

static const size_t WIDTH[ARRAYS] = {9, 3, 3, 3, 3, 3, 3, 3};

/* The arrays from a pose on. */
static stewart_motions from(const stewart_motions *motions, size_t first, size_t step)
{
    const stewart_real *array[ARRAYS];
    stewart_motions part;
    int i;
    memcpy(array, motions, sizeof array);
    for (i = 0; i < ARRAYS; ++i) {
        array[i] += first * (step ? step : WIDTH[i]);
    }
    memcpy(&part, array, sizeof part);
    return part;
}

static stewart_motion pose_of(const stewart_motions *motions, size_t pose)
{
    const stewart_real *array[ARRAYS];
    stewart_motion one;
    stewart_real *to = one.R;
    int i;
    memcpy(array, motions, sizeof array);
    for (i = 0; i < ARRAYS; ++i) {
        memcpy(to, array[i] + pose * WIDTH[i], WIDTH[i] * sizeof *to);
        to += WIDTH[i];
    }
    return one;
}

/* differing[3]: poses at which the batch, its parts, and columns have other bits than one pose alone;
 * statuses[8]: poses by status. Returns the status of the preparation. */
int pose_bits(const void *robot, size_t count, const stewart_motions *rows, const stewart_motions *columns,
    size_t differing[3], size_t statuses[8])
{
    const size_t size = 6 * count * sizeof(stewart_real);
    char *room = malloc(sizeof(MODEL) + 64);
    MODEL *model = (MODEL *)(room + (64 - (size_t)room % 64));
    stewart_real *alone = malloc(size), *F = malloc(size);
    int *expected = malloc(count * sizeof(int)), *status = malloc(count * sizeof(int));
    size_t i, j, length;
    int way, result = KERNEL_NAME(_prepare)(robot, model);
    if (result == STEWART_OK) {
        memset(alone, 0xA5, size);
        for (i = 0; i < count; ++i) {
            const stewart_motion one = pose_of(rows, i);
            expected[i] = KERNEL_NAME(_forces)(model, &one, alone + 6 * i);
            statuses[expected[i]] += 1;
        }
        for (way = 0; way < 3; ++way) {
            memset(F, 0xA5, size);
            memset(status, 0xA5, count * sizeof *status);
            if (way == 0) {
                (void)KERNEL_NAME(_forces_batch)(model, count, rows, F, status);
            } else if (way == 1) {
                for (i = 0; i < count; i += length) {
                    const stewart_motions part = from(rows, i, 0);
                    length = 1 + i % MOST;
                    length = length < count - i ? length : count - i;
                    (void)KERNEL_NAME(_forces_batch)(model, length, &part, F + 6 * i, status + i);
                }
            } else {
                (void)KERNEL_NAME(_forces_columns)(model, count, count, columns, F, status);
            }
            for (i = 0; i < count; ++i) {
                int other = status[i] != expected[i];
                for (j = 0; j < 6; ++j) {
                    other |= memcmp(alone + 6 * i + j, way < 2 ? F + 6 * i + j : F + j * count + i, sizeof *F) != 0;
                }
                differing[way] += (size_t)other;
            }
        }
    }
    free(room);
    free(alone);
    free(F);
    free(expected);
    free(status);
    return result;
}
