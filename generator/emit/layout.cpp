#include "emit/layout.hpp"

#include <array>

#include <fmt/format.h>

namespace treedyn::emit {

std::string wrapped(std::string_view text, std::string_view prefix, std::size_t hang) {
  std::string result(prefix);
  std::size_t column = prefix.size();
  bool first_word = true;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (!first_word && column + 1 + word.size() > kColumns) {
      result += fmt::format("\n{}{:{}}", prefix, "", hang);
      column = prefix.size() + hang;
    } else if (!first_word) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    first_word = false;
  }
  return result + "\n";
}

std::string declaration(const std::string& head, const std::vector<std::string>& arguments,
                        const std::string& ending) {
  std::string result = head + "(";
  const std::size_t indentation = result.size();
  std::size_t column = indentation;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const bool last = k + 1 == arguments.size();
    const std::string piece = arguments[k] + (last ? ")" + ending : ",");
    if (k > 0 && column + 1 + piece.size() > kColumns) {
      result += fmt::format("\n{:{}}", "", indentation);
      column = indentation;
    } else if (k > 0) {
      result += ' ';
      ++column;
    }
    result += piece;
    column += piece.size();
  }
  return result;
}

std::vector<std::string> parameters(const program::Signature& signature,
                                    const std::vector<bool>& uses) {
  std::vector<std::string> result;
  const auto add = [&](const program::Array& array, const char* qualifier) {
    const bool used = uses[result.size()];
    if (!array.type.empty()) {
      result.push_back(fmt::format("{}{}& {}{}{}", qualifier, array.type, used ? "" : "/*",
                                   array.name, used ? "" : "*/"));
      return;
    }
    const std::string number = array.number.empty() ? "Scalar" : array.number;
    result.push_back(fmt::format("{}{} {}{}{}[{}]", qualifier, array.integer ? "int" : number,
                                 used ? "" : "/*", array.name, used ? "" : "*/", array.size));
  };
  for (const program::Array& array : signature.inputs) {
    add(array, "const ");
  }
  for (const program::Array& array : signature.outputs) {
    add(array, "");
  }
  return result;
}

std::vector<bool> all_arrays(const program::Signature& signature) {
  return std::vector<bool>(signature.inputs.size() + signature.outputs.size(), true);
}

std::string declaration(const program::Signature& signature, const std::string& ending) {
  return declaration(signature, all_arrays(signature), ending);
}

std::string declaration(const program::Signature& signature, const std::vector<bool>& uses,
                        const std::string& ending) {
  return declaration((signature.status ? "int " : "void ") + signature.name,
                     parameters(signature, uses), ending);
}

std::string call_text(const std::string& head, const std::vector<std::string>& arguments,
                      std::size_t indentation) {
  return declaration(std::string(indentation, ' ') + head, arguments, ";").substr(indentation);
}

std::string table(const std::vector<std::vector<std::string>>& rows, std::string_view prefix) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      width[k] = std::max(width[k], row[k].size());
    }
  }
  std::string result;
  for (const auto& row : rows) {
    result += prefix;
    for (std::size_t k = 0; k < row.size(); ++k) {
      result += fmt::format("  {:{}}", row[k], k + 1 < row.size() ? width[k] : 0);
    }
    result += "\n";
  }
  return result;
}

std::string camel_case(const std::string& name) {
  std::string result;
  bool start = true;
  for (const char c : name) {
    if (c == '_') {
      start = true;
    } else {
      result += start && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
      start = false;
    }
  }
  return result;
}

namespace {

struct CountName {
  int program::Cost::*count;
  const char* name;
};

constexpr std::array<CountName, 6> kCounts = {{{&program::Cost::mul, "mul"},
                                               {&program::Cost::add, "add"},
                                               {&program::Cost::div, "div"},
                                               {&program::Cost::sqrt, "sqrt"},
                                               {&program::Cost::sin, "sin"},
                                               {&program::Cost::cos, "cos"}}};

/// \param text  of a count
template <class Text>
std::string counts_text(const program::Cost& cost, const char* nothing, Text text) {
  std::string result;
  for (const CountName& of : kCounts) {
    if (const int count = cost.*of.count; count != 0) {
      result += fmt::format("{}{} {}", result.empty() ? "" : ", ", text(count), of.name);
    }
  }
  return result.empty() ? nothing : result;
}

}  // namespace

std::string cost_text(const program::Cost& cost) {
  return counts_text(cost, "none", [](int count) { return fmt::format("{}", count); });
}

std::string change_text(const program::Cost& with, const program::Cost& without) {
  program::Cost change;
  for (const CountName& of : kCounts) {
    change.*of.count = with.*of.count - without.*of.count;
  }
  return counts_text(change, "0", [](int count) { return fmt::format("{:+}", count); });
}

void append(Lines& lines, const Lines& more, const std::string& indentation) {
  for (const std::string& line : more) {
    lines.push_back(indentation + line);
  }
}

void append_if(Lines& lines, bool needed, const std::string& line) {
  if (needed) {
    lines.push_back(line);
  }
}

std::string joined(const Lines& lines, const std::string& indentation) {
  std::string result;
  for (const std::string& line : lines) {
    result += result.empty() ? "" : "\n";
    result += indentation + line;
  }
  return result;
}

}  // namespace treedyn::emit
