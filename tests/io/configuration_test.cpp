#include "adit/io/configuration.hpp"

#include <gtest/gtest.h>

#include "adit/fields.hpp"
#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::io;
using adit::testing::message_of;
using adit::testing::ScratchFolder;
using adit::testing::write_text;

std::string fault(const std::string& yaml) {
  Configuration configuration;
  return message_of<ConfigError>([&] { read_yaml(yaml, "c.yaml", configuration); });
}

TEST(Configuration, PrintedDefaultsReadBackAsDefaults) {
  const Configuration defaults;
  Configuration read;
  // All fields changed first, so that each has to be read.
  visit_sections(read, [](const char*, auto& section) {
    adit::visit_fields(section, [](const adit::FieldNote& note, auto& member) {
      using Value = std::remove_reference_t<decltype(member)>;
      if constexpr (!std::is_enum_v<Value>) member = static_cast<Value>(note.maximum);
    });
  });
  ASSERT_NE(to_yaml(read), to_yaml(defaults));
  read_yaml(to_yaml(defaults), "defaults", read);
  EXPECT_EQ(to_yaml(read), to_yaml(defaults));
}

TEST(Configuration, EveryFieldIsPrintedWithUnitRangeAndSource) {
  const std::string yaml = to_yaml({});
  EXPECT_NE(yaml.find("finder:\n"), std::string::npos);
  EXPECT_NE(yaml.find("\nheading:\n"), std::string::npos);
  EXPECT_NE(yaml.find("  omega: 0.95\n"), std::string::npos);
  EXPECT_NE(yaml.find("  # [exact | lloyd] Source: "), std::string::npos);
  EXPECT_NE(yaml.find("  # [0.001 to 60 s] Source: "), std::string::npos);
}

TEST(Configuration, FileChangesOnlyWhatItNames) {
  Configuration configuration;
  configuration.finder.cluster_count = 7;
  read_yaml("finder:\n  omega: 0.5\n  clustering: lloyd\nheading:\n  gain_per_s: 2\n", "c", configuration);
  EXPECT_EQ(configuration.finder.omega, 0.5);
  EXPECT_EQ(configuration.finder.clustering, adit::Clustering::kLloyd);
  EXPECT_EQ(configuration.finder.cluster_count, 7);
  EXPECT_EQ(configuration.heading.gain_per_s, 2.0);
  read_yaml("# nothing but a comment\n", "c", configuration);
  read_yaml("finder:\n", "c", configuration);
}

TEST(Configuration, FaultsNameLineFieldValueAndRange) {
  EXPECT_EQ(fault("finder:\n  omga: 0.5\n"), "c.yaml:2: unknown key 'omga'; did you mean 'omega'?");
  EXPECT_EQ(fault("finder:\n\n  omega: 1.5\n"), "c.yaml:3: omega: 1.5 is out of range; it takes 0.01 to 1");
  EXPECT_EQ(fault("finder:\n  omega: bright\n"), "c.yaml:2: omega: 'bright' is not a number; it takes 0.01 to 1");
  EXPECT_EQ(fault("finder:\n  cluster_count: 9.5\n"),
            "c.yaml:2: cluster_count: '9.5' is not a whole number; it takes 2 to 32");
  EXPECT_EQ(fault("finder:\n  clustering: exakt\n"),
            "c.yaml:2: clustering: 'exakt' is none of its values; did you mean 'exact'?");
  const std::string even = fault("finder:\n  omega: 0.9\n  patch_size_px: 14\n");
  EXPECT_TRUE(even.starts_with("c.yaml:3: patch_size_px: 14")) << even;
  EXPECT_EQ(fault("finder:\n  omega: 0.9\n  omega: 0.8\n"), "c.yaml:3: omega: given twice");
  EXPECT_EQ(fault("findr:\n  omega: 0.9\n"), "c.yaml:1: unknown section 'findr'; did you mean 'finder'?");
  EXPECT_EQ(fault("omega: 0.9\n"), "c.yaml:1: unknown section 'omega'; it belongs into the section 'finder:'");
  EXPECT_TRUE(fault("finder:\n  omega: [1, 2]\n").starts_with("c.yaml:2: omega: "));
  EXPECT_TRUE(fault("finder: 3\n").starts_with("c.yaml:1: finder: "));
  EXPECT_TRUE(fault("- 1\n- 2\n").starts_with("c.yaml:1: "));
  EXPECT_TRUE(fault("finder:\n  omega: {\n").starts_with("c.yaml:")) << fault("finder:\n  omega: {\n");
  EXPECT_TRUE(fault("finder:\n  omega: .nan\n").starts_with("c.yaml:2: omega: "));
  EXPECT_TRUE(fault("finder:\n  omega: nan\n").starts_with("c.yaml:2: omega: "));
  EXPECT_TRUE(fault("finder:\n  omega:\n").starts_with("c.yaml:2: omega: "));
  EXPECT_TRUE(fault("finder:\n  lloyd_seed: 99999999999\n").starts_with("c.yaml:2: lloyd_seed: "));
}

TEST(Configuration, MessagesStayOneLine) {
  const std::string why = fault("finder:\n  omega: \"a\\nb" + std::string(500, 'x') + "\"\n");
  EXPECT_EQ(why.find('\n'), std::string::npos);
  EXPECT_LT(why.size(), 200u);
}

TEST(Configuration, MissingAndEmptyFilesAreRefused) {
  const ScratchFolder folder;
  Configuration c;
  const auto why = [&](const std::filesystem::path& path) {
    return message_of<ConfigError>([&] { read_configuration(path, c); });
  };
  EXPECT_EQ(why(folder / "no.yaml"), (folder / "no.yaml").string() + ": no such file");
  EXPECT_EQ(why(write_text(folder / "e.yaml", "")), (folder / "e.yaml").string() + ": the file is empty");
  EXPECT_EQ(why(folder.path()), folder.path().string() + ": is a folder, not a file");
}

TEST(Configuration, SettingsReachEveryField) {
  Configuration c;
  set_field("omega=0.5", c);
  set_field("finder.cluster_count=5", c);
  set_field("heading.gain_per_s=3", c);
  set_field("clustering=lloyd", c);
  EXPECT_EQ(c.finder.omega, 0.5);
  EXPECT_EQ(c.finder.cluster_count, 5);
  EXPECT_EQ(c.heading.gain_per_s, 3.0);
  EXPECT_EQ(c.finder.clustering, adit::Clustering::kLloyd);
  const auto why = [&c](const char* assignment) { return message_of<ConfigError>([&] { set_field(assignment, c); }); };
  EXPECT_EQ(why("omga=1"), "--set omga=1: unknown key 'omga'; did you mean 'omega'?");
  EXPECT_EQ(why("omega"), "--set omega: not of the form key=value");
  EXPECT_EQ(why("omega="), "--set omega=: omega: '' is not a number; it takes 0.01 to 1");
  EXPECT_EQ(why("omega=7"), "--set omega=7: omega: 7 is out of range; it takes 0.01 to 1");
  EXPECT_EQ(why("hedding.omega=1"), "--set hedding.omega=1: unknown section 'hedding'; did you mean 'heading'?");
  EXPECT_NE(why("heading.omega=0.5"), "");
  EXPECT_NE(why("patch_size_px=4"), "");
  EXPECT_EQ(c.finder.omega, 0.5) << "a refused setting changes nothing";
  EXPECT_EQ(c.finder.patch_size_px, 0);
}

}  // namespace
