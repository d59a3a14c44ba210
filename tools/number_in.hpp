// The check of every option that is a number.
#pragma once

#include <CLI/Validators.hpp>
#include <cmath>
#include <string>

namespace adit::tools {

/// Finite and in a range. CLI::Range lets "nan" through, since NaN is neither below nor above.
template <class Number>
class NumberIn : public CLI::Validator {
 public:
  NumberIn(Number least, Number most) : CLI::Validator("") {
    func_ = [least, most](std::string& text) {
      Number value{};
      const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(static_cast<double>(value));
      if (is_number && value >= least && value <= most) return std::string();
      return "'" + text + "' is not a number from " + CLI::detail::to_string(least) + " to " +
             CLI::detail::to_string(most);
    };
  }
};

/// A coordinate or an angle: any number that is one.
inline const CLI::Validator& finite_number() {
  static const NumberIn<double> any(-1e9, 1e9);
  return any;
}

}  // namespace adit::tools
