/* Calls a kernel of either precision for one pose after the other, each ``size`` bytes. */
#include <stddef.h>

typedef int forces_of(const void *model, const void *motion, void *F);

int drive(
    forces_of *forces, const void *model, size_t count, size_t repeats, const char *motions, size_t size,
    void *F)
{
    size_t n, i;
    int status = 0;
    for (n = 0; n < repeats; ++n) {
        for (i = 0; i < count; ++i) {
            status |= forces(model, motions + size * i, F);
        }
    }
    return status;
}
