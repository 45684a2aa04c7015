#include "emit/c99.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/identifier.hpp"
#include "emit/definitions.hpp"
#include "emit/layout.hpp"
#include "emit/references.hpp"
#include "emit/run_time.hpp"
#include "emit/self_test.hpp"

namespace treedyn::emit {

namespace {

std::string in_capitals(std::string_view word) {
  std::string result;
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    result += std::isupper(byte) != 0 && !result.empty() ? "_" : "";
    result += static_cast<char>(std::toupper(byte));
  }
  return result;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Names may begin with the word.
std::string without_noexcept(std::string text) {
  return replaced(replaced(std::move(text), " noexcept;", ";"), " noexcept {", " {");
}

/// The rest of a line behind `start`; empty if it starts otherwise.
std::string_view behind(std::string_view line, std::string_view start) {
  return line.starts_with(start) ? line.substr(start.size()) : std::string_view{};
}

class Translator {
 public:
  explicit Translator(const Unit& unit);
  [[nodiscard]] std::string header(const std::string& text);
  [[nodiscard]] std::string source(const std::string& text);

 private:
  [[nodiscard]] std::string prefixed(std::string_view name) const {
    return fmt::format("{}_{}", unit_.prefix(), name);
  }
  [[nodiscard]] std::string macro(std::string_view constant) const {
    return in_capitals(unit_.prefix()) + "_" + in_capitals(constant.substr(1));
  }
  [[nodiscard]] std::string words(const std::string& line) const;
  [[nodiscard]] std::string word(const std::string& word, bool called) const;
  void rename_own(const std::string& text);
  [[nodiscard]] std::string with_tables(std::string line) const;
  bool header_frame(const std::string& line, Lines& result) const;
  void header_line(const Lines& lines, std::size_t& at, Lines& result, bool& in_list);
  void constant(const std::string& line, bool in_list, Lines& result) const;
  std::set<std::string> function(const std::string& line, bool is_local, bool is_noinline,
                                 Lines& result);
  void statement(const Lines& lines, std::size_t& at, Lines& result) const;
  void own_structure(const Lines& lines, std::size_t at, Lines& result);
  bool frame(const std::string& line, bool& is_local, Lines& result) const;
  void structure(const Lines& lines, std::size_t& at, Lines& result) const;

  const Unit& unit_;
  std::set<std::string> functions_;             ///< with external linkage
  std::set<std::string> exported_;              ///< all that the header names, with the prefix
  std::map<std::string, std::string> renamed_;  ///< what the source alone has and is called so
  std::map<std::string, std::string> zeros_;    ///< of the source's structs, member by member
  ReferencePlaces by_reference_;
};

Translator::Translator(const Unit& unit) : unit_(unit) {
  const auto add = [&](const auto& all) {
    for (const auto& one : all) {
      functions_.insert(one.signature.name);
    }
  };
  if (unit.self_test) {
    functions_.insert(kSelfTest);
  }
  add(unit.functions);
  add(unit.checked);
  add(unit.staged);
  add(unit.steppers);
  for (const std::string& function : functions_) {
    exported_.insert(prefixed(function));
  }
  for (const char* const type : {"Scalar", kParameters, kDerivedParameters}) {
    exported_.insert(prefixed(type));
  }
}

/// The words of a text, those of comments too.
std::set<std::string> all_words(const std::string& text) {
  std::set<std::string> result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t begin = at;
    while (at < text.size() && is_word_byte(text[at])) {
      ++at;
    }
    result.insert(text.substr(begin, at - begin));
  }
  return result;
}

/// Constants, tables, helpers and variables give way to names of the header: they get a `_` more.
void Translator::rename_own(const std::string& text) {
  std::set<std::string> taken = all_words(text);
  for (const std::string& name : exported_) {
    if (!taken.contains(name)) {
      continue;
    }
    std::string other = name;
    do {
      other += '_';
    } while (exported_.contains(other) || !taken.insert(other).second);
    renamed_.emplace(name, other);
  }
}

/// One word of code.
std::string Translator::word(const std::string& word, bool called) const {
  static const std::set<std::string> kConstants = {"kPoints"};
  static const std::set<std::string> kOfLibrary = {"sqrt", "pow", "sin", "cos"};
  if (called && functions_.contains(word)) {
    return prefixed(word);
  }
  if (const auto own = renamed_.find(word); own != renamed_.end()) {
    return own->second;
  }
  if (kConstants.contains(word)) {
    return macro(word);
  }
  if (!called || !kOfLibrary.contains(word)) {
    return word;
  }
  if (!unit_.target.takes_libm() && (word == "sin" || word == "cos")) {
    return word == "sin" ? "sine" : "cosine";
  }
  return word + (unit_.target.scalar == Scalar::kFloat ? "f" : "");
}

/// A line with its words, but for its comment.
std::string Translator::words(const std::string& line) const {
  std::string code = line.substr(0, line.find("//"));
  const std::string comment = line.substr(code.size());
  for (const char* const list : {"status", "phase", "joint", "point"}) {
    code = replaced(code, fmt::format("{}::", list), prefixed(list) + "_");
  }
  for (const char* const number : {"0", "1", "-1"}) {
    code = replaced(code, fmt::format("Scalar({})", number), fmt::format("(Scalar){}", number));
  }
  code = replaced(replaced(code, " Scalar(", " (Scalar)("), "(Scalar(", "((Scalar)(");
  const std::size_t type = std::min(code.find_first_not_of(' '), code.size());
  const auto zero = zeros_.find(code.substr(type, code.find(' ', type) - type));
  code = replaced(code, "= {};", fmt::format("= {};", zero == zeros_.end() ? "{0}" : zero->second));
  std::string result;
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = at;
    while (end < code.size() && is_word_byte(code[end])) {
      ++end;
    }
    const std::string one = code.substr(at, end - at);
    const bool is_member = result.ends_with('.');
    result += end == at   ? std::string(1, code[at])
              : is_member ? one
                          : word(one, end < code.size() && code[end] == '(');
    at = std::max(end, at + 1);
  }
  return result + comment;
}

/// A constant of the header: an enumerator, which may be the length of an array; of a list of
/// names `  prefix_joint_elbow = 1,`.
void Translator::constant(const std::string& line, bool in_list, Lines& result) const {
  const std::size_t equals = line.find(" = ");
  const std::string name = line.substr(0, equals);
  const std::string value = line.substr(equals + 3, line.size() - equals - 4);
  if (in_list) {
    result.push_back(fmt::format("  {} = {},", name, value));
  } else {
    result.push_back(fmt::format("enum {{ {} = {} }};", macro(name), value));
  }
}

/// A struct of the header.
void Translator::structure(const Lines& lines, std::size_t& at, Lines& result) const {
  const std::string_view name = behind(lines[at], "struct ");
  result.emplace_back("typedef struct {");
  for (++at; lines[at] != "};"; ++at) {
    result.push_back(replaced(lines[at], "  Scalar ", "  " + prefixed("Scalar ")));
  }
  result.push_back(fmt::format("}} {};", prefixed(name.substr(0, name.find(' ')))));
}

/// What stands around the header: its guard, extern "C". True if the line is of it.
bool Translator::header_frame(const std::string& line, Lines& result) const {
  if (line == "#pragma once") {
    const std::string guard = in_capitals(unit_.name) + "_H";
    result.insert(result.end(), {"#ifndef " + guard, "#define " + guard});
  } else if (line == fmt::format("namespace {} {{", unit_.space())) {
    result.insert(result.end(), {"#ifdef __cplusplus", "extern \"C\" {", "#endif"});
  } else if (line == "}  // namespace " + unit_.space()) {
    result.insert(result.end(), {"#ifdef __cplusplus", "}", "#endif", "", "#endif"});
  } else {
    return false;
  }
  return true;
}

/// A comment with the tables of packed matrices as C calls them.
std::string Translator::with_tables(std::string line) const {
  for (const PackedMatrix& matrix : unit_.packed) {
    for (const char* const table : {"Row", "Column"}) {
      const std::string name = fmt::format("{}{}", matrix.constants, table);
      line = replaced(std::move(line), fmt::format("{}[", name), fmt::format("{}[", macro(name)));
    }
  }
  return line;
}

void Translator::header_line(const Lines& lines, std::size_t& at, Lines& result, bool& in_list) {
  static const std::string kInteger = "constexpr int ";
  const std::string step_start =
      fmt::format("constexpr {} kStep = ", type_name(unit_.target.scalar));
  const std::string& line = lines[at];
  if (header_frame(line, result)) {
    return;
  }
  if (line.starts_with("namespace ")) {
    in_list = true;
    result.emplace_back("enum {");
  } else if (line.starts_with("}  // namespace ")) {
    in_list = false;
    result.emplace_back("};");
  } else if (const auto type = behind(line, "using Scalar = "); !type.empty()) {
    result.push_back(
        fmt::format("typedef {} {};", type.substr(0, type.size() - 1), prefixed("Scalar")));
  } else if (const auto digest = behind(line, "constexpr unsigned long long kDigest = ");
             !digest.empty()) {
    result.push_back(
        fmt::format("#define {} {}", macro("kDigest"), digest.substr(0, digest.size() - 1)));
  } else if (const auto step = behind(line, step_start); !step.empty()) {
    result.push_back(fmt::format("#define {} {}", macro("kStep"), step.substr(0, step.size() - 1)));
  } else if (line.starts_with(kInteger.substr(0, kInteger.size() - 1)) && line.ends_with('{')) {
    const std::string table = line.substr(kInteger.size());
    const std::size_t name = table.find('[');
    result.push_back(
        fmt::format("static const int {}{}", macro(table.substr(0, name)), table.substr(name)));
  } else if (line.starts_with(kInteger.substr(0, kInteger.size() - 1))) {
    constant(gathered(lines, at, ';').substr(kInteger.size()), in_list, result);
  } else if (line.starts_with("struct ")) {
    structure(lines, at, result);
  } else if (const auto nominal = behind(line, fmt::format("constexpr {} ", kParameters));
             !nominal.empty()) {
    result.push_back(
        fmt::format("static const {} {} = {{", prefixed(kParameters), macro(kNominal)));
  } else if (line.starts_with("void ") || line.starts_with("int ")) {
    function(gathered(lines, at, ';'), false, false, result);
  } else {
    result.push_back(in_list && line.starts_with("///") ? "  " + line : with_tables(line));
  }
}

std::string Translator::header(const std::string& text) {
  const Lines lines = lines_of(without_noexcept(text));
  Lines result;
  bool in_list = false;
  std::string list;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (const auto name = behind(lines[at], "namespace "); !name.empty()) {
      list = std::string(name.substr(0, name.find(' ')));
    }
    const std::size_t before = result.size();
    header_line(lines, at, result, in_list);
    if (in_list && result.size() > before && result.back().ends_with(',')) {
      result.back() = "  " + prefixed(list) + "_" + result.back().substr(2);
      exported_.insert(result.back().substr(2, result.back().find(" = ") - 2));
    }
  }
  return replaced(fmt::format("{}\n", fmt::join(result, "\n")), unit_.name + ".hpp",
                  unit_.name + ".h");
}

/// `const Scalar /*q*/[6]` -> `const Scalar q[6]`. \return the name of what may not be used
std::string give_name(std::string& argument) {
  const std::size_t begin = argument.find("/*");
  const std::size_t end = argument.find("*/");
  if (begin == std::string::npos) {
    return {};
  }
  std::string name = argument.substr(begin + 2, end - begin - 2);
  argument.replace(begin, end + 2 - begin, name);
  return name;
}

/// A definition's first lines, or a prototype: arguments without a name get theirs, and a
/// statement that says that they are not used.
std::set<std::string> Translator::function(const std::string& line, bool is_local, bool is_noinline,
                                           Lines& result) {
  Declaration parts = declaration_of(line);
  const std::size_t name = parts.head.rfind(' ') + 1;
  const std::string word = parts.head.substr(name);
  const bool is_prototype = parts.ending.ends_with(';');
  if (is_local && functions_.contains(word)) {
    throw InputError({}, fmt::format("function '{}' has a name that the C text itself needs; "
                                     "expected another one, or --language c++",
                                     word));
  }
  Lines unused;
  std::set<std::string> references;
  for (std::string& argument : parts.arguments) {
    const std::string given = give_name(argument);
    if (!given.empty()) {
      unused.push_back(fmt::format("  (void){};", this->word(given, false)));
    }
    const std::size_t reference = argument.find("& ");
    if (reference != std::string::npos) {
      references.insert(this->word(argument.substr(reference + 2), false));
      by_reference_[this->word(word, true)].insert(&argument - parts.arguments.data());
      argument.replace(reference, 1, "*");
    }
    for (const std::string& type : {std::string("Scalar "), fmt::format("{}* ", kParameters),
                                    fmt::format("{}* ", kDerivedParameters)}) {
      const std::size_t place = argument.find(type);
      if (is_prototype && place != std::string::npos &&
          (place == 0 || argument[place - 1] == ' ')) {
        argument.insert(place, prefixed(""));
      }
    }
  }
  const bool is_prefixed = functions_.contains(word);
  const std::string head =
      fmt::format("{}{}{}{}", is_local ? "static " : "", is_noinline ? "NOINLINE " : "",
                  parts.head.substr(0, name), is_prefixed ? prefixed(word) : word);
  std::size_t done = is_prefixed ? head.size() : 0;  // another function may have that name
  for (const std::string& part : lines_of(declaration(head, parts.arguments, parts.ending))) {
    result.push_back(is_prototype ? part : part.substr(0, done) + words(part.substr(done)));
    done = 0;
  }
  append(result, unused);
  return references;
}

/// A statement that C writes otherwise, else its words.
void Translator::statement(const Lines& lines, std::size_t& at, Lines& result) const {
  const std::string& line = lines[at];
  const std::size_t indentation = std::min(line.find_first_not_of(' '), line.size());
  const std::string_view code = std::string_view(line).substr(indentation);
  const std::string blank(indentation, ' ');
  if (const auto both = behind(code, "const auto "); !both.empty()) {
    result.push_back(words(fmt::format("{}const SineCosine {}", blank, both)));
  } else if (const auto member = behind(code, "const Scalar& "); !member.empty()) {
    result.push_back(words(fmt::format("{}const Scalar {}", blank, member)));
  } else if (const auto unused = behind(code, "static_cast<void>"); !unused.empty()) {
    result.push_back(words(fmt::format("{}(void){}", blank, unused)));
  } else if (const auto integer = behind(code, "constexpr int "); !integer.empty()) {
    result.push_back(
        words(fmt::format("{}enum {{ {} }};", blank, integer.substr(0, integer.size() - 1))));
  } else if (const auto value = behind(code, "constexpr "); !value.empty()) {
    result.push_back(
        words(fmt::format("{}{}const {}", blank, indentation == 0 ? "static " : "", value)));
  } else if (const auto table = behind(code, "static constexpr "); !table.empty()) {
    result.push_back(words(fmt::format("{}static const {}", blank, table)));
  } else if (const auto values = behind(code, "return {"); !values.empty()) {
    result.push_back(words(fmt::format("{}const SineCosine pair = {{{}", blank, values)));
    result.push_back(words(fmt::format("{}return pair;", blank)));
  } else if (const auto single = behind(code, "inline "); !single.empty()) {
    result.push_back(words(fmt::format("{}static {}", blank, single)));
  } else {
    result.push_back(words(line));
  }
}

/// A struct of the source, which is called as in C++; C++ reads a zero of it without a warning if
/// every member has one.
void Translator::own_structure(const Lines& lines, std::size_t at, Lines& result) {
  const std::string_view behind_struct = behind(lines[at], "struct ");
  const std::string name(behind_struct.substr(0, behind_struct.find(' ')));
  result.push_back(fmt::format("typedef struct {0} {0};", name));
  Lines members;
  for (++at; lines[at] != "};"; ++at) {
    const std::string member = lines[at].substr(0, lines[at].find("//"));
    members.emplace_back(member.find('[') == std::string::npos ? "0" : "{0}");
  }
  zeros_[name] = fmt::format("{{{}}}", fmt::join(members, ", "));
}

/// What stands around the functions: namespaces, includes, the digest. True if the line is of it.
bool Translator::frame(const std::string& line, bool& is_local, Lines& result) const {
  if (line == "namespace {" || line == "}  // namespace") {
    is_local = line.front() == 'n';
  } else if (line == fmt::format("namespace {} {{", unit_.space())) {
    result.push_back(fmt::format("typedef {} Scalar;", prefixed("Scalar")));
    for (const char* const type : {kParameters, kDerivedParameters}) {
      if (!unit_.tree->parameters.empty()) {
        result.push_back(fmt::format("typedef {} {};", prefixed(type), type));
      }
    }
  } else if (const auto digest = behind(line, "static_assert(kDigest == "); !digest.empty()) {
    const std::size_t comma = digest.find(", ");
    result.push_back(fmt::format("#if {} != {}", macro("kDigest"), digest.substr(0, comma)));
    result.push_back(fmt::format("#error {}", digest.substr(comma + 2, digest.size() - comma - 4)));
    result.emplace_back("#endif");
  } else if (line.starts_with("static_assert(sizeof(1.0)")) {  // C99 has none
    result.emplace_back("// Not for -fsingle-precision-constant, which makes literals float.");
    result.emplace_back(
        "typedef char literals_are_double[sizeof(1.0) == sizeof(double) ? 1 : -1];");
  } else if (line == fmt::format("#include \"{}.hpp\"", unit_.name)) {
    result.push_back(fmt::format("#include \"{}.h\"", unit_.name));
  } else if (line == "#include <cmath>") {
    result.emplace_back("#include <math.h>");
  } else {
    return line.starts_with("using std::") || line == "}  // namespace " + unit_.space();
  }
  return true;
}

/// What C has no word for: one struct for two, no template of a function.
std::string in_plain_words(std::string text, const std::string& type) {
  text = without_noexcept(std::move(text));
  text = replaced(
      text, "template <class Number>\nstruct SineCosine {\n  Number sine;\n  Number cosine;\n};\n",
      fmt::format("typedef struct {{\n  {0} sine;\n  {0} cosine;\n}} SineCosine;\n", type));
  text = replaced(text, fmt::format("SineCosine<{}>", type), "SineCosine");
  const std::size_t other = text.find("/// For other types that stand for Scalar");
  if (other != std::string::npos) {
    text.erase(other, text.find("\n\n", other) + 2 - other);
  }
  return text;
}

/// What the words of the text need in front of it.
std::string with_beginning(std::string text, const std::string& scalar, const std::string& dof) {
  const std::string type = fmt::format("typedef {} Scalar;\n", scalar);
  const std::size_t begin = text.find(type);
  if (text.find("kDof") != std::string::npos) {
    text.insert(begin + type.size(), fmt::format("enum {{ kDof = {} }};\n", dof));
  }
  if (text.find("NOINLINE ") != std::string::npos) {
    text.insert(begin,
                "#if defined(__GNUC__)\n#define NOINLINE __attribute__((noinline))\n"
                "#else\n#define NOINLINE\n#endif\n\n");
  }
  if (text.find("bool ") != std::string::npos) {
    const std::size_t include = text.find("\n\n", text.find("#include ")) + 1;
    text.insert(include, "#include <stdbool.h>\n");
  }
  return text;
}

std::string Translator::source(const std::string& text) {
  const std::string type = type_name(unit_.target.scalar);
  rename_own(text);
  Lines lines = lines_of(in_plain_words(text, type));
  Lines result;
  bool is_local = false;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    const std::string_view noinline_function = behind(lines[at], "[[gnu::noinline");
    const bool is_noinline = !noinline_function.empty();
    const std::string line =
        is_noinline ? std::string(noinline_function.substr(noinline_function.find("]] ") + 3))
                    : lines[at];
    if (frame(line, is_local, result)) {
      continue;
    }
    if (line.starts_with("struct ")) {
      own_structure(lines, at, result);
    }
    if (begins_function(line)) {
      lines[at] = line;
      const std::string whole = gathered(lines, at, '{');
      const std::set<std::string> references = function(whole, is_local, is_noinline, result);
      Lines body;
      for (++at; lines[at] != "}"; ++at) {
        statement(lines, at, body);
      }
      const std::string code =
          with_addresses(fmt::format("{}\n", fmt::join(body, "\n")), by_reference_);
      append(result, lines_of(references.empty() ? code : with_pointers(code, references)));
      result.emplace_back("}");
    } else if (!line.empty() || !result.back().empty()) {  // frames leave no second blank line
      statement(lines, at, result);
    }
  }
  result.front() = fmt::format("// {0}.c: see {0}.h", unit_.name);
  return with_beginning(fmt::format("{}\n", fmt::join(result, "\n")), prefixed("Scalar"),
                        macro("kDof"));
}

}  // namespace

std::pair<std::string, std::string> in_c99(const Unit& unit, const std::string& header,
                                           const std::string& source) {
  Translator translator(unit);
  return {translator.header(header), translator.source(source)};
}

}  // namespace treedyn::emit
