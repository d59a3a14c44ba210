# Made by python/stubs/make_stub.py; do not edit.
from typing import Any, Literal, Optional, Sequence, TypedDict, final

import numpy as np
import numpy.typing as npt

__version__: str
Frame = npt.NDArray[np.uint8] | npt.NDArray[np.uint16]
Order = Literal["", "bgr", "rgb", "bgra", "rgba", "grey"]

class Field(TypedDict):
    default: float | int | str
    unit: str
    minimum: float
    maximum: float
    meaning: str
    source: str

@final
class Config:
    def __init__(self, *,
        method: str = ...,
        patch_size_px: int = ...,
        patch_size_vga_px: int = ...,
        structuring_element_size_px: int = ...,
        structuring_element_size_vga_px: int = ...,
        omega: float = ...,
        atmospheric_light_fraction: float = ...,
        transmission_min: float = ...,
        scattering_coefficient: float = ...,
        cluster_count: int = ...,
        clustering: str = ...,
        lloyd_seed: int = ...,
        lloyd_starts: int = ...,
        lloyd_iterations_max: int = ...,
        lloyd_tolerance: float = ...,
        grey16_depth_bits: int = ...,
        assumed_hfov_deg: float = ...,
        too_dark_light_max: float = ...,
        too_bright_level_min: int = ...,
        contrast_levels_min: int = ...,
        area_fraction_min: float = ...,
        light_gamma: float = ...,
        noise_level: float = ...,
        horizon_spread_deg: float = ...,
        horizon_floor: float = ...,
        way_odds_min: float = ...,
        dust_veil_min: float = ...,
    ) -> None: ...
    method: str
    patch_size_px: int
    patch_size_vga_px: int
    structuring_element_size_px: int
    structuring_element_size_vga_px: int
    omega: float
    atmospheric_light_fraction: float
    transmission_min: float
    scattering_coefficient: float
    cluster_count: int
    clustering: str
    lloyd_seed: int
    lloyd_starts: int
    lloyd_iterations_max: int
    lloyd_tolerance: float
    grey16_depth_bits: int
    assumed_hfov_deg: float
    too_dark_light_max: float
    too_bright_level_min: int
    contrast_levels_min: int
    area_fraction_min: float
    light_gamma: float
    noise_level: float
    horizon_spread_deg: float
    horizon_floor: float
    way_odds_min: float
    dust_veil_min: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> Config: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> Config: ...

@final
class HeadingConfig:
    def __init__(self, *,
        gain_per_s: float = ...,
        yaw_rate_max_rad_s: float = ...,
        yaw_acceleration_max_rad_s2: float = ...,
        dead_band_rad: float = ...,
        hold_after_s: float = ...,
    ) -> None: ...
    gain_per_s: float
    yaw_rate_max_rad_s: float
    yaw_acceleration_max_rad_s2: float
    dead_band_rad: float
    hold_after_s: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> HeadingConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> HeadingConfig: ...

@final
class ColumnRangeConfig:
    def __init__(self, *,
        display_gamma: float = ...,
        fall_off_exponent: float = ...,
        band_low_deg: float = ...,
        band_high_deg: float = ...,
        camera_height_m: float = ...,
        range_min_m: float = ...,
        range_max_m: float = ...,
        veil_per_extinction_m: float = ...,
    ) -> None: ...
    display_gamma: float
    fall_off_exponent: float
    band_low_deg: float
    band_high_deg: float
    camera_height_m: float
    range_min_m: float
    range_max_m: float
    veil_per_extinction_m: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> ColumnRangeConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> ColumnRangeConfig: ...

@final
class RangeMemoryConfig:
    def __init__(self, *,
        range_smoothing_s: float = ...,
        veil_rise_s: float = ...,
        keep_s: float = ...,
    ) -> None: ...
    range_smoothing_s: float
    veil_rise_s: float
    keep_s: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> RangeMemoryConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> RangeMemoryConfig: ...

@final
class TrackerConfig:
    def __init__(self, *,
        gate_rad: float = ...,
        bearing_smoothing_s: float = ...,
        trust_s: float = ...,
        forget_s: float = ...,
        switch_ratio: float = ...,
        switch_after_s: float = ...,
    ) -> None: ...
    gate_rad: float
    bearing_smoothing_s: float
    trust_s: float
    forget_s: float
    switch_ratio: float
    switch_after_s: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> TrackerConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> TrackerConfig: ...

@final
class SteeringConfig:
    def __init__(self, *,
        prefer: str = ...,
        body_half_width_m: float = ...,
        margin_m: float = ...,
        clearance_m: float = ...,
        look_ahead_m: float = ...,
        clearance_weight: float = ...,
        goal_weight: float = ...,
        change_weight: float = ...,
        stop_range_m: float = ...,
        slow_range_m: float = ...,
        turn_rate_rad_s: float = ...,
        turn_min_rad: float = ...,
        clear_range_m: float = ...,
    ) -> None: ...
    prefer: str
    body_half_width_m: float
    margin_m: float
    clearance_m: float
    look_ahead_m: float
    clearance_weight: float
    goal_weight: float
    change_weight: float
    stop_range_m: float
    slow_range_m: float
    turn_rate_rad_s: float
    turn_min_rad: float
    clear_range_m: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> SteeringConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> SteeringConfig: ...

@final
class FrameWatchConfig:
    def __init__(self, *,
        frozen_frames: int = ...,
        torn_fraction_min: float = ...,
        torn_frames_max: int = ...,
    ) -> None: ...
    frozen_frames: int
    torn_fraction_min: float
    torn_frames_max: int
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> FrameWatchConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> FrameWatchConfig: ...

@final
class LensWatchConfig:
    def __init__(self, *,
        turn_step_rad: float = ...,
        each_way_min_rad: float = ...,
        looks_min: int = ...,
        dark_fraction: float = ...,
        rim_rad: float = ...,
    ) -> None: ...
    turn_step_rad: float
    each_way_min_rad: float
    looks_min: int
    dark_fraction: float
    rim_rad: float
    @staticmethod
    def fields() -> dict[str, Field]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __copy__(self) -> LensWatchConfig: ...
    def __deepcopy__(self, memo: dict[int, Any]) -> LensWatchConfig: ...

@final
class Camera:
    def __init__(
        self, width: int, height: int, *, focal_length_x_px: float, focal_length_y_px: float,
        principal_point_x_px: float, principal_point_y_px: float,
        distortion_model: Literal["none", "plumb_bob", "rational_polynomial", "equidistant"] = "none",
        distortion: Sequence[float] = (),
    ) -> None: ...
    @staticmethod
    def pinhole(width: int, height: int, hfov_deg: float) -> Camera: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    def bearing_of(self, u_px: float, v_px: float) -> tuple[float, float]: ...
    def pixel_of(self, azimuth_rad: float, elevation_rad: float) -> Optional[tuple[float, float]]: ...
    def normalised_of(self, u_px: float, v_px: float) -> tuple[float, float]: ...

class _Place:
    @property
    def centroid_px(self) -> tuple[float, float]: ...
    @property
    def point(self) -> tuple[float, float]: ...
    @property
    def azimuth_rad(self) -> float: ...
    @property
    def elevation_rad(self) -> float: ...
    @property
    def area_fraction(self) -> float: ...
    @property
    def confidence(self) -> float: ...

@final
class Opening(_Place):
    @property
    def box_px(self) -> tuple[float, float, float, float]: ...
    @property
    def half_width_rad(self) -> float: ...
    @property
    def half_height_rad(self) -> float: ...
    @property
    def score(self) -> float: ...
    @property
    def contrast(self) -> float: ...
    @property
    def touches_border(self) -> bool: ...

@final
class OpenSpace(_Place):
    @property
    def found(self) -> bool: ...
    @property
    def status(self) -> str: ...
    @property
    def openings(self) -> list[Opening]: ...
    @property
    def rule(self) -> str: ...
    @property
    def flags(self) -> dict[str, bool]: ...
    @property
    def veil_fraction(self) -> float: ...
    @property
    def atmospheric_light(self) -> float: ...
    @property
    def darkest_level(self) -> int: ...
    @property
    def brightest_level(self) -> int: ...
    @property
    def threshold_level(self) -> int: ...
    @property
    def total_ns(self) -> int: ...
    @property
    def stage_ns(self) -> dict[str, int]: ...

@final
class StageImages:
    @property
    def dark_channel(self) -> Optional[npt.NDArray[np.uint8]]: ...
    @property
    def transmission(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def scattering_depth(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def closing(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def closing_level(self) -> Optional[npt.NDArray[np.uint8]]: ...
    @property
    def cluster(self) -> Optional[npt.NDArray[np.uint8]]: ...
    @property
    def binary(self) -> Optional[npt.NDArray[np.uint8]]: ...
    @property
    def light(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def enclosure(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def openings(self) -> Optional[npt.NDArray[np.uint8]]: ...

@final
class OpenSpaceFinder:
    def __init__(self, config: Config = ..., camera: Optional[Camera] = None) -> None: ...
    @property
    def config(self) -> Config: ...
    def find(self, frame: Frame, order: Order = "") -> OpenSpace: ...
    def explain(self, frame: Frame, order: Order = "") -> tuple[OpenSpace, StageImages]: ...

@final
class HeadingCommand:
    @property
    def state(self) -> Literal["steer", "coast", "hold"]: ...
    @property
    def yaw_rate_rad_s(self) -> float: ...

@final
class HeadingController:
    def __init__(self, config: HeadingConfig = ...) -> None: ...
    def update(self, open_space: OpenSpace, stamp_s: float) -> HeadingCommand: ...
    def tick(self, now_s: float) -> HeadingCommand: ...
    def reset(self) -> None: ...

@final
class NavigatorCommand:
    @property
    def heading_state(self) -> Literal["steer", "coast", "hold"]: ...
    @property
    def yaw_rate_rad_s(self) -> float: ...
    @property
    def speed_scale(self) -> float: ...
    @property
    def manoeuvre(self) -> Literal["wait", "follow", "turn", "give_up"]: ...
    @property
    def status(self) -> str: ...
    @property
    def stamp_fault(self) -> Literal["none", "not_later", "backwards", "jump"]: ...
    @property
    def target_rad(self) -> float: ...
    @property
    def goal_rad(self) -> float: ...
    @property
    def free_m(self) -> float: ...

@final
class Navigator:
    def __init__(
        self, config: Config = ..., camera: Optional[Camera] = None, *, heading: HeadingConfig = ...,
        column_range: ColumnRangeConfig = ..., range_memory: RangeMemoryConfig = ..., tracker: TrackerConfig = ...,
        steering: SteeringConfig = ..., frame_watch: FrameWatchConfig = ...,
        lens_watch: LensWatchConfig = ...,
    ) -> None: ...
    def update(
        self, frame: Frame, stamp_s: float, *, yaw_rate_rad_s: Optional[float] = None,
        speed_m_s: Optional[float] = None, order: Order = "",
    ) -> tuple[NavigatorCommand, OpenSpace]: ...
    def tick(self, now_s: float) -> NavigatorCommand: ...
    def reset(self) -> None: ...

def cpu_target() -> str: ...
def supported_cpu_targets() -> list[str]: ...
def use_cpu_target(name: str) -> None: ...
