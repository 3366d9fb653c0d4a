"""NumPy Python of what ``joint_rows`` is in C: the solve with the legs' inertia in their joint coordinates.

Text alone, used by ``numpy_motion``; poses are the first axis.
"""

JOINT_ROWS = '''\
@dataclass(frozen=True, eq=False)
class _Rows:
    """M = A^T W A of poses: three rows of A for each leg, by L, theta, phi, and six of the platform.

    weight (n, 8, 3, 3): W in blocks of about one; size (n, 24): root of the inertia in each row; share
    (n, 24, 6): rows as sums of the six that serve as coordinates, which are ``pivot`` (n, 6); factors
    (n, 6, 6): L and U of these six, columns in the order of ``column`` (n, 6); inertia (n, 6, 6): M in these
    coordinates; length (n,): m, by which moments and rotations are measured.
    """

    weight: Array
    size: Array
    share: Array
    factors: Array
    inertia: Array
    length: Array
    pivot: Array
    column: Array


def _factored(total: dict[str, Array], leg: dict[str, Array]) -> _Rows:
    M_xi, row_v, row_w = (_matrix(leg, name, name == "M_xi") for name in ("M_xi", "row_v", "row_w"))
    mass, (theta, phi) = total["M_vv_xx"], (np.abs(M_xi[..., i, i]) for i in (1, 2))
    length = np.abs(row_w[..., 0, :]).max(axis=(-1, -2))
    length = np.where(length > 0, length, 1.0)
    L, rho = leg["L"], leg["L"] * leg["k3"]
    least = np.maximum(np.abs(mass), np.maximum(theta / L / L, phi / rho / rho).max(axis=-1))
    least = np.maximum(np.finfo(np.float64).eps * np.sqrt(least), SHORTEST)
    theta = np.maximum(np.sqrt(theta), least[..., None] * L)
    phi = np.maximum(np.sqrt(phi), least[..., None] * rho)
    along = np.maximum(np.abs(M_xi[..., 0, 1]) / theta, np.abs(M_xi[..., 0, 2]) / phi)
    along = np.maximum(along, np.maximum(np.sqrt(np.abs(M_xi[..., 0, 0])), least[..., None]))
    c = np.stack([total["M_vw_yz"], -total["M_vw_xz"], total["M_vw_xy"]], axis=-1)
    c = c * np.where(mass > 0, 1 / mass, 0.0)[..., None]
    square = np.sum(c * c, axis=-1)[..., None, None] * np.eye(3) - c[..., None] * c[..., None, :]
    about = _matrix(total, "M_ww", symmetric=True) - mass[..., None, None] * square
    root = np.maximum(np.sqrt(np.abs(mass)), least)[..., None]
    turned = np.sqrt(np.abs(np.diagonal(about, axis1=-2, axis2=-1)))
    turned = np.maximum(turned, (least * length)[..., None])
    masses = mass[..., None, None] * np.eye(3)
    inertia = np.concatenate([M_xi, masses[..., None, :, :], about[..., None, :, :]], axis=-3)
    of_platform = np.stack([np.broadcast_to(root, turned.shape), turned], axis=-2)
    size = np.concatenate([np.stack([along, theta, phi], axis=-1), of_platform], axis=-2)
    row = np.zeros((*mass.shape, 8, 3, 6))
    row[..., :6, :, :3], row[..., :6, :, 3:] = row_v, row_w / length[..., None, None, None]
    row[..., 6, :, :3], row[..., 7, :, 3:] = np.eye(3), np.eye(3) / length[..., None, None]
    for i in range(3):
        row[..., 6, i, (i + 1) % 3 + 3] = c[..., (i + 2) % 3] / length
        row[..., 6, i, (i + 2) % 3 + 3] = -c[..., (i + 1) % 3] / length
    weight = inertia / size[..., None] / size[..., None, :]
    row = (row * size[..., None]).reshape(*mass.shape, 24, 6)
    share, factors, pivot, column = _eliminated(row)
    apart = share.reshape(*mass.shape, 8, 3, 6)
    M = np.einsum("nbik,nbij,nbjl->nkl", apart, weight, apart)
    return _Rows(weight, size.reshape(*mass.shape, 24), share, factors, M, length, pivot, column)


def _eliminated(row: Array) -> tuple[Array, Array, Array, Array]:
    """share, factors, pivot and column by elimination with complete pivoting."""
    at = np.arange(len(row))
    order, column = (np.tile(np.arange(count), (len(row), 1)) for count in (24, 6))
    for k in range(6):
        best, across = np.divmod(np.argmax(np.abs(row[:, k:, k:]).reshape(len(row), -1), axis=-1), 6 - k)
        for array, other in ((order, best + k), (column, across + k), (row, best + k)):
            array[at, k], array[at, other] = array[at, other].copy(), array[at, k].copy()
        row[at, :, k], row[at, :, across + k] = row[at, :, across + k].copy(), row[at, :, k].copy()
        row[:, k + 1 :, k] /= row[:, k, k, None]
        row[:, k + 1 :, k + 1 :] -= row[:, k + 1 :, k, None] * row[:, k, None, k + 1 :]
    sums = row[:, 6:].copy()
    for j in range(5, -1, -1):
        sums[..., j] -= (sums[..., j + 1 :] @ row[:, j + 1 : 6, j, None])[..., 0]
    share = np.empty_like(row)
    share[at[:, None], order] = np.concatenate([np.broadcast_to(np.eye(6), (len(row), 6, 6)), sums], axis=1)
    return share, row[:, :6], order[:, :6], column


def _rows_solved(by: _Rows, force: Array, wrench: Array) -> tuple[Array, Array, Array, Array]:
    """x (n, 6, m) of M x = wrench - A^T (force sizes), forces and accelerations of rows, and the status (n,).

    force: generalised forces (n, 24, m); wrench: (n, 6, m).
    """
    at = np.arange(len(force))[:, None]
    force = force / by.size[..., None]
    moved, balanced = _balanced(by, force)
    start = moved[at, by.pivot]
    moved = by.share @ start
    others = by.weight * ~(balanced[..., None] & balanced[..., None, :])
    rest = np.where(balanced.reshape(-1, 24, 1), 0.0, force) - _weighted(others, moved)
    unit = np.where(by.column < 3, 1.0, by.length[:, None])[..., None]
    y = wrench[at, by.column] / unit
    for k in range(6):
        y[:, k] = (y[:, k] - (by.factors[:, None, :k, k] @ y[:, :k])[:, 0]) / by.factors[:, k, k, None]
    for k in range(5, -1, -1):
        y[:, k] -= (by.factors[:, None, k + 1 :, k] @ y[:, k + 1 :])[:, 0]
    found, status = _solve_definite(by.inertia, y - by.share.swapaxes(-1, -2) @ rest)
    held = (rest + _weighted(by.weight, by.share @ found)) * by.size[..., None]
    x = found - start
    turned = (by.share @ x) / by.size[..., None]
    for k in range(6):
        x[:, k] -= (by.factors[:, None, k, :k] @ x[:, :k])[:, 0]
    for k in range(5, -1, -1):
        x[:, k] -= (by.factors[:, None, k, k + 1 :] @ x[:, k + 1 :])[:, 0]
        x[:, k] /= by.factors[:, k, k, None]
    solved = np.empty_like(x)
    solved[at, by.column] = x / unit
    return solved, held, turned, status


def _balanced(by: _Rows, force: Array) -> tuple[Array, Array]:
    """Accelerations (n, 24, m) of the coordinates, under which each block balances their forces, and whose.

    From these the unknown accelerations are measured: the coordinates' own large forces are then out of the
    way. Whose, (n, 8, 3): without rows that have no inertia of their own beside the rows before them.
    """
    W, moved = by.weight.copy(), force.reshape(len(force), 8, 3, -1).copy()
    pivots = np.zeros(by.size.shape, dtype=bool)
    pivots[np.arange(len(force))[:, None], by.pivot] = True
    balanced = pivots.reshape(-1, 8, 3)
    for k in range(3):
        balanced[..., k] &= W[..., k, k] > KEPT
        for i in range(k + 1, 3):
            factor = np.where(balanced[..., k], W[..., i, k] / W[..., k, k], 0.0)[..., None]
            moved[..., i, :] -= factor * moved[..., k, :]
            W[..., i, k + 1 :] -= factor * W[..., k, k + 1 :]
    for k in (2, 1, 0):
        left = moved[..., k, :] - np.sum(W[..., k, k + 1 :, None] * moved[..., k + 1 :, :], axis=-2)
        moved[..., k, :] = np.where(balanced[..., k, None], left / W[..., k, k, None], 0.0)
    return moved.reshape(force.shape), balanced


def _weighted(weight: Array, rows: Array) -> Array:
    """Blocks of weights (n, 8, 3, 3) times rows (n, 24, m)."""
    return (weight @ rows.reshape(len(rows), 8, 3, -1)).reshape(rows.shape)


def _forward_apart(robot: Any, motion: Any, F: Array) -> tuple[_Rows, Array, Array]:
    """The rows, [a; alpha] (n, 6) and the status (n,); ``motion`` gets what derivatives read of the legs."""
    total, leg, _ = _sums("joint_rows", robot, motion, F)
    by = _factored(total, leg)
    force = np.zeros((len(F), 24, 1))
    force[:, :18, 0] = np.stack([leg[f"tau_{axis}"] for axis in "xyz"], axis=-1).reshape(-1, 18)
    x, held, turned, status = _rows_solved(by, force, _wrench(total, "right")[..., None])
    motion.net, motion.turned = (rows[:, :18, 0].reshape(-1, 6, 3) for rows in (held, turned))
    size = by.size[:, :18].reshape(-1, 6, 3)
    of_tip = leg["L"] * size[..., 0]
    share = of_tip / size[..., 1] * (of_tip / size[..., 2] * leg["k3"])
    axial = leg["k3"] / (leg["k3"] + share * share * (share * share))
    motion.axial = np.where(leg["k3"] < LEANING, axial, 1.0)
    return by, x[..., 0], status


def _slopes_apart(robot: Any, motion: Any, F: Array) -> tuple[Array, Array]:
    """M^-1 times the derivatives of the wrench and H, (n, 6, 18), and the status (n,)."""
    by, x, status = _forward_apart(robot, motion, F)
    motion.a, motion.alpha = x[..., :3], x[..., 3:]
    total, leg, _ = _sums("joint_slopes", robot, motion)
    force = np.zeros((len(F), 24, 18))
    slopes = [_matrix(leg, f"tau_{by}") for by in "trvw"]
    force[:, :18, :12] = -np.concatenate(slopes, axis=-1).reshape(-1, 18, 12)
    x, _, _, fault = _rows_solved(by, force, np.concatenate([*_slopes(total), _columns(leg, "H")], axis=-1))
    return x, np.where(status == OK, fault, status)


def _chosen(motion: Any, poses: Array) -> SimpleNamespace:
    """The motion of some poses, (n, ...)."""
    names = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
    return SimpleNamespace(**{name: getattr(motion, name)[poses] for name in names if hasattr(motion, name)})


'''
