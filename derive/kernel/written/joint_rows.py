"""Forward dynamics and linearization as written functions, if the factors of M lose digits.

This occurs near a joint singularity, or with a very short or very heavy leg. The inertia of the legs then
remains in joint coordinates: M = A^T W A. A has three rows for each leg and six for the platform, and W has
weights of about one in 3 x 3 blocks. Elimination with complete pivoting selects the six stiffest rows, whose
accelerations become the unknowns. Therefore no large number is added to a small one.
"""


def forward_apart(model: "Model", motion: "Motion", F: "array(6)", by: "Rows") -> "Apart":
    """Forward dynamics in the accelerations of the six stiffest rows; by: the rows, what legs are given."""
    out = blank(Apart)
    legs = blank(JointRowsLegs)
    summed = blank(JointRowsSums)
    force = array(24)
    wrench = blank(array(6))
    start = blank(array(6))
    rest = blank(array(24))
    held = blank(array(6))
    right = blank(array(6))
    A = array(6, 8)
    for i in range(6):
        legs.given[i].F = F[i]
    joint_rows_sums(model, motion, legs, summed)
    make_rows(summed, legs, by)
    pick_rows(by)
    weigh_rows(by)
    for i in range(6):
        for j in range(3):
            force[3 * i + j] = legs.leg[i].tau[j] / by.extent[3 * i + j]
    for i in range(3):
        wrench[i] = summed.right_force[i]
        wrench[i + 3] = summed.right_moment[i]
    by_rows(by, wrench, held)
    row_right(by, force, held, start, rest, right)
    for i in range(6):
        A[i][6] = right[i]
        for j in range(6):
            A[i][j] = by.inertia[i][j]
    fault = solve_definite_8(A, ROUNDING)
    for i in range(6):
        right[i] = A[i][6]
    row_back(by, right, start, out.x)
    rows_held(legs, by, right, start, rest, held)
    out.status = where(legs.status == OK, fault, legs.status)
    for i in range(6):
        out.status = where((out.status != OK) | (size(out.x[i]) <= MAX), out.status, NOT_FINITE)
    return out


def slopes_apart(model: "Model", motion: "Motion", moving: "Motion", F: "array(6)") -> "SlopesApart":
    """M^-1 times the derivatives of the wrench and H, columns 6 to 23 of A, as ``forward_apart`` solves."""
    out = blank(SlopesApart)
    by = blank(Rows)
    legs = blank(JointSlopesLegs)
    summed = blank(JointSlopesSums)
    start = blank(array(6))
    starts = blank(array(18, 6))
    force = blank(array(24))
    forces_by = array(18, 24)
    wrench = blank(array(6))
    held = blank(array(6))
    rest = blank(array(24))
    right = blank(array(6))
    apart = forward_apart(model, motion, F, by)
    for i in range(6):
        out.x[i] = apart.x[i]
        legs.given[i].axial = by.given[i].axial
        for j in range(3):
            legs.given[i].net[j] = by.given[i].net[j]
            legs.given[i].turned[j] = by.given[i].turned[j]
    joint_slopes_sums(model, moving, legs, summed)
    place_blocks_24(summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, out.A)
    place_blocks_24(summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, out.A)
    for i in range(3):
        for j in range(6):
            out.A[i][j + 18] = legs.leg[j].H_force[i]
            out.A[i + 3][j + 18] = legs.leg[j].H_moment[i]
    for i in range(6):
        for j in range(6):
            out.A[i][j] = by.inertia[i][j]
    for i in range(6):
        for j in range(3):
            for k in range(3):
                forces_by[k][3 * i + j] = -legs.leg[i].tau_t[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 3][3 * i + j] = -legs.leg[i].tau_r[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 6][3 * i + j] = -legs.leg[i].tau_v[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 9][3 * i + j] = -legs.leg[i].tau_w[3 * j + k] / by.extent[3 * i + j]
    for c in range(18):
        for i in range(24):
            force[i] = forces_by[c][i]
        for i in range(6):
            wrench[i] = out.A[i][c + 6]
        by_rows(by, wrench, held)
        row_right(by, force, held, start, rest, right)
        for i in range(6):
            starts[c][i] = start[i]
            out.A[i][c + 6] = right[i]
    fault = solve_definite_24(out.A, ROUNDING)
    for c in range(18):
        for i in range(6):
            right[i] = out.A[i][c + 6]
            start[i] = starts[c][i]
        row_back(by, right, start, wrench)
        for i in range(6):
            out.A[i][c + 6] = wrench[i]
    out.status = where(apart.status == OK, where(legs.status == OK, fault, legs.status), apart.status)
    return out


def weigh(inertia: "array(6)", first: "Integer", by: "Rows") -> None:
    """Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of their sizes."""
    for i in range(3):
        by.weight[first][i] = inertia[i] / by.extent[first] / by.extent[first + i]
        by.weight[first + i][0] = inertia[i] / by.extent[first + i] / by.extent[first]
    by.weight[first + 1][1] = inertia[3] / by.extent[first + 1] / by.extent[first + 1]
    by.weight[first + 1][2] = inertia[4] / by.extent[first + 1] / by.extent[first + 2]
    by.weight[first + 2][1] = inertia[4] / by.extent[first + 2] / by.extent[first + 1]
    by.weight[first + 2][2] = inertia[5] / by.extent[first + 2] / by.extent[first + 2]


def make_rows(summed: "JointRowsSums", legs: "JointRowsLegs", by: "Rows") -> None:
    """Rows and weights: each row of A carries the root of its inertia, so that weights are of about one."""
    mass = summed.M_vv[0]
    c = array(3)
    about = blank(array(6))
    inertia = blank(array(6))
    whole = array(6)
    heaviest = size(mass)
    length = 0.0
    for i in range(6):
        rho = legs.leg[i].L * legs.leg[i].k3
        for j in range(3):
            length = larger(size(legs.leg[i].row_w[j]), length)
        heaviest = larger(size(legs.leg[i].M_xi[3]) / legs.leg[i].L / legs.leg[i].L, heaviest)
        heaviest = larger(size(legs.leg[i].M_xi[5]) / rho / rho, heaviest)
    least = larger(EPSILON * sqrt(heaviest), SHORTEST)
    by.length = where(length > 0.0, length, 1.0)
    for i in range(6):
        reach = least * legs.leg[i].L
        theta = larger(sqrt(size(legs.leg[i].M_xi[3])), reach)
        phi = larger(sqrt(size(legs.leg[i].M_xi[5])), reach * legs.leg[i].k3)
        along = larger(size(legs.leg[i].M_xi[1]) / theta, size(legs.leg[i].M_xi[2]) / phi)
        along = larger(along, sqrt(size(legs.leg[i].M_xi[0])))
        by.extent[3 * i] = larger(along, least)
        by.extent[3 * i + 1] = theta
        by.extent[3 * i + 2] = phi
        for j in range(6):
            inertia[j] = legs.leg[i].M_xi[j]
        weigh(inertia, 3 * i, by)
        for j in range(3):
            for k in range(3):
                by.row[3 * i + j][k] = by.extent[3 * i + j] * legs.leg[i].row_v[3 * j + k]
                turn = legs.leg[i].row_w[3 * j + k] / by.length
                by.row[3 * i + j][k + 3] = by.extent[3 * i + j] * turn
    for i in range(18, 24):
        for j in range(6):
            by.row[i][j] = 0.0
    heft = larger(sqrt(size(mass)), least)
    per_mass = where(mass > 0.0, 1.0 / mass, 0.0)
    c[0] = summed.M_vw[5] * per_mass
    c[1] = -summed.M_vw[2] * per_mass
    c[2] = summed.M_vw[1] * per_mass
    square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2]
    about[0] = summed.M_ww[0] - mass * (square - c[0] * c[0])
    about[1] = summed.M_ww[1] + mass * (c[0] * c[1])
    about[2] = summed.M_ww[2] + mass * (c[0] * c[2])
    about[3] = summed.M_ww[3] - mass * (square - c[1] * c[1])
    about[4] = summed.M_ww[4] + mass * (c[1] * c[2])
    about[5] = summed.M_ww[5] - mass * (square - c[2] * c[2])
    whole[0] = mass
    whole[3] = mass
    whole[5] = mass
    by.extent[21] = larger(sqrt(size(about[0])), least * by.length)
    by.extent[22] = larger(sqrt(size(about[3])), least * by.length)
    by.extent[23] = larger(sqrt(size(about[5])), least * by.length)
    for i in range(3):
        by.extent[18 + i] = heft
        by.row[18 + i][i] = heft
        by.row[21 + i][i + 3] = by.extent[21 + i] / by.length
    by.row[18][4] = heft * (c[2] / by.length)
    by.row[18][5] = -heft * (c[1] / by.length)
    by.row[19][5] = heft * (c[0] / by.length)
    by.row[19][3] = -heft * (c[2] / by.length)
    by.row[20][3] = heft * (c[1] / by.length)
    by.row[20][4] = -heft * (c[0] / by.length)
    weigh(whole, 18, by)
    weigh(about, 21, by)


def pick_rows(by: "Rows") -> None:
    """Picks six rows as coordinates by elimination with complete pivoting; the others are sums of them.

    Rows and columns are exchanged: ``order`` and ``column`` say which they were.
    """
    share = blank(array(6))
    for i in range(24):
        by.order[i] = i
    for k in range(6):
        by.column[k] = k
    for k in range(6):
        best = k
        across = k
        most = size(by.row[k][k])
        for i in range(k, 24):
            for j in range(k, 6):
                entry = size(by.row[i][j])
                best = where(entry > most, i, best)
                across = where(entry > most, j, across)
                most = where(entry > most, entry, most)
        row = by.order[k]
        by.order[k] = by.order[best]
        by.order[best] = row
        column = by.column[k]
        by.column[k] = by.column[across]
        by.column[across] = column
        for j in range(6):
            upper = by.row[k][j]
            by.row[k][j] = by.row[best][j]
            by.row[best][j] = upper
        for i in range(24):
            left = by.row[i][k]
            by.row[i][k] = by.row[i][across]
            by.row[i][across] = left
        for i in range(k + 1, 24):
            by.row[i][k] = by.row[i][k] / by.row[k][k]
            for j in range(k + 1, 6):
                by.row[i][j] = by.row[i][j] - by.row[i][k] * by.row[k][j]
    for i in range(6):
        for j in range(6):
            by.share[by.order[i]][j] = where(i == j, 1.0, 0.0)
    for i in range(6, 24):
        for j in reversed(range(6)):
            share[j] = by.row[i][j]
            for k in range(j + 1, 6):
                share[j] = share[j] - share[k] * by.row[k][j]
            by.share[by.order[i]][j] = share[j]


def weigh_rows(by: "Rows") -> None:
    """M in the coordinates."""
    for k in range(6):
        for n in range(6):
            by.inertia[k][n] = 0.0
    for b in range(8):
        for i in range(3):
            for j in range(3):
                for k in range(6):
                    part = by.share[3 * b + i][k] * by.weight[3 * b + i][j]
                    for n in range(6):
                        by.inertia[k][n] = by.inertia[k][n] + part * by.share[3 * b + j][n]


def balance_rows(by: "Rows", force: "array(24)", moved: "array(24)", balanced: "array(24)") -> None:
    """Accelerations of the coordinates' rows under which the inertia of each block balances their forces.

    ``balanced``: 1 of these rows, without those that have no inertia of their own beside the rows before
    them, else 0; ``moved`` is 0 of all others.
    """
    W = blank(array(3, 3))
    for i in range(24):
        moved[i] = force[i]
        balanced[i] = 0.0
    for k in range(6):
        balanced[by.order[k]] = 1.0
    for b in range(8):
        for i in range(3):
            for j in range(3):
                W[i][j] = by.weight[3 * b + i][j]
        for k in range(3):
            own = where(W[k][k] > KEPT, balanced[3 * b + k], 0.0)
            balanced[3 * b + k] = own
            if anywhere(own > 0.0):
                for i in range(k + 1, 3):
                    factor = where(own > 0.0, W[i][k] / W[k][k], 0.0)
                    moved[3 * b + i] = moved[3 * b + i] - factor * moved[3 * b + k]
                    for j in range(k + 1, 3):
                        W[i][j] = W[i][j] - factor * W[k][j]
        for k in reversed(range(3)):
            for j in range(k + 1, 3):
                moved[3 * b + k] = moved[3 * b + k] - W[k][j] * moved[3 * b + j]
            moved[3 * b + k] = where(balanced[3 * b + k] > 0.0, moved[3 * b + k] / W[k][k], 0.0)


def by_rows(by: "Rows", wrench: "array(6)", held: "array(6)") -> None:
    """Forces of the six coordinates' rows that add up to a wrench."""
    for k in range(6):
        held[k] = wrench[by.column[k]] / where(by.column[k] < 3, 1.0, by.length)
    for k in range(6):
        for j in range(k):
            held[k] = held[k] - by.row[j][k] * held[j]
        held[k] = held[k] / by.row[k][k]
    for k in reversed(range(6)):
        for j in range(k + 1, 6):
            held[k] = held[k] - by.row[j][k] * held[j]


def row_right(
    by: "Rows", force: "array(24)", held: "array(6)", start: "array(6)", rest: "array(24)", right: "array(6)"
) -> None:
    """Right side of the equations for the accelerations of the six coordinates, with the wrench ``held``.

    force: of each row, as its generalized force over its size, without accelerations. start: accelerations of
    the coordinates that balance their own large forces, from which the unknown ones are measured; rest: the
    rows' forces there.
    """
    moved = blank(array(24))
    balanced = blank(array(24))
    balance_rows(by, force, moved, balanced)
    for k in range(6):
        start[k] = moved[by.order[k]]
    for i in range(24):
        moved[i] = 0.0
        for k in range(6):
            moved[i] = moved[i] + by.share[i][k] * start[k]
    for b in range(8):
        for i in range(3):
            rest[3 * b + i] = where(balanced[3 * b + i] > 0.0, 0.0, force[3 * b + i])
            for j in range(3):
                own = (balanced[3 * b + i] > 0.0) & (balanced[3 * b + j] > 0.0)
                less = rest[3 * b + i] - by.weight[3 * b + i][j] * moved[3 * b + j]
                rest[3 * b + i] = where(own, rest[3 * b + i], less)
    for k in range(6):
        right[k] = held[k]
        for i in range(24):
            right[k] = right[k] - by.share[i][k] * rest[i]


def row_back(by: "Rows", found: "array(6)", start: "array(6)", acceleration: "array(6)") -> None:
    """[a; alpha] from the coordinates' accelerations."""
    x = blank(array(6))
    for k in range(6):
        x[k] = found[k] - start[k]
        for j in range(k):
            x[k] = x[k] - by.row[k][j] * x[j]
    for k in reversed(range(6)):
        for j in range(k + 1, 6):
            x[k] = x[k] - by.row[k][j] * x[j]
        x[k] = x[k] / by.row[k][k]
        acceleration[by.column[k]] = x[k] / where(by.column[k] < 3, 1.0, by.length)


def rows_held(
    legs: "JointRowsLegs",
    by: "Rows",
    found: "array(6)",
    start: "array(6)",
    rest: "array(24)",
    held: "array(6)",
) -> None:
    """Generalized forces of each leg, accelerations due to the platform, and a mark if a leg is thin.

    The inertia of a thin leg for a rotation by phi is nearly k3 times its inertia for a rotation by theta.
    A value between the two would have the rounding errors of both. The rows of the coordinates contain the
    part of the wrench that the other rows do not balance. For a heavy leg, this part may be much smaller than
    inertia times acceleration.
    """
    whole = array(24)
    force = blank(array(24))
    for i in range(24):
        for j in range(6):
            whole[i] = whole[i] + by.share[i][j] * found[j]
    for b in range(8):
        for i in range(3):
            force[3 * b + i] = rest[3 * b + i]
            for j in range(3):
                force[3 * b + i] = force[3 * b + i] + by.weight[3 * b + i][j] * whole[3 * b + j]
    for k in range(6):
        force[by.order[k]] = 0.0
    for k in range(6):
        for i in range(24):
            held[k] = held[k] - by.share[i][k] * force[i]
    for k in range(6):
        force[by.order[k]] = held[k]
    for b in range(6):
        k3 = legs.leg[b].k3
        thin = k3 * by.extent[3 * b + 1] / by.extent[3 * b + 2]
        by.given[b].axial = where((k3 < LEANING) & (thin * thin > 0.5), 0.0, 1.0)
        for i in range(3):
            turned = 0.0
            for j in range(6):
                turned = turned + by.share[3 * b + i][j] * (found[j] - start[j])
            by.given[b].net[i] = force[3 * b + i] * by.extent[3 * b + i]
            by.given[b].turned[i] = turned / by.extent[3 * b + i]
