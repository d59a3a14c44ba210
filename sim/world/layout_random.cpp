#include "layout.hpp"
namespace adit::sim {
Layout lay_out_random(const CourseConfig&) { return {}; }

}  // namespace adit::sim
