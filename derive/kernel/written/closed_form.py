"""Equations of motion and forward dynamics around their blocks, in the part of Python that ``read`` reads.

Where M's factors lose digits, near a joint singularity or with a very short or very heavy leg, the legs'
inertia stays in their joint coordinates: M = A^T W A with three rows of A for each leg and six of the
platform, and weights W of about one in blocks of three. Elimination with complete pivoting picks the six
stiffest rows, and their accelerations become the unknowns: no large number is added to a small one.
"""


def equations(model: "Model", motion: "Motion") -> "Equations":
    """M, C, g, friction and bias of M [a; alpha] + C [v; omega] + g + friction = H F + external wrench."""
    out = Equations()
    total = EquationsSums()
    close = EquationsSums()
    status = model.status
    leaning = 0
    pose = equations_pose(model.platform, motion)
    for i in range(6):
        leg = equations_leg(model.leg[i], model.platform, motion)
        fault = fault_of(leg.L, leg.k3, reach_of(model.leg[i].b, motion.t, leg.q))
        status = where(status == OK, fault, status)
        leaning = where(leg.k3 < LEANING, 1, leaning)
        total = equations_more(total, leg)
        for j in range(3):
            out.H[j][i] = leg.H_force[j]
            out.H[j + 3][i] = leg.H_moment[j]
    if anywhere(leaning == 1):
        for i in range(6):
            near = equations_near(model.leg[i], model.platform, motion)
            close = equations_more(close, near)
        total = where(leaning == 1, close, total)
    sums = equations_total(total, pose)
    for i in range(3):
        out.g[i] = sums.g_force[i]
        out.g[i + 3] = sums.g_moment[i]
        out.friction[i] = sums.friction_force[i]
        out.friction[i + 3] = sums.friction_moment[i]
        for j in range(3):
            out.C[i][j] = sums.C_vv[3 * i + j]
            out.C[i][j + 3] = sums.C_vw[3 * i + j]
            out.C[i + 3][j] = sums.C_wv[3 * i + j]
            out.C[i + 3][j + 3] = sums.C_ww[3 * i + j]
    place_inertia(sums.M_vv, sums.M_vw, sums.M_ww, out.M)
    for i in range(6):
        coriolis = 0.0
        for j in range(3):
            coriolis = coriolis + out.C[i][j] * motion.v[j]
        for j in range(3):
            coriolis = coriolis + out.C[i][j + 3] * motion.omega[j]
        out.bias[i] = out.g[i] + out.friction[i] + coriolis
        lost = 0.0 * out.bias[i]
        for j in range(6):
            lost = lost + 0.0 * out.M[i][j]
        status = where((status != OK) | (lost == 0.0), status, NOT_FINITE)
    for i in range(6):
        out.g[i] = where(status == OK, out.g[i], NAN)
        out.friction[i] = where(status == OK, out.friction[i], NAN)
        out.bias[i] = where(status == OK, out.bias[i], NAN)
        for j in range(6):
            out.M[i][j] = where(status == OK, out.M[i][j], NAN)
            out.C[i][j] = where(status == OK, out.C[i][j], NAN)
            out.H[i][j] = where(status == OK, out.H[i][j], NAN)
    out.status = status
    return out


def place_inertia(vv: "array(6)", vw: "array(9)", ww: "array(6)", M: "array(6, 6)") -> None:
    """M from its parts: symmetric ones as xx xy xz yy yz zz."""
    for i in range(3):
        for j in range(3):
            M[i][j + 3] = vw[3 * i + j]
            M[j + 3][i] = vw[3 * i + j]
    place_symmetric(vv, 0, M)
    place_symmetric(ww, 3, M)


def place_symmetric(parts: "array(6)", first: "Integer", M: "array(6, 6)") -> None:
    """A symmetric 3 x 3 block on the diagonal, from xx xy xz yy yz zz."""
    M[first][first] = parts[0]
    M[first][first + 1] = parts[1]
    M[first][first + 2] = parts[2]
    M[first + 1][first] = parts[1]
    M[first + 1][first + 1] = parts[3]
    M[first + 1][first + 2] = parts[4]
    M[first + 2][first] = parts[2]
    M[first + 2][first + 1] = parts[4]
    M[first + 2][first + 2] = parts[5]


def forward_dynamics(model: "Model", motion: "Motion", F: "array(6)") -> "Accelerations":
    """Accelerations a and alpha of the platform under the actuator forces F, N; a and alpha are not read."""
    out = Accelerations()
    total = ForwardSums()
    M = array(6, 6)
    x = array(6)
    status = model.status
    pose = forward_pose(model.platform, motion)
    for i in range(6):
        leg = forward_leg(model.leg[i], model.platform, motion, pose, F[i])
        fault = fault_of(leg.L, leg.k3, reach_of(model.leg[i].b, motion.t, leg.q))
        status = where(status == OK, fault, status)
        total = forward_more(total, leg)
    sums = forward_total(total, pose)
    place_inertia(sums.M_vv, sums.M_vw, sums.M_ww, M)
    for i in range(3):
        x[i] = sums.right_force[i]
        x[i + 3] = sums.right_moment[i]
    lost = solve_definite(M, x, KEPT)
    if anywhere((status == OK) & (lost == INDEFINITE)):
        apart = forward_apart(model, motion, F)
        for i in range(6):
            x[i] = where(lost == INDEFINITE, apart.x[i], x[i])
        lost = where(lost == INDEFINITE, apart.status, lost)
    status = where(status == OK, lost, status)
    for i in range(6):
        status = where((status != OK) | (size(x[i]) <= MAX), status, NOT_FINITE)
    for i in range(3):
        out.a[i] = where(status == OK, x[i], NAN)
        out.alpha[i] = where(status == OK, x[i + 3], NAN)
    out.status = status
    return out


def weigh(inertia: "array(6)", extent: "array(3)", weight: "array(3, 3)") -> None:
    """Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of these sizes."""
    weight[0][0] = inertia[0] / extent[0] / extent[0]
    weight[0][1] = inertia[1] / extent[0] / extent[1]
    weight[0][2] = inertia[2] / extent[0] / extent[2]
    weight[1][0] = inertia[1] / extent[1] / extent[0]
    weight[1][1] = inertia[3] / extent[1] / extent[1]
    weight[1][2] = inertia[4] / extent[1] / extent[2]
    weight[2][0] = inertia[2] / extent[2] / extent[0]
    weight[2][1] = inertia[4] / extent[2] / extent[1]
    weight[2][2] = inertia[5] / extent[2] / extent[2]


def forward_apart(model: "Model", motion: "Motion", F: "array(6)") -> "Apart":
    """Forward dynamics in the accelerations of the six stiffest rows."""
    out = Apart()
    by = Rows()
    total = JointRowsSums()
    pose = joint_rows_pose(model.platform, motion)
    for i in range(6):
        by.leg[i] = joint_rows_leg(model.leg[i], model.platform, motion, pose, F[i])
        total = joint_rows_more(total, by.leg[i])
    sums = joint_rows_total(total, pose)
    make_rows(sums, by)
    pick_rows(by)
    solve_rows(sums, by, out)
    return out


def make_rows(sums: "JointRowsSums", by: "Rows") -> None:
    """Rows and weights: each row of A carries the root of its inertia, so that weights are of about one."""
    mass = sums.M_vv[0]
    c = array(3)
    about = array(6)
    whole = array(6)
    heaviest = size(mass)
    length = 0.0
    for i in range(6):
        rho = by.leg[i].L * by.leg[i].k3
        for j in range(3):
            length = larger(size(by.leg[i].row_w[j]), length)
        heaviest = larger(size(by.leg[i].M_xi[3]) / by.leg[i].L / by.leg[i].L, heaviest)
        heaviest = larger(size(by.leg[i].M_xi[5]) / rho / rho, heaviest)
    least = larger(EPSILON * sqrt(heaviest), SHORTEST)
    by.length = where(length > 0.0, length, 1.0)
    for i in range(6):
        reach = least * by.leg[i].L
        theta = larger(sqrt(size(by.leg[i].M_xi[3])), reach)
        phi = larger(sqrt(size(by.leg[i].M_xi[5])), reach * by.leg[i].k3)
        along = larger(size(by.leg[i].M_xi[1]) / theta, size(by.leg[i].M_xi[2]) / phi)
        along = larger(along, sqrt(size(by.leg[i].M_xi[0])))
        by.block[i].extent[0] = larger(along, least)
        by.block[i].extent[1] = theta
        by.block[i].extent[2] = phi
        weigh(by.leg[i].M_xi, by.block[i].extent, by.block[i].weight)
        for j in range(3):
            for k in range(3):
                by.row[3 * i + j][k] = by.block[i].extent[j] * by.leg[i].row_v[3 * j + k]
                by.row[3 * i + j][k + 3] = by.block[i].extent[j] * (by.leg[i].row_w[3 * j + k] / by.length)
    heft = larger(sqrt(size(mass)), least)
    per_mass = where(mass > 0.0, 1.0 / mass, 0.0)
    c[0] = sums.M_vw[5] * per_mass
    c[1] = -sums.M_vw[2] * per_mass
    c[2] = sums.M_vw[1] * per_mass
    square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2]
    about[0] = sums.M_ww[0] - mass * (square - c[0] * c[0])
    about[1] = sums.M_ww[1] + mass * (c[0] * c[1])
    about[2] = sums.M_ww[2] + mass * (c[0] * c[2])
    about[3] = sums.M_ww[3] - mass * (square - c[1] * c[1])
    about[4] = sums.M_ww[4] + mass * (c[1] * c[2])
    about[5] = sums.M_ww[5] - mass * (square - c[2] * c[2])
    whole[0] = mass
    whole[3] = mass
    whole[5] = mass
    by.block[7].extent[0] = larger(sqrt(size(about[0])), least * by.length)
    by.block[7].extent[1] = larger(sqrt(size(about[3])), least * by.length)
    by.block[7].extent[2] = larger(sqrt(size(about[5])), least * by.length)
    for i in range(3):
        by.block[6].extent[i] = heft
        by.row[18 + i][i] = heft
        by.row[21 + i][i + 3] = by.block[7].extent[i] / by.length
    by.row[18][4] = heft * (c[2] / by.length)
    by.row[18][5] = -heft * (c[1] / by.length)
    by.row[19][5] = heft * (c[0] / by.length)
    by.row[19][3] = -heft * (c[2] / by.length)
    by.row[20][3] = heft * (c[1] / by.length)
    by.row[20][4] = -heft * (c[0] / by.length)
    weigh(whole, by.block[6].extent, by.block[6].weight)
    weigh(about, by.block[7].extent, by.block[7].weight)


def pick_rows(by: "Rows") -> None:
    """Picks six rows as coordinates by elimination with complete pivoting; the others are sums of them.

    ``chosen``: 1 of a row that was picked, else 0; ``pivot``, ``column``: number of the row picked and of the
    column exchanged with it; ``factors``: L and U of the six.
    """
    for k in range(6):
        by.column[k] = k
    for k in range(6):
        best = -1.0
        row = 0
        across = 0
        for i in range(24):
            for j in range(k, 6):
                entry = where(by.chosen[i] > 0.0, -1.0, size(by.row[i][j]))
                row = where(entry > best, i, row)
                across = where(entry > best, j, across)
                best = larger(entry, best)
        held = by.column[k]
        for j in range(k + 1, 6):
            by.column[k] = where(across == j, by.column[j], by.column[k])
            by.column[j] = where(across == j, held, by.column[j])
            for i in range(24):
                moved = by.row[i][k]
                by.row[i][k] = where(across == j, by.row[i][j], by.row[i][k])
                by.row[i][j] = where(across == j, moved, by.row[i][j])
            for i in range(k):
                moved_up = by.factors[i][k]
                by.factors[i][k] = where(across == j, by.factors[i][j], by.factors[i][k])
                by.factors[i][j] = where(across == j, moved_up, by.factors[i][j])
        for i in range(24):
            by.chosen[i] = where(row == i, 1.0, by.chosen[i])
            by.place[k][i] = where(row == i, 1.0, 0.0)
            for j in range(6):
                by.factors[k][j] = where(row == i, by.row[i][j], by.factors[k][j])
        for i in range(24):
            factor = by.row[i][k] / by.factors[k][k]
            by.row[i][k] = where(by.chosen[i] > 0.0, by.row[i][k], factor)
            for j in range(k + 1, 6):
                less = by.row[i][j] - factor * by.factors[k][j]
                by.row[i][j] = where(by.chosen[i] > 0.0, by.row[i][j], less)
    for i in range(24):
        for j in reversed(range(6)):
            part = by.row[i][j]
            for k in range(j + 1, 6):
                part = part - by.share[i][k] * by.factors[k][j]
            by.share[i][j] = part
        for j in range(6):
            by.share[i][j] = where(by.chosen[i] > 0.0, by.place[j][i], by.share[i][j])


def balance_rows(by: "Rows", force: "array(24)", moved: "array(24)", balanced: "array(24)") -> None:
    """Accelerations of the coordinates' rows under which each block balances their forces.

    ``balanced``: 1 of these rows, without those that have no inertia of their own beside the rows before
    them, else 0; ``moved`` is 0 of all others.
    """
    W = array(3, 3)
    for i in range(24):
        moved[i] = force[i]
    for b in range(8):
        for i in range(3):
            for j in range(3):
                W[i][j] = by.block[b].weight[i][j]
        for k in range(3):
            heavy = where(W[k][k] > KEPT, 1.0, 0.0)
            balanced[3 * b + k] = heavy * by.chosen[3 * b + k]
            pivot = where(balanced[3 * b + k] > 0.0, W[k][k], 1.0)
            for i in range(k + 1, 3):
                factor = balanced[3 * b + k] * W[i][k] / pivot
                moved[3 * b + i] = moved[3 * b + i] - factor * moved[3 * b + k]
                for j in range(k + 1, 3):
                    W[i][j] = W[i][j] - factor * W[k][j]
        for k in reversed(range(3)):
            for j in range(k + 1, 3):
                moved[3 * b + k] = moved[3 * b + k] - W[k][j] * moved[3 * b + j]
            divisor = where(balanced[3 * b + k] > 0.0, W[k][k], 1.0)
            moved[3 * b + k] = where(balanced[3 * b + k] > 0.0, moved[3 * b + k] / divisor, 0.0)


def solve_rows(sums: "JointRowsSums", by: "Rows", out: "Apart") -> None:
    """Solves for the accelerations of the six coordinates, from those that balance their own forces."""
    force = array(24)
    balanced = array(24)
    start = array(6)
    moved = array(24)
    rest = array(24)
    wrench = array(6)
    y = array(6)
    inertia = array(6, 6)
    for i in range(6):
        for j in range(3):
            force[3 * i + j] = by.leg[i].tau[j] / by.block[i].extent[j]
    for i in range(3):
        wrench[i] = sums.right_force[i]
        wrench[i + 3] = sums.right_moment[i] / by.length
    balance_rows(by, force, moved, balanced)
    for k in range(6):
        for i in range(24):
            start[k] = where(by.place[k][i] > 0.0, moved[i], start[k])
        for j in range(6):
            y[k] = where(by.column[k] == j, wrench[j], y[k])
    for i in range(24):
        moved[i] = 0.0
        for k in range(6):
            moved[i] = moved[i] + by.share[i][k] * start[k]
    for b in range(8):
        for i in range(3):
            rest[3 * b + i] = where(balanced[3 * b + i] > 0.0, 0.0, force[3 * b + i])
            for j in range(3):
                less = rest[3 * b + i] - by.block[b].weight[i][j] * moved[3 * b + j]
                own = (balanced[3 * b + i] > 0.0) & (balanced[3 * b + j] > 0.0)
                rest[3 * b + i] = where(own, rest[3 * b + i], less)
    for k in range(6):
        for j in range(k):
            y[k] = y[k] - by.factors[j][k] * y[j]
        y[k] = y[k] / by.factors[k][k]
    for k in reversed(range(6)):
        for j in range(k + 1, 6):
            y[k] = y[k] - by.factors[j][k] * y[j]
    for k in range(6):
        for i in range(24):
            y[k] = y[k] - by.share[i][k] * rest[i]
    for b in range(8):
        for i in range(3):
            for j in range(3):
                for k in range(6):
                    weighed = by.share[3 * b + i][k] * by.block[b].weight[i][j]
                    for n in range(6):
                        inertia[k][n] = inertia[k][n] + weighed * by.share[3 * b + j][n]
    out.status = solve_definite(inertia, y, ROUNDING)
    for k in range(6):
        y[k] = y[k] - start[k]
        for j in range(k):
            y[k] = y[k] - by.factors[k][j] * y[j]
    for k in reversed(range(6)):
        for j in range(k + 1, 6):
            y[k] = y[k] - by.factors[k][j] * y[j]
        y[k] = y[k] / by.factors[k][k]
    for k in range(6):
        for j in range(6):
            unit = where(j < 3, 1.0, by.length)
            out.x[j] = where(by.column[k] == j, y[k] / unit, out.x[j])
