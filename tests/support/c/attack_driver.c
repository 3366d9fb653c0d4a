/* Runs random cases without a fuzzer, for any compiler:  attack_driver CASES SEED. See attack.c.
 * Prints how many, and a digest of all that the kernels answered.
 *
 * Every kernel in turn gets sound cases of every count from 0 to 17, then cases spoilt by random commands.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

extern uint64_t attack_digest;
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define MOST_BYTES 96

static uint64_t state;

static uint8_t random_byte(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint8_t)(state >> 32);
}

int main(int count, char **words)
{
    const unsigned long cases = count > 1 ? strtoul(words[1], 0, 10) : 1000;
    unsigned long number;
    state = 88172645463325252u + (count > 2 ? strtoul(words[2], 0, 10) : 0);
    for (number = 0; number < cases; ++number) {
        /* On the heap, so that a byte read too many is seen. */
        const size_t size = number < KERNELS * 18u ? 3 : 3 + random_byte() % (MOST_BYTES - 3);
        uint8_t *data = (uint8_t *)malloc(size);
        size_t i;
        if (!data) {
            return 1;
        }
        for (i = 0; i < size; ++i) {
            data[i] = random_byte();
        }
        data[0] = (uint8_t)(number % KERNELS);
        data[1] = (uint8_t)(144 + number / KERNELS % 18);
        LLVMFuzzerTestOneInput(data, size);
        free(data);
    }
    printf("%lu cases, %016llx\n", cases, (unsigned long long)attack_digest);
    return 0;
}
