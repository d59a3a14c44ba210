"""The Python module: arrays of all layouts, configuration by name, threads, stubs."""
import ast
import copy
import inspect
import os
import pathlib
import pickle
import re
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import adit

SOURCE = pathlib.Path(os.environ["ADIT_SOURCE_FOLDER"])
HEIGHT, WIDTH = 240, 320


def passage(u=220, v=120, seed=1, channels=3):
    """Lit rock, brighter to the left and warm, with a dark round opening; BGR."""
    rng = np.random.default_rng(seed)
    vv, uu = np.mgrid[0:HEIGHT, 0:WIDTH]
    rock = 130 - uu / 8 + rng.integers(0, 4, (HEIGHT, WIDTH))
    grey = np.where((uu - u) ** 2 + (vv - v) ** 2 < 900, 12, rock)
    if channels == 1:
        return grey.astype(np.uint8)
    return np.stack([grey * 0.8, grey * 0.9, grey], axis=-1).astype(np.uint8)


def answer(seen):
    return (seen.status, seen.centroid_px, seen.point, seen.azimuth_rad, seen.confidence, seen.atmospheric_light,
            len(seen.openings))


@pytest.fixture(params=["paper", "adit"])
def finder(request):
    return adit.OpenSpaceFinder(adit.Config(method=request.param))


def test_finds_the_opening(finder):
    seen = finder.find(passage())
    assert seen.found and seen.status == "found"
    assert seen.centroid_px == pytest.approx((220, 120), abs=12)
    assert seen.azimuth_rad > 0.1  # to the right is positive
    assert seen.openings[0].centroid_px == seen.centroid_px
    assert 0 <= seen.confidence <= 1 and seen.total_ns > 0
    assert set(seen.flags) == {"dust", "glare", "blocked_lens", "too_dark", "too_bright", "dirty_lens"}
    assert "found" in repr(seen)


def layouts():
    frame = passage()
    padded = np.zeros((HEIGHT, WIDTH + 13, 3), np.uint8)
    padded[:, :WIDTH] = frame
    rows = np.zeros((2 * HEIGHT, WIDTH, 3), np.uint8)
    rows[::2] = frame
    yield "whole", frame, "bgr"
    yield "region of a larger one", padded[:, :WIDTH], "bgr"
    yield "every second row", rows[::2], "bgr"
    yield "rows from the end", np.ascontiguousarray(frame[::-1])[::-1], "bgr"
    yield "rgb", np.ascontiguousarray(frame[..., ::-1]), "rgb"
    yield "rgb by a view", frame[..., ::-1], "rgb"
    yield "rgb by a view, rows from the end", np.ascontiguousarray(frame[::-1])[::-1][..., ::-1], "rgb"
    yield "bgra", np.dstack([frame, np.full((HEIGHT, WIDTH), 7, np.uint8)]), "bgra"
    yield "rgba", np.dstack([frame[..., ::-1], np.full((HEIGHT, WIDTH), 7, np.uint8)]), "rgba"
    four = np.dstack([frame, np.full((HEIGHT, WIDTH), 7, np.uint8)])
    yield "colours of four", four[..., :3], "bgr"
    yield "colours of four, from the other end", four[..., 2::-1], "rgb"
    yield "colours of four, rows from the end", np.ascontiguousarray(four[::-1])[::-1][..., :3], "bgr"
    yield "colours of four, the last", np.roll(four, 1, axis=2)[..., 1:], "bgr"
    cut = np.ndarray((HEIGHT, WIDTH, 3), np.uint8, four.tobytes()[:-1], 0, (4 * WIDTH, 4, 1))  # ends with the third
    yield "colours of four, cut off", cut, "bgr"
    yield "mirrored", np.ascontiguousarray(frame[:, ::-1])[:, ::-1], "bgr"
    yield "every second column", np.repeat(frame, 2, axis=1)[:, ::2], "bgr"
    yield "planes", np.moveaxis(np.ascontiguousarray(np.moveaxis(frame, 2, 0)), 0, 2), "bgr"
    yield "columns first", np.asfortranarray(frame), "bgr"
    read_only = frame.copy()
    read_only.flags.writeable = False
    yield "read-only", read_only, "bgr"
    yield "turned by 180 degrees", np.ascontiguousarray(frame[::-1, ::-1])[::-1, ::-1], "bgr"
    yield "planes of rgb, mirrored", np.moveaxis(np.ascontiguousarray(np.moveaxis(frame[:, ::-1, ::-1], 2, 0)), 0, 2)[:, ::-1], "rgb"
    yield "columns first, rgb by a view", np.asfortranarray(frame)[..., ::-1], "rgb"
    record = np.zeros((HEIGHT, WIDTH), [("stamp", np.uint8), ("bgr", np.uint8, 3), ("range", np.uint16)])
    record["bgr"] = frame
    yield "part of a record", record["bgr"], "bgr"


@pytest.mark.parametrize("name,frame,order", list(layouts()), ids=lambda value: value if isinstance(value, str) else "")
def test_every_layout_gives_the_same_answer(finder, name, frame, order):
    before = frame.copy()
    assert answer(finder.find(frame, order=order)) == answer(finder.find(passage()))
    assert np.array_equal(frame, before)


def test_no_layout_is_copied(finder):
    """A copy of this frame would be 50 MB more, and the peak of the memory would show it."""
    resource = pytest.importorskip("resource")
    frame = np.zeros((4096, 4096, 3), np.uint8)
    frame[:, :, :] = np.arange(4096, dtype=np.uint16)[:, None, None] % 251
    finder.find(frame)  # its buffers
    before_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for view in (frame[:, ::-1], frame[::-1, ::-1], frame.transpose(1, 0, 2), np.broadcast_to(frame[:, :, :1], frame.shape)):
        finder.find(view)
    grown_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kib
    assert grown_kib * 1024 < frame.nbytes / 4, f"{grown_kib} KiB"


def test_broadcast_arrays_are_frames(finder):
    grey = passage(channels=1)
    assert answer(finder.find(np.broadcast_to(grey[..., None], grey.shape + (3,)))) == answer(finder.find(grey))
    for line in (grey[100], grey[:, 100:101]):
        wide = np.broadcast_to(line, grey.shape)
        assert answer(finder.find(wide)) == answer(finder.find(wide.copy()))


def test_grey_8_and_16_bits(finder):
    grey = passage(channels=1)
    wanted = answer(finder.find(grey))
    assert wanted[0] == "found"
    assert answer(finder.find(grey[..., None])) == wanted
    assert answer(finder.find(grey, order="grey")) == wanted
    assert answer(finder.find(np.ascontiguousarray(grey.T).T)) == wanted  # columns first
    wide = grey.astype(np.uint16) << 8
    assert answer(finder.find(wide)) == wanted
    assert answer(finder.find(np.ascontiguousarray(wide[::-1])[::-1])) == wanted
    assert answer(finder.find(np.repeat(wide, 2, axis=1)[:, ::2])) == wanted
    odd = np.zeros(wide.nbytes + 1, np.uint8)
    odd[1:] = wide.view(np.uint8).ravel()
    assert answer(finder.find(odd[1:].view(np.uint16).reshape(wide.shape))) == wanted


def test_a_broadcast_row_is_a_frame_of_equal_rows(finder):
    row = passage()[120]
    wide = np.broadcast_to(row, (HEIGHT, WIDTH, 3))
    assert answer(finder.find(wide)) == answer(finder.find(np.ascontiguousarray(wide)))


@pytest.mark.parametrize("frame,order,error,words", [
    (np.zeros((48, 64, 3), np.float32), "", TypeError, "float32"),
    (np.zeros((48, 64), bool), "", TypeError, "bool"),
    (np.zeros((48, 64), ">u2"), "", TypeError, ">u2|uint16"),
    (np.zeros((48, 64, 3), np.uint16), "", ValueError, r"\(48, 64, 3\)"),
    (np.zeros(48, np.uint8), "", ValueError, r"\(48,\)"),
    (np.zeros((48, 64, 2), np.uint8), "", ValueError, r"\(48, 64, 2\)"),
    (np.zeros((48, 64, 3), np.uint8), "bgra", ValueError, "bgra"),
    (np.zeros((48, 64, 3), np.uint8), "yuv", ValueError, "yuv"),
])
def test_what_is_no_frame_is_refused_in_words(frame, order, error, words):
    with pytest.raises(error, match=words):
        adit.OpenSpaceFinder().find(frame, order=order)


def test_a_frame_that_cannot_be_judged_is_an_answer():
    finder = adit.OpenSpaceFinder(adit.Config(method="paper"))
    assert finder.find(np.zeros((8, 8), np.uint8)).status == "bad_frame"
    assert finder.find(np.zeros((0, 0, 3), np.uint8)).status == "bad_frame"
    black = finder.find(np.zeros((48, 64), np.uint8))
    assert black.status == "too_dark" and not black.found and black.openings == []
    camera = adit.Camera.pinhole(640, 480, 70.0)
    assert adit.OpenSpaceFinder(adit.Config(method="paper"), camera).find(passage()).status == "wrong_size"


CONFIGS = [adit.Config, adit.HeadingConfig, adit.ColumnRangeConfig, adit.RangeMemoryConfig, adit.TrackerConfig,
           adit.SteeringConfig, adit.FrameWatchConfig, adit.LensWatchConfig]


@pytest.mark.parametrize("config", CONFIGS, ids=lambda c: c.__name__)
def test_every_field_by_name(config):
    fields = config.fields()
    assert fields
    values = {name: about["default"] for name, about in fields.items()}
    made = config(**values)
    assert made == config() and made.to_dict() == values
    for name, about in fields.items():
        assert getattr(made, name) == about["default"]
        setattr(made, name, about["default"])
        assert about["meaning"] and about["meaning"] in getattr(config, name).__doc__
        if not isinstance(about["default"], str) and about["maximum"] < 1e9:
            with pytest.raises((ValueError, TypeError), match=name):
                setattr(made, name, type(about["default"])(2 * about["maximum"] + 1))
        assert getattr(made, name) == about["default"]  # what is refused changes nothing


def test_configuration_is_checked_and_copied():
    config = adit.Config(method="adit", omega=0.9)
    assert config.method == "adit" and config.omega == 0.9
    for one in (copy.copy(config), copy.deepcopy(config), pickle.loads(pickle.dumps(config))):
        assert one == config and one is not config
    other = copy.copy(config)
    other.omega = 0.5
    assert config.omega == 0.9 and other != config and config != 3
    assert "omega=0.9" in repr(config)
    assert adit.OpenSpaceFinder(config).config == config
    with pytest.raises(ValueError, match="omega: 1.5 is not in"):
        adit.Config(omega=1.5)
    with pytest.raises(ValueError, match="method: 'magic' is none of: paper, adit"):
        adit.Config(method="magic")
    with pytest.raises(TypeError, match="cluster_count"):
        adit.Config(cluster_count=3.5)
    with pytest.raises(TypeError, match="omega"):
        adit.Config(omega="0.9")
    with pytest.raises(TypeError, match="no field 'omgea'"):
        adit.Config(omgea=0.9)
    assert adit.Config(cluster_count=np.int64(5), omega=np.float32(0.5)).cluster_count == 5


def test_camera():
    camera = adit.Camera(640, 480, focal_length_x_px=400, focal_length_y_px=410, principal_point_x_px=320,
                         principal_point_y_px=240, distortion_model="plumb_bob", distortion=[-0.3, 0.1, 0, 0, 0])
    azimuth, elevation = camera.bearing_of(500, 100)
    assert azimuth > 0 and elevation > 0
    assert camera.pixel_of(azimuth, elevation) == pytest.approx((500, 100), abs=1e-6)
    assert camera.pixel_of(2.0, 0.0) is None
    with pytest.raises(ValueError, match="5 coefficients"):
        adit.Camera(640, 480, focal_length_x_px=400, focal_length_y_px=410, principal_point_x_px=320,
                    principal_point_y_px=240, distortion_model="plumb_bob", distortion=[1.0])
    with pytest.raises(ValueError, match="focal_length"):
        adit.Camera(640, 480, focal_length_x_px=0, focal_length_y_px=410, principal_point_x_px=320,
                    principal_point_y_px=240)


def test_stage_images_outlive_everything():
    finder = adit.OpenSpaceFinder(adit.Config(method="adit"))
    seen, images = finder.explain(passage())
    dark = images.dark_channel
    assert dark.shape == (HEIGHT, WIDTH) and dark.dtype == np.uint8
    assert images.scattering_depth.dtype == np.float32 and images.openings is not None
    assert answer(seen) == answer(finder.find(passage()))
    copied = dark.copy()
    del finder, images
    np.zeros(1 << 20)
    assert np.array_equal(dark, copied)
    _, paper = adit.OpenSpaceFinder(adit.Config(method="paper")).explain(passage())
    assert paper.openings is None and paper.binary is not None


def test_threads_share_a_finder_and_get_the_same_answers(finder):
    frames = [passage(u=100 + 10 * i, seed=i) for i in range(8)]
    wanted = [answer(finder.find(frame)) for frame in frames]
    got = [None] * len(frames)

    def judge(i):
        for _ in range(20):
            got[i] = answer(finder.find(frames[i]))

    threads = [threading.Thread(target=judge, args=(i,)) for i in range(len(frames))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert got == wanted


def test_the_interpreter_runs_on_while_a_frame_is_judged():
    # Slow on purpose: a large frame, and a lot of work on it.
    finder = adit.OpenSpaceFinder(adit.Config(method="paper", clustering="lloyd", lloyd_starts=1000,
                                              lloyd_iterations_max=10000, lloyd_tolerance=0))
    frame = np.random.default_rng(1).integers(0, 256, (2048, 2048), np.uint8)
    finder.find(frame)
    enough = threading.Event()
    judged = 0

    def judge():
        nonlocal judged
        while not enough.is_set():
            finder.find(frame)
            judged += 1

    thread = threading.Thread(target=judge)
    thread.start()
    for _ in range(100):
        time.sleep(0.0001)
    enough.set()
    thread.join()
    assert judged < 50  # with the lock held, the main thread takes one step a frame and no more


def test_navigator_follows_and_sees_a_frozen_camera():
    navigator = adit.Navigator(adit.Config(method="adit"), steering=adit.SteeringConfig(prefer="left"))
    for i in range(15):
        frame = passage(seed=i)
        command, seen = navigator.update(frame, 0.05 * i, speed_m_s=1.0)
        assert seen.found and command.status == "found"
    assert command.manoeuvre == "follow" and command.yaw_rate_rad_s < 0  # the opening is to the right
    for i in range(4):
        command, _ = navigator.update(frame, 0.8 + 0.05 * i)
    assert command.status == "frozen_frame"
    assert navigator.tick(9.0).heading_state == "hold"
    navigator.reset()


def test_heading_controller_turns_towards_the_opening():
    controller = adit.HeadingController(adit.HeadingConfig(gain_per_s=1.0))
    seen = adit.OpenSpaceFinder(adit.Config(method="paper")).find(passage())
    commands = [controller.update(seen, 0.05 * i) for i in range(10)]
    assert commands[-1].state == "steer" and commands[-1].yaw_rate_rad_s < 0
    assert controller.tick(5.0).state == "hold"


def test_cpu_targets_give_the_same_bits():
    before = adit.cpu_target()
    try:
        answers = set()
        for name in adit.supported_cpu_targets():
            adit.use_cpu_target(name)
            answers.add(answer(adit.OpenSpaceFinder(adit.Config(method="adit")).find(passage())))
        assert len(answers) == 1
    finally:
        adit.use_cpu_target(before)
    with pytest.raises(ValueError, match="quantum"):
        adit.use_cpu_target("quantum")


def test_the_stub_is_the_one_that_is_made():
    made = subprocess.run([sys.executable, str(SOURCE / "python/stubs/make_stub.py")], check=True, capture_output=True,
                          text=True)
    assert made.stdout == (SOURCE / "python/adit/__init__.pyi").read_text()


def test_the_stub_names_everything_there_is():
    tree = ast.parse((SOURCE / "python/adit/__init__.pyi").read_text())
    members = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            own = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            own |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            for base in node.bases:
                own |= members.get(getattr(base, "id", ""), set())
            members[node.name] = own
        elif isinstance(node, ast.FunctionDef):
            members[node.name] = set()
    for name in adit.__all__:
        if name == "__version__":
            continue
        assert name in members
        thing = getattr(adit, name)
        assert thing.__doc__
        if inspect.isclass(thing):
            there = {n for n in vars(thing) if not n.startswith("_")}
            assert there == {n for n in members[name] if not n.startswith("_")}, name
    assert (pathlib.Path(adit.__file__).parent / "py.typed").exists()


def test_the_example_draws_figure_2(tmp_path):
    image = pytest.importorskip("PIL.Image")
    picture = tmp_path / "figure_2.png"
    subprocess.run([sys.executable, str(SOURCE / "python/examples/figure_2.py"), str(SOURCE / "data/tunnel.jpg"),
                    str(picture)], check=True)
    drawn = np.asarray(image.open(picture))
    frame = np.asarray(image.open(SOURCE / "data/tunnel.jpg"))
    assert drawn.shape[0] >= frame.shape[0] and drawn.shape[1] >= 2 * frame.shape[1]
    left = drawn[:, :frame.shape[1]].astype(int)
    red = (left[..., 0] > 200) & (left[..., 1] < 60) & (left[..., 2] < 60)
    assert red.sum() > 50  # the circle


def test_what_the_docs_show_runs():
    shown = re.search(r"```python\n(.*?)```", (SOURCE / "docs/call.md").read_text(), re.DOTALL).group(1)
    names = {"frame": passage()}
    exec(shown, names)
    assert names["seen"].found and names["command"].heading_state in ("steer", "coast", "hold")
