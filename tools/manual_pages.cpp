#include "manual_pages.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "adit/io/output_file.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}

/// As roff wants text: hyphens that are typed, no line that begins like a request.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out.append("\\&").append(1, c);
    } else {
      out += c;
    }
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// CLI11 puts the range behind a colon.
std::string kind_of(const CLI::Option& option) {
  const std::string kind = option.get_type_name();
  return kind.substr(0, kind.find(':'));
}

std::string page_head(const std::string& name, const std::string& about) {
  return joined({".TH ", upper(name), " 1 \"\" \"adit " ADIT_VERSION "\" \"User Commands\"\n.SH NAME\n", roff(name),
                 " \\- ", roff(about), "\n"});
}

std::string option_entry(const CLI::Option& option) {
  std::string entry = ".TP\n";
  if (option.get_positional()) {
    entry += joined({"\\fI", roff(kind_of(option)), "\\fR"});
  } else {
    std::string names = option.get_name(false, true);
    for (std::size_t at = 0; (at = names.find(',', at)) != std::string::npos; at += 2) names.insert(at + 1, 1, ' ');
    entry += joined({"\\fB", roff(names), "\\fR"});
    if (option.get_expected_max() != 0) entry += joined({" \\fI", roff(kind_of(option)), "\\fR"});
  }
  return joined({entry, "\n", roff(option.get_description()), ".\n"});
}

std::string options_part(const CLI::App& app) {
  std::string inputs, options;
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? inputs : options) += option_entry(*option);
  return joined({inputs.empty() ? "" : ".SH ARGUMENTS\n", inputs, ".SH OPTIONS\n", options});
}

std::string example_part(const CLI::App& app) {
  std::string example = app.get_footer();
  const std::string_view word = "Example: ";
  if (example.starts_with(word)) example.erase(0, word.size());
  return example.empty() ? "" : joined({".SH EXAMPLE\n.EX\n", roff(example), "\n.EE\n"});
}

std::string subcommand_page(const CLI::App& app) {
  std::string synopsis = joined({".SH SYNOPSIS\n\\fBadit ", roff(app.get_name()), "\\fR [\\fIOPTIONS\\fR]"});
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) synopsis += joined({" \\fI", roff(kind_of(*option)), "\\fR"});
  return joined({page_head(joined({"adit-", app.get_name()}), app.get_description()), synopsis, "\n", options_part(app),
                 example_part(app), ".SH SEE ALSO\n.BR adit (1)\n"});
}

std::string main_page(const CLI::App& app, const std::vector<const CLI::App*>& subcommands) {
  std::string about = app.get_description();
  if (!about.empty() && about.back() == '.') about.pop_back();
  std::string page = page_head("adit", about);
  page += ".SH SYNOPSIS\n\\fBadit\\fR \\fISUBCOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH SUBCOMMANDS\n";
  for (const CLI::App* subcommand : subcommands)
    page += joined({".TP\n.BR adit\\-", subcommand->get_name(), " (1)\n", roff(subcommand->get_description()), ".\n"});
  return joined(
      {page, options_part(app), example_part(app),
       ".SH EXIT STATUS\n"
       "0 the work is done; 1 a fault of the program; 2 wrong usage; 3 a wrong configuration; 4 an input that\n"
       "is missing or cannot be read; 5 some frames could not be read; 6 an output could not be written; 130\n"
       "interrupted, and what was written is whole.\n"
       ".SH ENVIRONMENT\n.TP\n.B ADIT_TARGET\nThe instruction set to use, by name; see \\fBadit bench\\fR.\n"});
}

/// "--csv --video", what may be typed.
std::string words_of(const CLI::App& app) {
  std::string words;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) words += joined({words.empty() ? "--" : " --", name});
  return words;
}

std::string completion(const CLI::App& app, const std::vector<const CLI::App*>& subcommands) {
  std::string names, cases;
  for (const CLI::App* subcommand : subcommands) {
    names += joined({names.empty() ? "" : " ", subcommand->get_name()});
    cases += joined({"    ", subcommand->get_name(), ") words='", words_of(*subcommand), "' ;;\n"});
  }
  return joined(
      {"# bash completion of adit; made by the program itself.\n"
       "_adit() {\n"
       "  local current=${COMP_WORDS[COMP_CWORD]} words=''\n"
       "  case ${COMP_WORDS[1]-} in\n",
       cases, "    *) if [ \"$COMP_CWORD\" = 1 ]; then words='", names, " ", words_of(app),
       "'; fi ;;\n"
       "  esac\n"
       "  # Files are completed by bash itself where no word fits.\n"
       "  if [[ $current == -* || $COMP_CWORD == 1 ]]; then\n"
       "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
       "  fi\n"
       "}\n"
       "complete -o default -F _adit adit\n"});
}

}  // namespace

void write_manual(const CLI::App& app, const std::filesystem::path& folder) {
  const std::vector<const CLI::App*> subcommands = app.get_subcommands(nullptr);
  io::write_file(folder / "adit.1", main_page(app, subcommands));
  for (const CLI::App* subcommand : subcommands)
    io::write_file(folder / joined({"adit-", subcommand->get_name(), ".1"}), subcommand_page(*subcommand));
  io::write_file(folder / "adit.bash", completion(app, subcommands));
}

}  // namespace adit::tools
