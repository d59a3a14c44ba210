// Between the structs of adit.h and those of the core.
#pragma once

#include <optional>

#include "adit.h"
#include "adit/navigator.hpp"

namespace adit::c_interface {

/// @throws std::invalid_argument
[[nodiscard]] ImageView view_of(const adit_image* image);
/// Nothing for NULL. @throws std::invalid_argument
[[nodiscard]] std::optional<Camera> camera_of(const adit_camera* camera);
[[nodiscard]] Motion motion_of(const adit_motion* motion);
[[nodiscard]] adit_open_space c_of(const OpenSpace& open_space) noexcept;
[[nodiscard]] adit_opening c_of(const Opening& opening) noexcept;
[[nodiscard]] adit_command c_of(const NavigatorCommand& command) noexcept;

}  // namespace adit::c_interface
