// `treedyn check`: are the files in a folder what generate would write?
#pragma once

#include <string>
#include <vector>

#include "emit/unit.hpp"

namespace treedyn {

/// Unified diffs, missing and surplus files; empty if nothing differs. A surplus file is one that
/// bears treedyn's mark and is not among `files`, unless it belongs to a complete set of another
/// model (folders may be shared).
std::string check_files(const std::vector<emit::File>& files, const std::string& folder);

}  // namespace treedyn
