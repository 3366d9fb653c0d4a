/* Calls a function of a kernel for one pose after the other, again and again. */
#include <stddef.h>

typedef int of_motion(const void *machine, const void *motion, void *out);
typedef int of_motion_and_forces(const void *machine, const void *motion, const void *F, void *out);
typedef int of_columns(const void *machine, const void *motion, const int *columns, size_t width, void *out);

/* ``F`` are actuator forces of each pose, or null. ``all_columns`` selects the arguments of a regressor. Motions,
 * forces, and results of one pose have ``motion_size``, ``force_size``, and ``out_size`` bytes. */
int drive(
    void (*function)(void), int all_columns, const void *machine, size_t count, size_t repeats,
    const char *motions, size_t motion_size, const char *F, size_t force_size, char *out, size_t out_size)
{
    size_t n, i;
    int status = 0;
    for (n = 0; n < repeats; ++n) {
        for (i = 0; i < count; ++i) {
            const char *motion = motions + motion_size * i;
            char *to = out + out_size * i;
            if (all_columns) {
                status |= ((of_columns *)function)(machine, motion, NULL, 0, to);
            } else if (F) {
                status |= ((of_motion_and_forces *)function)(machine, motion, F + force_size * i, to);
            } else {
                status |= ((of_motion *)function)(machine, motion, to);
            }
        }
    }
    return status;
}
