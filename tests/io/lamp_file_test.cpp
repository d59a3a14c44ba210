// Patterns of lamps as files.
#include "adit/io/lamp_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace adit::io {
namespace {

std::string fault_in(const std::string& text) {
  try {
    (void)lamp_of_yaml(text, "lamp.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LampFile, WhatIsWrittenIsReadAgain) {
  LampPattern pattern;
  pattern.lobe = {-1.25, 0.1, -0.2, -0.3333333333333333, 0.0, -1e-7};
  pattern.frames = 1234.0;
  const LampPattern again = lamp_of_yaml(to_yaml(pattern), "lamp.yaml");
  EXPECT_EQ(again.lobe, pattern.lobe);
  EXPECT_EQ(again.frames, pattern.frames);
}

TEST(LampFile, FaultsNameFileLineAndField) {
  EXPECT_EQ(fault_in("frames: 3\n"), "lamp.yaml: lobe: missing; a file that 'adit run --learn-lamp' wrote is wanted");
  EXPECT_EQ(fault_in("lobe: [0, 0, 0, 0, 0, 0]\n"),
            "lamp.yaml: frames: missing; a file that 'adit run --learn-lamp' wrote is wanted");
  EXPECT_EQ(fault_in("frames: 3\nlobe: [0, 0]\n"), "lamp.yaml:2: lobe: not a list of six numbers");
  EXPECT_EQ(fault_in("frames: many\n"), "lamp.yaml:1: frames: 'many' is not a number");
  EXPECT_NE(fault_in("lobes: 3\n").find("did you mean 'lobe'?"), std::string::npos) << fault_in("lobes: 3\n");
  EXPECT_NE(fault_in("frames: 3\nlobe: [0, 0, 0, 2, 0, 0]\n").find("a beam has no valley"), std::string::npos);
  EXPECT_NE(fault_in("frames: -3\nlobe: [0, 0, 0, 0, 0, 0]\n").find("frames"), std::string::npos);
}

}  // namespace
}  // namespace adit::io
