// Names in generated code: of joints, bodies, and the locals of a function.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/named_constants.hpp"
#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::emit {

/// Longest local: with it, a statement with two operands fits into 100 columns in any case.
inline constexpr std::size_t kLongestLocal = 24;

/// `text` with `_` for every byte that is not harmless inside a comment, and for spaces but single
/// ones between words; at most `longest` characters.
std::string for_comment(std::string_view text, std::size_t longest);

/// An element of an argument: `q[3]`, `p.hand_mass`, `derived.value[3]`.
std::string element_text(const program::Array& array, int element);

/// Identifiers of at most `longest` characters, unique: the given ones without a common "_link"
/// ending, long ones with shortened words ("left_shou_pitc").
std::vector<std::string> shortened(const std::vector<std::string>& identifiers,
                                   std::size_t longest);

/// The name of one link with words so short that names of values have room for it; empty if there
/// are too many words.
std::string short_body(const std::string& identifier);

/// What the text of a model calls its links and independent joints.
struct Vocabulary {
  std::vector<std::string> bodies;         ///< by link, short
  std::vector<std::string> joints;         ///< by coordinate, short
  std::vector<std::string> body_comments;  ///< by link, the name as a comment shows it
  std::shared_ptr<const ConstantNames> constants = nullptr;  ///< null: all numbers are literals
  std::map<std::string, std::string> stems = {};  ///< by function: what its parts are called by
};
Vocabulary vocabulary(const model::Tree& tree);

/// The words that names of links of several limbs have in common ("thigh" of left_thigh and
/// right_thigh); empty if there are none.
std::string common_words(const std::vector<std::string>& names);

/// The names of a function's values: `omega_forearm_x` where the graph has a hint
/// (`neg_omega_forearm_x` where it has one of the opposite), `s_elbow` for
/// the sine of a joint angle, `q_hip_knee` and `s_hip_knee` for that of a sum; what is computed for
/// one of these or for one output only is called after it, `omega_forearm_x_1` and `tau_3_1`;
/// otherwise `t_forearm_1`. Numbers count in each body or name.
class LocalNames {
 public:
  /// \param operations all operations of the function in order
  LocalNames(const program::Function& function, const Vocabulary& words,
             const std::vector<program::Ref>& operations);

  /// The next temporary's name for a value without a hint; keeps names that exist.
  void assign(program::Ref value);
  /// \pre the value has a hint or `assign` was called.
  [[nodiscard]] const std::string& at(program::Ref value) const {
    return names_[program::node_index(value)];
  }
  /// Upper bound of the length of the name, also before `assign`.
  [[nodiscard]] int width(program::Ref value) const;

 private:
  [[nodiscard]] std::string hinted(program::Ref value) const;
  [[nodiscard]] bool is_of_time(program::Ref value) const;
  [[nodiscard]] std::string trigonometric(program::Ref value) const;
  /// "joint2_joint3" of q[1] + q[2], "q1_q2" if that is too long; empty for what is no sum of q.
  [[nodiscard]] std::string angle(program::Ref value) const;
  [[nodiscard]] std::string body_stem(program::Ref value) const;
  [[nodiscard]] std::string element_stem(std::size_t output) const;
  void name_angles(const std::vector<program::Ref>& operations);
  void name_outputs();
  void find_stems(const std::vector<program::Ref>& operations);
  void claim(program::Ref value, const std::string& name);

  const program::Function& function_;
  const Vocabulary& words_;
  std::vector<std::string> names_;
  std::vector<std::string> stems_;          // by node: of a name with a number
  std::map<std::string, int> last_number_;  // by stem
  std::set<std::string> taken_;
};

}  // namespace treedyn::emit
