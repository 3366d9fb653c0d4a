/* Rows of a CSV file from columns of doubles, each number with the fewest digits that give it back.

   The digits are those of Raffaello Giulietti's Schubfach algorithm (2020): the shortest decimal in the interval that
   rounds to the number, and of several the nearest to it. The spelling is that of Python's repr. */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Powers of ten from 10^-292 on, of 128 bits each, rounded up, high half first. */
enum { FIRST_POWER = -292, FRACTION = 52, BIAS = 1075, MOST_FIXED = 16, LEAST_FIXED = -4 };

typedef struct { uint64_t high, low; } product;
typedef struct { uint64_t digits; int exponent; } decimal;

static product times(uint64_t a, uint64_t b) {
    const uint64_t half = 0xffffffffu, a0 = a & half, a1 = a >> 32, b0 = b & half, b1 = b >> 32;
    const uint64_t low = a0 * b0, one = a1 * b0 + (low >> 32), other = a0 * b1 + (one & half);
    return (product){a1 * b1 + (one >> 32) + (other >> 32), (other << 32) | (low & half)};
}

/* The integer part of c times a power, over 2^128, with a last bit that says whether something is left. */
static uint64_t rounded_to_odd(const uint64_t *power, uint64_t c) {
    const product low = times(power[1], c), high = times(power[0], c);
    const uint64_t middle = high.low + low.high;
    return (high.high + (middle < low.high)) | (middle > 1);
}

static int floor_shift(int value, int bits) {
    return value >= 0 ? value >> bits : -((-value + (1 << bits) - 1) >> bits);
}

static decimal shortest(uint64_t bits, const uint64_t *powers) {
    const uint64_t fraction = bits & ((UINT64_C(1) << FRACTION) - 1);
    const int exponent = (int)((bits >> FRACTION) & 0x7ff);
    const uint64_t c = exponent ? fraction | (UINT64_C(1) << FRACTION) : fraction;
    const int q = (exponent ? exponent : 1) - BIAS, nearer = fraction == 0 && exponent > 1;
    /* k: of the largest power of ten that is no wider than the interval; ends and middle in quarters of 10^k. */
    const int k = floor_shift(q * 1262611 - (nearer ? 524031 : 0), 22);
    const int shift = q + floor_shift(-k * 1741647, 19) + 1;
    const uint64_t *power = powers + 2 * (-k - FIRST_POWER), open = c & 1;
    const uint64_t least = rounded_to_odd(power, (4 * c - 2 + (uint64_t)nearer) << shift) + open;
    const uint64_t middle = rounded_to_odd(power, (4 * c) << shift);
    const uint64_t most = rounded_to_odd(power, (4 * c + 2) << shift) - open;
    const uint64_t s = middle / 4, tens = s / 10;
    if (tens) {
        const int below = least <= 40 * tens, above = 40 * tens + 40 <= most;
        if (below != above) {
            return (decimal){tens + (uint64_t)above, k + 1};
        }
    }
    const int below = least <= 4 * s, above = 4 * s + 4 <= most;
    const int up = below != above ? above : middle > 4 * s + 2 || (middle == 4 * s + 2 && (s & 1));
    return (decimal){s + (uint64_t)up, k};
}

static char *copied(char *out, const char *text) {
    const size_t length = strlen(text);
    memcpy(out, text, length);
    return out + length;
}

/* Digits of a number > 0, first one first; returns how many. */
static int digits_of(uint64_t number, char *digits) {
    char reversed[20];
    int count = 0;
    for (; number; number /= 10) {
        reversed[count++] = (char)('0' + number % 10);
    }
    for (int i = 0; i < count; i++) {
        digits[i] = reversed[count - 1 - i];
    }
    return count;
}

static char *repeated(char *out, char what, int count) {
    for (int i = 0; i < count; i++) {
        *out++ = what;
    }
    return out;
}

static char *scientific(char *out, const char *digits, int count, int exponent) {
    *out++ = digits[0];
    if (count > 1) {
        *out++ = '.';
        memcpy(out, digits + 1, (size_t)count - 1);
        out += count - 1;
    }
    *out++ = 'e';
    *out++ = exponent < 0 ? '-' : '+';
    const unsigned size = (unsigned)(exponent < 0 ? -exponent : exponent);
    if (size < 10) {
        *out++ = '0';
    }
    return out + digits_of(size, out);
}

/* Spells 0.DIGITS times 10^point. */
static char *fixed(char *out, const char *digits, int count, int point) {
    if (point <= 0) {
        out = repeated(copied(out, "0."), '0', -point);
        memcpy(out, digits, (size_t)count);
        return out + count;
    }
    const int whole = point < count ? point : count;
    memcpy(out, digits, (size_t)whole);
    out = repeated(out + whole, '0', point - whole);
    *out++ = '.';
    if (whole == count) {
        *out++ = '0';
        return out;
    }
    memcpy(out, digits + whole, (size_t)(count - whole));
    return out + count - whole;
}

static char *spelled(char *out, double value, const uint64_t *powers) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    const uint64_t size = bits & ~(UINT64_C(1) << 63), infinite = UINT64_C(0x7ff) << FRACTION;
    if (size > infinite) {
        return copied(out, "nan");
    }
    if (bits != size) {
        *out++ = '-';
    }
    if (size == infinite || size == 0) {
        return copied(out, size ? "inf" : "0.0");
    }
    const decimal found = shortest(size, powers);
    char digits[20];
    int count = digits_of(found.digits, digits);
    const int point = count + found.exponent;
    while (count > 1 && digits[count - 1] == '0') {
        count--;
    }
    return LEAST_FIXED < point && point <= MOST_FIXED ? fixed(out, digits, count, point)
                                                      : scientific(out, digits, count, point - 1);
}

static char *whole_number(char *out, int64_t value) {
    if (value < 0) {
        *out++ = '-';
    }
    if (value == 0) {
        *out++ = '0';
        return out;
    }
    return out + digits_of(value < 0 ? UINT64_C(0) - (uint64_t)value : (uint64_t)value, out);
}

/* Rows of numbers with commas and line ends; returns their length. Each column points to doubles, or where whole says
   so to int64_t. out has room for 25 characters for each number. */
size_t csv_rows(size_t rows, size_t columns, const void *const *column, const unsigned char *whole,
                const uint64_t *powers, char *out) {
    char *const start = out;
    for (size_t row = 0; row < rows; row++) {
        for (size_t i = 0; i < columns; i++) {
            out = whole[i] ? whole_number(out, ((const int64_t *)column[i])[row])
                           : spelled(out, ((const double *)column[i])[row], powers);
            *out++ = i + 1 < columns ? ',' : '\n';
        }
    }
    return (size_t)(out - start);
}
