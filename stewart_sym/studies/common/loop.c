/* Calls a function for one pose after the other, again and again.
 *
 * call.h defines the types POSE and NUMBER and the function `call`, which puts a pose's forces into F. */
#include "call.h"

int drive(const void *machine, size_t count, size_t repeats, const POSE *motions, NUMBER *F)
{
    size_t n, i;
    int status = 0;
    for (n = 0; n < repeats; ++n) {
        for (i = 0; i < count; ++i) {
            status |= call(machine, &motions[i], F + 6 * i);
        }
    }
    return status;
}
