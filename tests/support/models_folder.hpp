// Where the committed models are. For programs of treedyn_test.
#pragma once

#include <string>

namespace treedyn {

inline const std::string kModels = TREEDYN_SOURCE_DIR "/models/";

}  // namespace treedyn
