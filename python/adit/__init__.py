"""adit: where the open space is, in the dark, from one camera.

    import adit
    finder = adit.OpenSpaceFinder(adit.Config(method="adit"))
    seen = finder.find(frame)                 # a numpy array: BGR, or order="rgb"
    if seen.found:
        print(seen.azimuth_rad, seen.confidence)
"""

from ._adit import (
    Camera,
    ColumnRangeConfig,
    Config,
    FrameWatchConfig,
    HeadingCommand,
    HeadingConfig,
    HeadingController,
    LensWatchConfig,
    Navigator,
    NavigatorCommand,
    Opening,
    OpenSpace,
    OpenSpaceFinder,
    RangeMemoryConfig,
    StageImages,
    SteeringConfig,
    TrackerConfig,
    __version__,
    cpu_target,
    supported_cpu_targets,
    use_cpu_target,
)

__all__ = [
    "Camera",
    "ColumnRangeConfig",
    "Config",
    "FrameWatchConfig",
    "HeadingCommand",
    "HeadingConfig",
    "HeadingController",
    "LensWatchConfig",
    "Navigator",
    "NavigatorCommand",
    "OpenSpace",
    "OpenSpaceFinder",
    "Opening",
    "RangeMemoryConfig",
    "StageImages",
    "SteeringConfig",
    "TrackerConfig",
    "__version__",
    "cpu_target",
    "supported_cpu_targets",
    "use_cpu_target",
]
