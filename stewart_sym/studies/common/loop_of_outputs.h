/* Calls a function for one pose after the other, again and again; included once for each function.
 *
 * DRIVE: name of the loop; CALL(motion, F, out): calls the function, returns a status. */
int DRIVE(
    const void *machine, size_t count, size_t repeats, const stewart_motion *motions, const stewart_real *F,
    size_t numbers, stewart_real *out)
{
    const stewart_real *const first_F = F;
    stewart_real *const first_out = out;
    size_t n, i;
    int status = 0;
    for (n = 0; n < repeats; ++n) {
        F = first_F;
        out = first_out;
        for (i = 0; i < count; ++i) {
            status |= CALL(&motions[i], F, out);
            F += 6;
            out += numbers;
        }
    }
    return status;
}
#undef DRIVE
#undef CALL
