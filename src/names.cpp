// The spelling of every enumeration, once.
#include <array>
#include <cstddef>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/navigator.hpp"

namespace adit {
namespace {

constexpr std::array<std::string_view, kStatusCount> kStatusNames{
    "found",      "too_dark",   "too_bright",   "no_contrast", "no_region",    "bad_frame",
    "wrong_size", "no_opening", "blocked_lens", "dust",        "frozen_frame", "torn_frame"};
constexpr std::array<std::string_view, kRuleCount> kRuleNames{
    "none", "darkest_cluster", "enclosed", "open_sided", "veil", "flash"};
constexpr std::array<std::string_view, 2> kMethodNames{"paper", "adit"};
constexpr std::array<std::string_view, 2> kClusteringNames{"exact", "lloyd"};
constexpr std::array<std::string_view, kStageCount> kStageNames{"dark_channel", "scattering_depth", "closing",
                                                                "clusters", "moments"};
constexpr std::array<std::string_view, 3> kHeadingStateNames{"steer", "coast", "hold"};
constexpr std::array<std::string_view, 4> kManoeuvreNames{"wait", "follow", "turn", "give_up"};
constexpr std::array<std::string_view, 4> kStampFaultNames{"none", "not_later", "backwards", "jump"};
constexpr std::array<std::string_view, 4> kPreferNames{"straight", "left", "right", "explore"};
constexpr std::array<std::string_view, 4> kDistortionNames{"none", "plumb_bob", "rational_polynomial", "equidistant"};

template <class Enum, std::size_t N>
std::string_view name_of(const std::array<std::string_view, N>& names, Enum value) noexcept {
  const auto at = static_cast<std::size_t>(value);
  return at < N ? names[at] : std::string_view("unknown");
}

template <class Enum, std::size_t N>
bool find_name(const std::array<std::string_view, N>& names, std::string_view name, Enum& value) noexcept {
  for (std::size_t at = 0; at < N; ++at) {
    if (names[at] == name) {
      value = static_cast<Enum>(at);
      return true;
    }
  }
  return false;
}

}  // namespace

std::string_view to_string(Status status) noexcept { return name_of(kStatusNames, status); }
std::string_view to_string(Rule rule) noexcept { return name_of(kRuleNames, rule); }
std::string_view to_string(Method method) noexcept { return name_of(kMethodNames, method); }
std::string_view to_string(Clustering clustering) noexcept { return name_of(kClusteringNames, clustering); }
std::string_view to_string(Stage stage) noexcept { return name_of(kStageNames, stage); }
std::string_view to_string(HeadingState state) noexcept { return name_of(kHeadingStateNames, state); }
std::string_view to_string(Manoeuvre manoeuvre) noexcept { return name_of(kManoeuvreNames, manoeuvre); }
std::string_view to_string(StampFault fault) noexcept { return name_of(kStampFaultNames, fault); }
std::string_view to_string(Prefer prefer) noexcept { return name_of(kPreferNames, prefer); }
std::string_view to_string(DistortionModel model) noexcept { return name_of(kDistortionNames, model); }

bool parse(std::string_view name, Status& status) noexcept { return find_name(kStatusNames, name, status); }
bool parse(std::string_view name, Rule& rule) noexcept { return find_name(kRuleNames, name, rule); }
bool parse(std::string_view name, Method& method) noexcept { return find_name(kMethodNames, name, method); }
bool parse(std::string_view name, Clustering& clustering) noexcept {
  return find_name(kClusteringNames, name, clustering);
}
bool parse(std::string_view name, Prefer& prefer) noexcept { return find_name(kPreferNames, name, prefer); }
bool parse(std::string_view name, DistortionModel& model) noexcept { return find_name(kDistortionNames, name, model); }

}  // namespace adit
