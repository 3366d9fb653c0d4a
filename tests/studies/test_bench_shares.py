"""`benchmark`: shares of the baselines' times and of the processor's limit, and the processor."""

import shutil

import pytest

from stewart_sym.backend import native
from stewart_sym.io.progress import silent
from stewart_sym.studies.benchmark.figures import BASIS, CLOSED, PLAIN, build_of, figure, limits, shares
from stewart_sym.studies.benchmark.processor import additions, multiply_add, targets, widest
from stewart_sym.studies.common import timing
from stewart_sym.studies.common.output import Figures

NAMES = {
    **{"one": "one pose", "batch": "batch, one core", "float": "batch, float"},
    **{"inverse": "inverse dynamics", "forward": "forward dynamics", "regressor": "regressor"},
    **{"plain": PLAIN, "closed": CLOSED},
}


def made_up(**times: float) -> Figures:
    """C of these names, its flags after two underlines, for AVX2, and a limit of 2 ns."""
    builds = [
        figure(NAMES[label], "", "", 1, (time,))
        | build_of("AVX2", ["-m", *(["-fused"] if fused else [])], None)
        for name, time in times.items()
        for label, _, fused in [name.partition("__")]
    ]
    return {"builds": builds, "peaks": [{"instructions": "AVX2", "limits": limits(20, 0.1)}]}


def test_shares_are_of_the_faster_build_for_the_same_instructions() -> None:
    found = made_up(one=3.0, batch=4.0, plain=10.0, plain__fused=6.0, closed=5.0, closed__fused=7.0)
    values = {each["name"]: each["values"]["AVX2"] for each in shares(found)}
    assert values == pytest.approx(
        {
            "one pose, share of CasADi's closed form": 3 / 5,
            "one pose, share of CasADi's plain C": 3 / 6,
            "batch, share of CasADi's plain C": 4 / 6,
            "batch, share of the limit reached": 2 / 4,
        }
    )


def test_functions_are_compared_with_one_pose_of_now_and_of_when_targets_were_set() -> None:
    found = made_up(inverse=2.0, forward=3.0, plain=10.0, plain__fused=6.0, regressor=1500.0)
    made = {each["name"]: each for each in shares(found)}
    now, then, regressor = (made[name] for name in made if not name.startswith("one"))
    assert now["values"] == {"AVX2": 1.5}
    assert "at_most" not in now
    assert then["values"]["AVX2"] == pytest.approx(3 / (BASIS * 10))
    assert (then["at_most"], then["goal"]) == (1.2, 1.0)
    assert (regressor["unit"], regressor["values"]) == ("us", {"AVX2": 1.5})


# the processor


def test_multiply_adds_are_what_their_count_says() -> None:
    for kind in targets():
        loop = multiply_add(kind.flags)
        assert loop.set == kind.name
        assert loop.lanes in (2, 4, 8)
        assert loop.units % (12 * loop.lanes) == 0
        loop.run(1)


def test_without_avx_512_code_is_compiled_for_avx2() -> None:
    first, *others = targets()
    assert [kind.name for kind in others] == (["AVX2"] if first.name == "AVX-512" else [])


def test_a_chain_of_additions_waits_for_each_one() -> None:
    tasks = {"chain": additions(), "multiply-add": multiply_add()}
    raw = timing.measured(tasks, dict.fromkeys(tasks, 9), silent)
    clock = 1 / min(raw["chain"])
    assert 0.3 < clock < 8
    vectors = min(raw["chain"]) / min(raw["multiply-add"]) / multiply_add().lanes
    assert 0.4 < vectors < 5


SUM = """
typedef double lanes __attribute__((vector_size(BYTES)));
static __attribute__((noinline)) void inner(lanes *x) { *x = *x * *x; }
void outer(lanes *x) { inner(x); *x = *x + 1; }
double alone(double x) { return x * x; }
"""


@pytest.mark.parametrize("bits", [128, 256])
def test_the_width_of_code_is_that_of_the_functions_called(bits: int) -> None:
    if targets()[0].name not in ("AVX-512", "AVX2") or shutil.which("objdump") is None:
        pytest.skip("needs AVX2 and objdump")
    library = native.load("bench_width", {"sum.c": SUM.replace("BYTES", str(bits // 8))})
    assert widest(library, "outer") == bits
    assert widest(library, "alone") == 64
    assert widest(library, "none") is None


def test_the_width_is_unknown_without_the_tool(monkeypatch: pytest.MonkeyPatch) -> None:
    library = native.load("bench_width", {"sum.c": SUM.replace("BYTES", "16")})
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert widest(library, "outer") is None
