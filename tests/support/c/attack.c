/* From bytes to a case: a sound machine and sound poses, then what the bytes spoil in them.
 *
 * Bytes 0 to 2: which kernel, how many poses (few mostly, up to 17), which of the sound poses. Then commands, each a byte of what to
 * do, two of where, two of with what; values that only raw bytes can say follow in eight more. A fuzzer that
 * changes a byte changes one thing, and every string of bytes is a case.
 */
#include "attack.h"

#define KERNEL_TEXT "attack"

/* attack_kernels.h lists the kernels: ORACLE(name) for each. */
#define ORACLE(name) attack_oracle name;
#include "attack_kernels.h"
#undef ORACLE
static attack_oracle *const ORACLES[] = {
#define ORACLE(name) name,
#include "attack_kernels.h"
#undef ORACLE
};
#define ORACLE_COUNT (sizeof ORACLES / sizeof *ORACLES)

/* Arrays, canaries, verdicts */

stewart_real *attack_array(const attack_case *it, size_t numbers, void **block)
{
    const size_t off = it->flags & ONE_OFF ? 1 : 0;
    stewart_real *array = (stewart_real *)malloc((numbers + off) * sizeof *array + (numbers + off == 0));
    EXPECT(array);
    *block = array;
    memset(array + off, ATTACK_UNTOUCHED, numbers * sizeof *array);
    return array + off;
}

void attack_arrays_make(const attack_case *it, attack_arrays *out)
{
    static const size_t offset[ARRAYS] = {
        offsetof(stewart_motion, R), offsetof(stewart_motion, t), offsetof(stewart_motion, omega),
        offsetof(stewart_motion, v), offsetof(stewart_motion, alpha), offsetof(stewart_motion, a),
        offsetof(stewart_motion, F_ext), offsetof(stewart_motion, M_ext),
    };
    const stewart_real *array[ARRAYS];
    int i;
    size_t pose;
    for (i = 0; i < ARRAYS; ++i) {
        const size_t width = i == ARRAY_R ? 9 : 3;
        stewart_real *numbers = attack_array(it, it->count * width, &out->block[i]);
        for (pose = 0; pose < it->count; ++pose) {
            memcpy(numbers + pose * width, (const char *)&it->pose[pose] + offset[i], width * sizeof *numbers);
        }
        array[i] = it->flags & NULL_ARRAY(i) ? 0 : numbers;
    }
    memcpy(&out->motions, array, sizeof array);
}

void attack_arrays_free(attack_arrays *arrays)
{
    int i;
    for (i = 0; i < ARRAYS; ++i) {
        free(arrays->block[i]);
    }
}

int attack_untouched(const void *bytes, size_t size)
{
    const unsigned char *at = (const unsigned char *)bytes;
    return size == 0 || (at[0] == ATTACK_UNTOUCHED && memcmp(at, at + 1, size - 1) == 0);
}

uint64_t attack_digest;

int attack_finite(const stewart_real *numbers, size_t count)
{
    size_t i;
    for (i = 0; i < count * sizeof *numbers; ++i) {
        attack_digest = (attack_digest ^ ((const unsigned char *)numbers)[i]) * 1099511628211u;
    }
    for (i = 0; i < count; ++i) {
        if (!(fabs((double)numbers[i]) <= (double)ATTACK_MAX)) {
            return 0;
        }
    }
    return 1;
}

int attack_known(int status, unsigned allowed)
{
    return status >= 0 && status < 32 && (allowed >> status & 1u);
}

int attack_first(const int *status, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        if (status[i] != STEWART_OK) {
            return status[i];
        }
    }
    return STEWART_OK;
}

/* A sound machine and sound poses */

/* Between -1 and 1, and no two alike. */
static double wave(unsigned number)
{
    const double turns = 0.6180339887498949 * (1.0 + number);
    return 2.0 * (turns - floor(turns)) - 1.0;
}

static void set(stewart_real *to, double x, double y, double z)
{
    to[0] = (stewart_real)x;
    to[1] = (stewart_real)y;
    to[2] = (stewart_real)z;
}

static void symmetric(stewart_real *to, double size, unsigned seed)
{
    int i;
    for (i = 0; i < 6; ++i) {
        to[i] = (stewart_real)(size * ((i == 0 || i == 3 || i == 5) ? 1.0 + 0.2 * wave(seed + (unsigned)i)
                                                                     : 0.1 * wave(seed + (unsigned)i)));
    }
}

static void sound_robot(stewart_robot *robot)
{
    static const double base[6] = {-12, 12, 108, 132, 228, 252}, plate[6] = {-48, 48, 72, 168, 192, 288};
    const double degree = 3.14159265358979323846 / 180.0;
    unsigned i;
    for (i = 0; i < 6; ++i) {
        stewart_leg *leg = &robot->leg[i];
        const double k = 1.0 / sqrt(1.0 + 0.04 + 0.04 * i * i);
        set(leg->b, cos(base[i] * degree), sin(base[i] * degree), 0.02 * wave(i));
        set(leg->p, 0.6 * cos(plate[i] * degree), 0.6 * sin(plate[i] * degree), 0.02 * wave(i + 9));
        set(leg->k, k, 0.2 * k, 0.2 * i * k);
        leg->m_d = (stewart_real)(3.0 + wave(i));
        leg->m_u = (stewart_real)(1.5 + wave(i + 5));
        set(leg->r_d0, 0.3, 0.02 * wave(i), 0.02);
        set(leg->r_u0, -0.4, 0.03, 0.01 * wave(i));
        symmetric(leg->I_d0, 0.05, 7 * i);
        symmetric(leg->I_u0, 0.02, 5 * i);
        leg->C_u = (stewart_real)0.1;
        leg->C_p = (stewart_real)20.0;
        leg->C_s = (stewart_real)0.2;
#if defined(STEWART_ROTORS)
        leg->m_r = (stewart_real)(5.0 + wave(i + 2));
        leg->j_r = (stewart_real)(0.02 * wave(i + 3));
#endif
    }
    robot->M = (stewart_real)40.0;
    set(robot->R_0, 0.04, 0.03, -0.06);
    symmetric(robot->I_p, 2.0, 3);
    set(robot->g, 0.1, -0.2, -9.8);
}

static void sound_pose(stewart_motion *pose, unsigned seed)
{
    const double angle = 0.2 * wave(seed), c = cos(angle), s = sin(angle);
    int i;
    set(pose->R, c, -s, 0.0);
    set(pose->R + 3, s, c, 0.0);
    set(pose->R + 6, 0.0, 0.0, 1.0);
    set(pose->t, 0.1 * wave(seed + 1), 0.1 * wave(seed + 2), 1.1);
    for (i = 0; i < 3; ++i) {
        const unsigned at = seed + 3u * (unsigned)i;
        pose->omega[i] = (stewart_real)wave(at);
        pose->v[i] = (stewart_real)wave(at + 20);
        pose->alpha[i] = (stewart_real)wave(at + 40);
        pose->a[i] = (stewart_real)(5.0 * wave(at + 60));
        pose->F_ext[i] = (stewart_real)(100.0 * wave(at + 80));
        pose->M_ext[i] = (stewart_real)(30.0 * wave(at + 90));
    }
}

/* What bytes can spoil */

static const double SPECIAL[] = {
    0.0, -0.0, 1.0, -1.0, 1e-300, -1e-300, 1e300, -1e300, 1e154, -1e154, 1e155, 1e103, 1e38, -1e38, 3e19, 1e-38,
    1e-45, 4.9e-324, 2.2e-308, 1e-20, 1e20, -1e10, 1e-8, 2.220446049250313e-16, 1.1920929e-07, 0.5, 40.0, -9.81,
    INFINITY, -INFINITY, NAN, 1.7976931348623157e308,
};
#define SPECIALS (sizeof SPECIAL / sizeof *SPECIAL)

/* A double as the kernels' number: what is too large for a float becomes infinite, as in any such input. */
static stewart_real number(double value)
{
#if defined(STEWART_FLOAT)
    return value > (double)FLT_MAX ? (stewart_real)INFINITY
        : value < -(double)FLT_MAX ? -(stewart_real)INFINITY
                                   : (stewart_real)value;
#else
    return value;
#endif
}

typedef struct {
    const uint8_t *at;
    size_t left;
} bytes;

static unsigned taken(bytes *from, size_t count)
{
    unsigned value = 0;
    while (count-- > 0) {
        value = value << 8 | (from->left ? *from->at : 0u);
        if (from->left) {
            ++from->at;
            --from->left;
        }
    }
    return value;
}

static double distance(unsigned with)
{
    return with % 20 == 19 ? 0.0 : pow(10.0, -(double)(with % 20)) * (with & 0x8000u ? -1.0 : 1.0);
}

/* Puts the platform point of a leg beside its base point, or the leg beside its axis, or the pose flat. */
static void shorten(attack_case *it, stewart_motion *pose, unsigned where, unsigned with, int along_axis)
{
    const stewart_leg *leg = &it->robot.leg[where % 6];
    double way[3];
    int i, j;
    set((stewart_real *)pose->t, 0.0, 0.0, 0.0);
    for (i = 0; i < 3; ++i) {
        way[i] = along_axis ? (double)leg->k[i] + distance(with) * (i == 1) : distance(with) * (i + 1);
        way[i] += (double)leg->b[i];
        for (j = 0; j < 3; ++j) {
            way[i] -= (double)pose->R[3 * i + j] * (double)leg->p[j];
        }
        pose->t[i] = number(way[i]);
    }
}

/* Regular hexagons turned by 90 degrees, all but a distance: H loses a rank. */
static void turn(attack_case *it, stewart_motion *pose, unsigned with)
{
    const double angle = 3.14159265358979323846 / 2.0 + distance(with), c = cos(angle), s = sin(angle);
    int i;
    for (i = 0; i < 6; ++i) {
        it->robot.leg[i].b[2] = 0;
        it->robot.leg[i].p[2] = 0;
    }
    set(pose->R, c, -s, 0.0);
    set(pose->R + 3, s, c, 0.0);
    set(pose->R + 6, 0.0, 0.0, 1.0);
    set(pose->t, 0.0, 0.0, 1.0);
}

static void spoil(attack_case *it, bytes *from)
{
    const unsigned what = taken(from, 1), where = taken(from, 2), with = taken(from, 2);
    stewart_real *robot = (stewart_real *)&it->robot, *poses = (stewart_real *)it->pose, *forces = it->F[0];
    const size_t of_robot = sizeof it->robot / sizeof *robot, of_pose = sizeof *it->pose / sizeof *poses;
    stewart_motion *pose = &it->pose[(where >> 3) % MOST_POSES];
    stewart_real *target = what & 8u ? robot + where % of_robot : poses + where % (of_pose * MOST_POSES);
    uint64_t raw;
    double value;
    size_t i;
    switch (what & 7u) {
    case 0:
        *target = number(SPECIAL[with % SPECIALS]);
        break;
    case 1:
        raw = (uint64_t)taken(from, 4) << 32;
        raw |= taken(from, 4);
        memcpy(&value, &raw, sizeof value);
        *target = number(value);
        break;
    case 2:
        *target = number((double)*target * pow(2.0, (int)(with % 2200) - 1100));
        break;
    case 3:
        /* The whole of the robot or of a pose in another unit. */
        for (i = 0; i < (what & 8u ? of_robot : of_pose); ++i) {
            stewart_real *one = what & 8u ? robot + i : (stewart_real *)pose + i;
            *one = number((double)*one * pow(10.0, (int)(with % 80) - 40));
        }
        break;
    case 4:
        if (what & 16u) {
            it->bearing[where % 6] = number(SPECIAL[with % SPECIALS]);
        } else {
            forces[where % (6 * MOST_POSES)] = number(SPECIAL[with % SPECIALS]);
        }
        break;
    case 5:
        shorten(it, pose, where, with, (what & 16u) != 0);
        break;
    case 6:
        if (what & 16u) {
            turn(it, pose, with);
        } else {
            /* One leg, or what is at one place, like another. */
            memcpy(&it->robot.leg[where % 6], &it->robot.leg[with % 6], what & 32u ? 3 * sizeof *robot : sizeof(stewart_leg));
        }
        break;
    default:
        it->flags |= what & 16u ? with << FIRST_ARRAY : with & 0x7Fu;
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static attack_case it;
    bytes from;
    unsigned kernel, seed, i, j;
    from.at = data;
    from.left = size;
    memset(&it, 0, sizeof it);
    kernel = taken(&from, 1);
    it.count = taken(&from, 1);
    it.count = it.count < 128 ? it.count % 3 : it.count % (MOST_POSES + 1);
    seed = taken(&from, 1);
    sound_robot(&it.robot);
    for (i = 0; i < MOST_POSES; ++i) {
        sound_pose(&it.pose[i], seed + i);
        for (j = 0; j < 6; ++j) {
            it.F[i][j] = (stewart_real)(100.0 * wave(i + 7 * j));
        }
    }
    for (i = 0; i < 6; ++i) {
        it.bearing[i] = (stewart_real)(0.1 * i);
    }
    while (from.left > 0) {
        spoil(&it, &from);
    }
    /* Without a load a batch computes with zeros. */
    for (i = 0; i < MOST_POSES; ++i) {
        if (it.flags & NULL_ARRAY(ARRAY_F_EXT)) {
            set(it.pose[i].F_ext, 0.0, 0.0, 0.0);
        }
        if (it.flags & NULL_ARRAY(ARRAY_M_EXT)) {
            set(it.pose[i].M_ext, 0.0, 0.0, 0.0);
        }
    }
    ORACLES[kernel % ORACLE_COUNT](&it);
    return 0;
}
