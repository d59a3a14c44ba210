// Help that fits one screen: a narrow left column, no ranges in it.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <utility>

namespace adit::tools {

class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat() { column_width(24); }

  /// Inputs are known by what they are, INPUT...
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    return is_positional ? kind_of(option) : Formatter::make_option_name(option, false);
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_size() == 0 || option->get_positional() ? "" : " " + kind_of(option);
  }
  std::string make_option_usage(const CLI::Option* option) const override { return kind_of(option); }

  /// A group that is hidden and last would leave a second blank line.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string text = Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at = 0; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
    return text;
  }

 private:
  /// CLI11 puts the range behind a colon.
  static std::string kind_of(const CLI::Option* option) {
    const std::string kind = option->get_type_name();
    return kind.substr(0, kind.find(':'));
  }
};

}  // namespace adit::tools
