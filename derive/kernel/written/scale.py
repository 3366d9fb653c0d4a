"""By what moments are multiplied in a solve, in the part of Python that ``read`` reads."""


def per_length_of(size: "Real", smallest: "Real") -> "Real":
    """What moments are multiplied by in the solve where no coordinate of their arms exceeds `size`, 1/m: 1
    from `smallest` to $largest m, else one over the least power of two, from 2^-100 to 2^100, that is as
    large."""
    unit = 1.0
    if size >= smallest and size <= LARGEST:
        return unit
    for i in range(100):
        if not unit < size:
            break
        unit = 2.0 * unit
    for i in range(100):
        if not (size > 0.0 and 0.5 * unit >= size):
            break
        unit = 0.5 * unit
    return 1.0 / unit


def size_of(model: "Model") -> "Real":
    """Largest coordinate of the arms of moments about platform point 1, m."""
    largest = 0.0
    for j in range(3):
        for i in range(1, 6):
            if BY_LEGS:
                largest = larger(size(model.leg[i].p[j] - model.leg[0].p[j]), largest)
            else:
                largest = larger(size(model.p[j][i] - model.p[j][0]), largest)
    return largest


def scaled_axis(k: "array(3)", out: "array(3)") -> None:
    """The fixed axis times a power of two that makes its square a number of the arithmetic: it may have any
    length."""
    for j in range(3):
        out[j] = k[j]
    for i in range(64):
        by = 1.0
        most = size(out[0])
        most = larger(size(out[1]), most)
        most = larger(size(out[2]), most)
        by = where(most > 1048576.0, 1.0 / 4294967296.0, by)
        by = where(most < 1.0 / 1048576.0, 4294967296.0, by)
        for j in range(3):
            out[j] = by * out[j]


def handed_over() -> None:
    """The end of a preparation: the model is written only if its numbers are finite."""
    made.per_length = per_length_of(size_of(made), SMALLEST)
    numbers = numbers_of(made)
    for i in range(COUNT):
        if not size(numbers[i]) <= MAX:
            return NOT_FINITE
    model = made
    return OK
