// The items that --shard of `adit run` goes by: each recording (steering remembers within it) and each single image.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adit/io/frame_source.hpp"
#include "frame_line.hpp"
#include "parts.hpp"
#include "run_outputs.hpp"
#include "shard.hpp"

namespace adit::tools {

/// Refuses what cannot be joined again: pictures, videos, a limit, standard output, a camera, a column of times.
/// @throws CLI::ValidationError
void check_shard(const Shard& shard, const OutputOptions& outputs, const std::vector<std::string>& inputs,
                 std::int64_t limit);

/// What the parts of this run say of themselves.
/// @param sources  opened for this alone: they are listed to their end. Pixels of images are not read.
[[nodiscard]] PartLabel run_label(const Shard& shard, const std::vector<std::string>& inputs,
                                  std::vector<std::unique_ptr<io::FrameSource>> sources, double images_hz,
                                  const LineSettings& settings);

}  // namespace adit::tools
