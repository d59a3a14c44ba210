// adit.h over the C++ core.
#include "adit.h"

#include <cstdio>
#include <memory>
#include <utility>

#include "adit/cpu_target.hpp"
#include "adit/navigator.hpp"
#include "config_fields.hpp"
#include "convert.hpp"
#include "errors.hpp"
#include "sized_struct.hpp"

using namespace adit::c_interface;

struct adit_config {
  adit::NavigatorConfig config;
  std::vector<std::string> names = field_names();
};

struct adit_finder {
  adit::OpenSpaceFinder finder;
  adit::OpenSpace last;
  adit::StageImages images;
};

struct adit_navigator {
  adit::Navigator navigator;
};

namespace {

constexpr std::size_t kErrorLength = 512;
thread_local char last_error[kErrorLength] = "";

}  // namespace

void adit::c_interface::keep_error(const char* text) noexcept { std::snprintf(last_error, kErrorLength, "%s", text); }

const char* adit_version(void) { return ADIT_VERSION; }
int adit_abi_version(void) { return ADIT_ABI_VERSION; }
const char* adit_last_error(void) { return last_error; }

// The names are string literals: what the view shows ends with a zero.
const char* adit_status_name(int status) {
  if (status < 0 || status >= adit::kStatusCount) return "unknown";
  return adit::to_string(static_cast<adit::Status>(status)).data();
}
const char* adit_cpu_target(void) { return adit::cpu_target().data(); }

adit_config* adit_config_create(void) {
  adit_config* made = nullptr;
  guarded([&] { made = new adit_config; });
  return made;
}

void adit_config_destroy(adit_config* config) { delete config; }

adit_error adit_config_set(adit_config* config, const char* field, const char* value) {
  return guarded([&] { set_field(given(config, "config").config, &given(field, "field"), &given(value, "value")); });
}

adit_error adit_config_set_number(adit_config* config, const char* field, double value) {
  return guarded([&] { set_field(given(config, "config").config, &given(field, "field"), value); });
}

adit_error adit_config_get(const adit_config* config, const char* field, char* text, size_t size) {
  return guarded([&] {
    const std::string value = field_text(given(config, "config").config, &given(field, "field"));
    std::snprintf(&given(text, "text"), size, "%s", value.c_str());
  });
}

const char* adit_config_field(const adit_config* config, size_t index) {
  return config != nullptr && index < config->names.size() ? config->names[index].c_str() : nullptr;
}

adit_error adit_finder_create(const adit_config* config, const adit_camera* camera, adit_finder** finder) {
  return guarded([&] {
    adit_finder*& made = given(finder, "finder");
    made = nullptr;
    const adit::FinderConfig& fields = given(config, "config").config.finder;
    const auto model = camera_of(camera);
    made = new adit_finder{model ? adit::OpenSpaceFinder(fields, *model) : adit::OpenSpaceFinder(fields), {}, {}};
  });
}

void adit_finder_destroy(adit_finder* finder) { delete finder; }

adit_error adit_finder_find(adit_finder* finder, const adit_image* image, adit_open_space* open_space) {
  return guarded([&] {
    adit_finder& f = given(finder, "finder");
    f.last = f.finder.find(view_of(image));
    write_sized(c_of(f.last), open_space, "open_space");
  });
}

adit_error adit_finder_explain(adit_finder* finder, const adit_image* image, adit_open_space* open_space) {
  return guarded([&] {
    adit_finder& f = given(finder, "finder");
    f.last = f.finder.explain(view_of(image), f.images);
    write_sized(c_of(f.last), open_space, "open_space");
  });
}

adit_error adit_finder_opening(const adit_finder* finder, int32_t index, adit_opening* opening) {
  return guarded([&] {
    const adit::OpenSpace& last = given(finder, "finder").last;
    if (index < 0 || index >= last.opening_count)
      throw std::invalid_argument("index: " + std::to_string(index) + " is not below the " +
                                  std::to_string(last.opening_count) + " openings of the last frame");
    write_sized(c_of(last.openings[static_cast<std::size_t>(index)]), opening, "opening");
  });
}

const void* adit_finder_image(const adit_finder* finder, int which, int32_t* width, int32_t* height) {
  if (finder == nullptr) return nullptr;
  const adit::StageImages& images = finder->images;
  if (width != nullptr) *width = images.width;
  if (height != nullptr) *height = images.height;
  const auto of = [](const auto& plane) -> const void* { return plane.empty() ? nullptr : plane.data(); };
  switch (which) {
    case ADIT_IMAGE_DARK_CHANNEL:
      return of(images.dark_channel);
    case ADIT_IMAGE_SCATTERING_DEPTH:
      return of(images.scattering_depth);
    case ADIT_IMAGE_CLOSING:
      return of(images.closing);
    case ADIT_IMAGE_CLUSTER:
      return of(images.cluster);
    case ADIT_IMAGE_BINARY:
      return of(images.binary);
    case ADIT_IMAGE_LIGHT:
      return of(images.light);
    case ADIT_IMAGE_ENCLOSURE:
      return of(images.enclosure);
    case ADIT_IMAGE_OPENINGS:
      return of(images.openings);
    default:
      return nullptr;
  }
}

adit_error adit_navigator_create(const adit_config* config, const adit_camera* camera, adit_navigator** navigator) {
  return guarded([&] {
    adit_navigator*& made = given(navigator, "navigator");
    made = nullptr;
    const adit::NavigatorConfig& fields = given(config, "config").config;
    const auto model = camera_of(camera);
    made = new adit_navigator{model ? adit::Navigator(fields, *model) : adit::Navigator(fields)};
  });
}

void adit_navigator_destroy(adit_navigator* navigator) { delete navigator; }

adit_error adit_navigator_update(adit_navigator* navigator, const adit_image* image, double stamp_s,
                                 const adit_motion* motion, adit_command* command, adit_open_space* open_space) {
  return guarded([&] {
    adit::Navigator& n = given(navigator, "navigator").navigator;
    const adit::ImageView view = view_of(image);
    const adit::Motion known = motion_of(motion);
    given(command, "command");
    const adit::Sight sight = n.look(view);
    if (open_space != nullptr) write_sized(c_of(sight.open_space), open_space, "open_space");
    write_sized(c_of(n.steer(sight, stamp_s, known)), command, "command");
  });
}

adit_error adit_navigator_tick(adit_navigator* navigator, double now_s, adit_command* command) {
  return guarded([&] {
    adit::Navigator& n = given(navigator, "navigator").navigator;
    given(command, "command");
    write_sized(c_of(n.tick(now_s)), command, "command");
  });
}

adit_error adit_navigator_reset(adit_navigator* navigator) {
  return guarded([&] { given(navigator, "navigator").navigator.reset(); });
}
