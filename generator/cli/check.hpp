// `treedyn check`: are the files in a folder what generate would write?
#pragma once

#include <string>
#include <vector>

#include "emit/unit.hpp"

namespace treedyn {

/// For every file that differs whether it does in constants only or in structure, and in how many
/// lines; missing and surplus files; then unified diffs. Empty if nothing differs. A surplus file
/// is one that bears treedyn's mark and is not among `files`, unless it belongs to a complete set
/// of another model (folders may be shared).
std::string check_files(const std::vector<emit::File>& files, const std::string& folder);

}  // namespace treedyn
