// Bags as rows of frames.
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "adit/io/bag_file.hpp"
#include "adit/io/errors.hpp"
#include "bag_messages.hpp"

namespace adit::io {
namespace {

std::string fault_text(const std::filesystem::path& path, const std::exception& e) {
  std::string why = e.what();
  std::replace(why.begin(), why.end(), '\n', ' ');
  return path.string() + ": a damaged bag (" + why + "); rosbag check and rosbag fix may save what is left";
}

/// @throws InputError, in our words.
template <class Work>
auto with_bag_faults(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const rosbag::BagUnindexedException&) {
    throw InputError(path.string() + ": the bag has no index, because its recording was not closed; rosbag reindex " +
                     path.filename().string() + " makes one");
  } catch (const InputError&) {
    throw;
  } catch (
      const std::exception& e) {  // of the library, of the allocator, of the string classes: a bag is foreign bytes
    throw InputError(fault_text(path, e));
  }
}

void open(rosbag::Bag& bag, const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path.string() + ": there is no such file");
  if (std::filesystem::file_size(path, error) == 0) throw InputError(path.string() + ": the file is empty");
  bag.open(path.string(), rosbag::bagmode::Read);
}

std::vector<BagTopic> topics(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  std::map<std::string, BagTopic> by_name;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    BagTopic& topic = by_name[connection->topic];
    topic.name = connection->topic;
    topic.type = connection->datatype;
  }
  std::vector<BagTopic> list;
  for (auto& [name, topic] : by_name) {
    rosbag::View messages(bag, rosbag::TopicQuery(name));
    topic.messages = messages.size();
    list.push_back(topic);
  }
  return list;
}

std::string names_of(const std::vector<BagTopic>& list) {
  std::string names;
  for (const BagTopic& topic : list) names += (names.empty() ? "" : ", ") + topic.name + " (" + topic.type + ")";
  return names.empty() ? "nothing" : names;
}

/// The topic to read. @throws InputError
BagTopic chosen(const std::filesystem::path& path, const std::vector<BagTopic>& all, const std::string& wanted) {
  std::vector<BagTopic> images;
  for (const BagTopic& topic : all)
    if (is_image_type(topic.type)) images.push_back(topic);
  if (!wanted.empty()) {
    for (const BagTopic& topic : all) {
      if (topic.name != wanted && topic.name != "/" + wanted) continue;
      if (is_image_type(topic.type)) return topic;
      throw InputError(path.string() + ": --topic " + wanted + " holds " + topic.type +
                       ", no images; there are: " + names_of(images));
    }
    throw InputError(path.string() + ": --topic " + wanted + " is not there; the bag holds " + names_of(all));
  }
  if (images.size() == 1) return images.front();
  if (images.empty()) throw InputError(path.string() + ": the bag has no images; it holds " + names_of(all));
  throw InputError(path.string() + ": more than one topic with images; choose with --topic: " + names_of(images));
}

/// "/camera/image_raw/compressed" -> "/camera/camera_info"
std::vector<std::string> camera_info_names(const std::string& image_topic) {
  std::vector<std::string> names;
  std::string folder = image_topic;
  for (int up = 0; up < 2 && folder.find('/') != std::string::npos; ++up) {
    folder.erase(folder.rfind('/'));
    names.push_back(folder + "/camera_info");
  }
  return names;
}

class BagSource final : public FrameSource {
 public:
  BagSource(const std::filesystem::path& path, const std::string& topic) : path_(path) {
    open(bag_, path);
    const BagTopic wanted = chosen(path, topics(bag_), topic);
    count_ = wanted.messages;
    view_.addQuery(bag_, rosbag::TopicQuery(wanted.name));
    if (count_ == 0) throw InputError(path.string() + ": " + wanted.name + " has no messages");
    const double length_s = (view_.getEndTime() - view_.getBeginTime()).toSec();
    if (length_s > 0.0 && count_ > 1) rate_hz_ = static_cast<double>(count_ - 1) / length_s;
    at_ = view_.begin();
  }

  std::optional<Frame> next() override {
    if (!fault_.empty() || at_ == view_.end()) return std::nullopt;
    try {
      BagImage image = image_of(*at_);
      ++at_;
      return frame_of(image);
    } catch (const std::exception& e) {
      fault_ = fault_text(path_, e);
      return std::nullopt;
    }
  }

  [[nodiscard]] std::optional<std::int64_t> frame_count() const override { return count_; }
  [[nodiscard]] bool is_sequence() const override { return true; }
  [[nodiscard]] double rate_hz() const override { return rate_hz_; }
  [[nodiscard]] std::string fault() const override { return fault_; }

 private:
  Frame frame_of(BagImage& image) {
    Frame frame;
    frame.source = path_.string();
    frame.index = index_++;
    if (!first_ns_) first_ns_ = image.stamp_ns;
    frame.stamp_s = static_cast<double>(image.stamp_ns - *first_ns_) / 1e9;
    frame.pixels = image.pixels;
    if (!image.fault.empty())
      frame.fault = path_.string() + ": image " + std::to_string(frame.index) + ": " + image.fault;
    return frame;
  }

  std::filesystem::path path_;
  rosbag::Bag bag_;
  rosbag::View view_;
  rosbag::View::iterator at_;
  std::int64_t count_ = 0, index_ = 0;
  double rate_hz_ = 30.0;
  std::optional<std::int64_t> first_ns_;
  std::string fault_;
};

}  // namespace

std::vector<BagTopic> topics_of_bag(const std::filesystem::path& path) {
  return with_bag_faults(path, [&] {
    rosbag::Bag bag;
    open(bag, path);
    return topics(bag);
  });
}

std::unique_ptr<FrameSource> open_bag(const std::filesystem::path& path, const std::string& topic) {
  return with_bag_faults(path,
                         [&]() -> std::unique_ptr<FrameSource> { return std::make_unique<BagSource>(path, topic); });
}

std::optional<CameraModel> camera_of_bag(const std::filesystem::path& path, const std::string& topic) {
  return with_bag_faults(path, [&]() -> std::optional<CameraModel> {
    rosbag::Bag bag;
    open(bag, path);
    const std::string images = chosen(path, topics(bag), topic).name;
    for (const std::string& name : camera_info_names(images)) {
      rosbag::View view(bag, rosbag::TopicQuery(name));
      if (view.size() == 0) continue;
      const auto info = camera_info_of(*view.begin());
      if (!info) continue;
      const node::CameraReading reading = camera_of(*info);
      if (!reading.fault.empty())
        throw InputError(path.string() + ": " + name + ": " + reading.fault + "; or give a calibration with --camera");
      return reading.model;
    }
    return std::nullopt;
  });
}

}  // namespace adit::io
