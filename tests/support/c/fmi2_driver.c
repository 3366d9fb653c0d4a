/* fmi2_driver.c: two instances of a unit through their whole life, for the sanitizers. 0: all as it should be. */
#include "stewart_fmi2.h"

#include <math.h>
#include <stdlib.h>

#define MUST(that)                                                                                                 \
    if (!(that)) {                                                                                                 \
        return __LINE__ & 127;                                                                                     \
    }

static int messages;

static void logger(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category,
    fmi2String message, ...)
{
    (void)environment;
    (void)status;
    messages += name && category && message;
}

static fmi2Real real_at(fmi2Component c, fmi2ValueReference vr)
{
    fmi2Real value = NAN;
    return fmi2GetReal(c, &vr, 1, &value) == fmi2OK ? value : NAN;
}

static int status_of(fmi2Component c)
{
    const fmi2ValueReference vr = UNIT_REALS;
    fmi2Integer value = -1;
    return fmi2GetInteger(c, &vr, 1, &value) == fmi2OK ? value : -1;
}

int main(void)
{
    const fmi2CallbackFunctions callbacks = {logger, calloc, free, NULL, NULL};
    const fmi2ValueReference first = 0, beyond = UNIT_REALS, last = UNIT_REALS - 1;
    const fmi2Real numbers[] = {NAN, INFINITY, -1e308, 1e300, 0.0};
    fmi2FMUstate state = NULL, copy = NULL;
    fmi2Component one, two;
    fmi2Real before, value;
    char *bytes;
    size_t size, i;

    MUST(!fmi2Instantiate("one", fmi2CoSimulation, "another", "", &callbacks, 0, 0));
    MUST(!fmi2Instantiate(NULL, fmi2CoSimulation, NULL, NULL, &callbacks, 0, 0));
    MUST(!fmi2Instantiate("one", fmi2CoSimulation, UNIT_GUID, "", NULL, 0, 0));
    one = fmi2Instantiate("one", fmi2CoSimulation, UNIT_GUID, "", &callbacks, 0, 1);
    two = fmi2Instantiate("two", fmi2CoSimulation, UNIT_GUID, NULL, &callbacks, 0, 0);
    MUST(one && two && one != two);
    MUST(fmi2DoStep(one, 0, 1, 0) == fmi2Error);
    MUST(fmi2SetupExperiment(one, 0, 0, 0, 0, 0) == fmi2OK);
    MUST(fmi2EnterInitializationMode(one) == fmi2OK && fmi2ExitInitializationMode(one) == fmi2OK);
    MUST(fmi2EnterInitializationMode(two) == fmi2OK && fmi2ExitInitializationMode(two) == fmi2OK);
    before = real_at(one, 30);
    MUST(status_of(one) == 0 && before == real_at(two, 30));
    MUST(fmi2GetFMUstate(one, &state) == fmi2OK && fmi2GetFMUstate(one, &state) == fmi2OK);
    for (i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
        const fmi2ValueReference vr = i < 2 ? last : first;
        /* The last real is a parameter, or a force that cannot be set. */
        (void)fmi2SetReal(one, &vr, 1, &numbers[i]);
        (void)fmi2SetReal(one, &first, 1, &numbers[i]);
        MUST(fmi2DoStep(one, 0, 1, 0) == fmi2OK);
        MUST(isfinite(real_at(one, 30)));
    }
    MUST(messages > 0 && real_at(two, 30) == before);
    MUST(fmi2SetReal(one, &beyond, 1, numbers) == fmi2Error && fmi2GetReal(one, &beyond, 1, &value) == fmi2Error);
    MUST(fmi2SetReal(one, NULL, 1, NULL) == fmi2Error && fmi2SetReal(one, NULL, 0, NULL) == fmi2OK);
    MUST(fmi2SerializedFMUstateSize(one, state, &size) == fmi2OK);
    bytes = malloc(size);
    MUST(bytes && fmi2SerializeFMUstate(one, state, bytes, size - 1) == fmi2Error);
    MUST(fmi2SerializeFMUstate(one, state, bytes, size) == fmi2OK);
    MUST(fmi2DeSerializeFMUstate(two, bytes, size, &copy) == fmi2OK);
    MUST(fmi2SetFMUstate(one, state) == fmi2OK && fmi2SetFMUstate(two, copy) == fmi2OK);
    MUST(real_at(one, 30) == before && status_of(one) == 0);
    MUST(fmi2DoStep(two, 0, 1, 0) == fmi2OK && real_at(two, 30) == before);
    free(bytes);
    MUST(fmi2FreeFMUstate(one, &state) == fmi2OK && !state && fmi2FreeFMUstate(one, &state) == fmi2OK);
    MUST(fmi2FreeFMUstate(two, &copy) == fmi2OK);
    MUST(fmi2Terminate(one) == fmi2OK && fmi2Reset(one) == fmi2OK && fmi2Reset(two) == fmi2OK);
    fmi2FreeInstance(one);
    fmi2FreeInstance(two);
    fmi2FreeInstance(NULL);
    return 0;
}
