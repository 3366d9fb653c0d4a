/* Calls a function for one pose after the other, again and again; included once for each function.
 *
 * POSE, NUMBER: types; DRIVE: name of the loop; CALL(motion, F, out): calls the function, returns a status. */
int DRIVE(
    const void *machine, size_t count, size_t numbers, size_t repeats, const POSE *motions, const NUMBER *F,
    NUMBER *out)
{
    size_t n, i;
    int status = 0;
    (void)F;
    for (n = 0; n < repeats; ++n) {
        for (i = 0; i < count; ++i) {
            status |= CALL(&motions[i], &F[6 * i], &out[numbers * i]);
        }
    }
    return status;
}
#undef DRIVE
#undef CALL
