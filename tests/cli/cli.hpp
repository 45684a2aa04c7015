// The real program as a user calls it, in a folder of its own.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {

namespace fs = std::filesystem;

using support::Outcome;
using support::read_file;
using support::write_file;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

inline const std::string kModel = TREEDYN_SOURCE_DIR "/models/two_link.yaml";

class Cli : public testing::Test {
 protected:
  static Outcome treedyn(std::vector<std::string> arguments, const std::string& input = {}) {
    arguments.insert(arguments.begin(), TREEDYN_EXECUTABLE);
    return support::run(arguments, input);
  }
  std::string out() const { return (folder_.path() / "out").string(); }
  fs::path file(const std::string& name) const { return folder_.path() / "out" / name; }
  std::string scratch(const std::string& name) const { return (folder_.path() / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(out()), fs::directory_iterator()));
  }
  /// A model with one joint and the given lines beside it.
  std::string one_joint(const std::string& mass) const {
    write_file(scratch("one.yaml"),
               "name: one\nlinks:\n  - name: a\n    father: ground\n    joint: {name: j, type: "
               "revolute, axis: [0, 0, 1]}\n    mass: " +
                   mass + "\n");
    return scratch("one.yaml");
  }

 private:
  support::TemporaryFolder folder_;
};

inline void expect_usage_error(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(what));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace treedyn
