// Lines that the diagnostics of both nodes share.
#pragma once

#include <string>
#include <string_view>

#include "adit/node/diagnosis.hpp"
#include "adit/node/latency.hpp"
#include "adit/node/stamp_check.hpp"

namespace adit::node {

/// With so many digits after the point.
[[nodiscard]] std::string text_of(double value, int digits);
/// Foreign words for a line to people: in quotes, cut where they are long, '?' for what is no printable ASCII.
[[nodiscard]] std::string quoted(std::string_view words);
/// As "NAME p50 (ms)" and so on.
void add_latency(Diagnosis& diagnosis, const std::string& name, const LatencyMeter& latency);
void add_stamps(Diagnosis& diagnosis, const StampCheck& stamps);

}  // namespace adit::node
