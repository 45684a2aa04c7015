#include "cli/study_parts.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "emit/sha256.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

using accuracy::Outcome;
using accuracy::Reference;

/// Words, one behind the other.
class Writer {
 public:
  void operator()(const std::string& text) { out_ << std::quoted(text) << '\n'; }
  void operator()(long number) { out_ << number << '\n'; }
  void operator()(int number) { (*this)(static_cast<long>(number)); }
  void operator()(long double number) {
    char text[64];
    std::snprintf(text, sizeof(text), "%La", number);
    out_ << text << '\n';
  }
  void operator()(double number) { (*this)(static_cast<long double>(number)); }
  /// The number of elements.
  template <class Container>
  void size(const Container& all) {
    (*this)(static_cast<long>(all.size()));
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

/// The same words, read back. \throws std::runtime_error where one is missing
class Reader {
 public:
  explicit Reader(const std::string& text) : in_(text) {}

  void operator()(std::string& text) { in_ >> std::quoted(text); }
  void operator()(long& number) { number = std::strtol(word().c_str(), nullptr, 10); }
  void operator()(int& number) {
    long read = 0;
    (*this)(read);
    number = static_cast<int>(read);
  }
  void operator()(long double& number) { number = std::strtold(word().c_str(), nullptr); }
  void operator()(double& number) {
    long double read = 0;
    (*this)(read);
    number = static_cast<double>(read);
  }
  long size() {
    long number = 0;
    (*this)(number);
    return number;
  }

 private:
  std::string word() {
    std::string result;
    if (!(in_ >> result)) {
      throw std::runtime_error("ends early");
    }
    return result;
  }

  std::istringstream in_;
};

template <class Value>
void exchange(Writer& words, const std::vector<Value>& all) {
  words.size(all);
  for (const Value& value : all) {
    exchange(words, value);
  }
}
template <class Value>
void exchange(Reader& words, std::vector<Value>& all) {
  all.resize(static_cast<std::size_t>(words.size()));
  for (Value& value : all) {
    exchange(words, value);
  }
}

void exchange(Writer& words, long value) { words(value); }
void exchange(Reader& words, long& value) { words(value); }
void exchange(Writer& words, double value) { words(value); }
void exchange(Reader& words, double& value) { words(value); }
void exchange(Writer& words, long double value) { words(value); }
void exchange(Reader& words, long double& value) { words(value); }

template <class Value>
void exchange(Writer& words, const std::map<accuracy::Error, Value>& all) {
  words.size(all);
  for (const auto& [error, value] : all) {
    words(static_cast<int>(error));
    exchange(words, value);
  }
}
template <class Value>
void exchange(Reader& words, std::map<accuracy::Error, Value>& all) {
  for (long left = words.size(); left > 0; --left) {
    int error = 0;
    words(error);
    exchange(words, all[static_cast<accuracy::Error>(error)]);
  }
}

/// In one order for both directions; `Event`, `Known`, `Result` are const where they are written.
template <class Words, class Event>
void event(Words& words, Event& event) {
  words(event.number);
  words(event.at);
}
void exchange(Writer& words, const SteppedEvent& one) { event(words, one); }
void exchange(Reader& words, SteppedEvent& one) { event(words, one); }

template <class Words, class One>
void motion(Words& words, One& one) {
  exchange(words, one.q);
  exchange(words, one.qd);
  words(one.status);
  exchange(words, one.events);
  words(one.off.length);
  words(one.off.angle);
  words(one.off.speed);
  words(one.off.rate);
}
void exchange(Writer& words, const Motion& one) { motion(words, one); }
void exchange(Reader& words, Motion& one) { motion(words, one); }

template <class Words, class Known>
void known(Words& words, Known& all) {
  words(all.reference.methods);
  words(all.reference.agreement);
  exchange(words, all.reference.differences);
  words(all.reference.check);
  words(all.reference.check_difference);
  words(all.reference.check_error);
  exchange(words, all.exact);
}

template <class Words, class Cost>
void cost(Words& words, Cost& all) {
  words(all.add);
  words(all.mul);
  words(all.div);
  words(all.sqrt);
  words(all.sin);
  words(all.cos);
  words(all.fused);
}
void exchange(Writer& words, const program::Cost& one) { cost(words, one); }
void exchange(Reader& words, program::Cost& one) { cost(words, one); }

template <class Words, class Phase>
void phase(Words& words, Phase& one) {
  exchange(words, one.cost);
  exchange(words, one.repeated_costs);
  words(one.count.steps);
  exchange(words, one.count.repeated);
  exchange(words, one.count.most);
}
void exchange(Writer& words, const accuracy::PhaseSteps& one) { phase(words, one); }
void exchange(Reader& words, accuracy::PhaseSteps& one) { phase(words, one); }

void sizes(Writer& words, const std::map<std::string, accuracy::Size>& all) {
  words.size(all);
  for (const auto& [core, size] : all) {
    words(core);
    words(size.flash);
    words(size.stack);
  }
}
void sizes(Reader& words, std::map<std::string, accuracy::Size>& all) {
  for (long left = words.size(); left > 0; --left) {
    std::string core;
    words(core);
    words(all[core].flash);
    words(all[core].stack);
  }
}

template <class Words, class Result>
void result(Words& words, Result& all) {
  exchange(words, all.phases);
  exchange(words, all.errors);
  words(all.status);
  words(all.time);
  sizes(words, all.sizes);
}

constexpr const char* kEnding = ".part";
constexpr std::string_view kOfStudy = "treedyn: a part of study ";

/// True if a part begins with the whole of its first line, of whatever study.
bool names_a_study(const std::string& text) {
  constexpr std::size_t kDigits = 64;  // of SHA-256
  return text.starts_with(kOfStudy) && text.find('\n') == kOfStudy.size() + kDigits;
}

std::string name_of(std::size_t number) { return fmt::format("setting_{}", number); }

/// What stands before the words of a part: they are its own, and all of them.
std::string seal(const std::string& part, const std::string& words) {
  return fmt::format("{} {}\n", part, emit::sha256(words));
}

/// As one word of a shell.
std::string quoted(const std::string& word) {
  std::string text;
  for (const char c : word) {
    text += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return '\'' + text + '\'';
}

}  // namespace

StudyParts::StudyParts(std::string folder, const std::string& study, Others others)
    : folder_(std::move(folder)),
      head_(fmt::format("{}{}\n", kOfStudy, emit::sha256(study))),
      others_(others) {}

std::string StudyParts::path(const std::string& part) const {
  return (std::filesystem::path(folder_) / (part + kEnding)).string();
}

std::optional<std::string> StudyParts::read(const std::string& part) const {
  const std::optional<std::string> text = folder_.empty() ? std::nullopt : read_file(path(part));
  if (!text) {
    return std::nullopt;
  }
  const bool is_ours = text->starts_with(head_);
  const std::size_t start = text->find('\n', head_.size()) + 1;  // 0: there is none
  std::string words = is_ours && start > 0 ? text->substr(start) : "";
  if (is_ours && *text == head_ + seal(part, words) + words) {
    return words;
  }
  if (others_ == Others::kReplaced) {
    return std::nullopt;
  }
  if (!names_a_study(*text)) {
    throw InputError({path(part), 1, 0},
                     "is damaged: no part of a study begins like this; expected the part as it was "
                     "written");
  }
  throw InputError({path(part), is_ours ? 2 : 1, 0},
                   is_ours
                       ? "is another part of the study, or was changed; expected the part as it "
                         "was written"
                       : "is of another study, of other options, scene, model or version; "
                         "expected another folder");
}

void StudyParts::write(const std::string& part, const std::string& text) const {
  if (!folder_.empty()) {
    write_files({{path(part), head_ + seal(part, text) + text}});
  }
}

std::optional<KnownReference> StudyParts::reference() const {
  const std::optional<std::string> text = read("reference");
  if (!text) {
    return std::nullopt;
  }
  KnownReference all;
  Reader words(*text);
  try {
    known(words, all);
  } catch (const std::runtime_error& problem) {
    throw InputError({path("reference"), 0, 0}, problem.what());
  }
  return all;
}

void StudyParts::keep(const KnownReference& reference) const {
  Writer words;
  known(words, reference);
  write("reference", words.text());
}

std::optional<Outcome> StudyParts::outcome(std::size_t number,
                                           const accuracy::Setting& setting) const {
  const std::optional<std::string> text = read(name_of(number));
  if (!text) {
    return std::nullopt;
  }
  Outcome all;
  all.setting = setting;
  Reader words(*text);
  try {
    result(words, all);
  } catch (const std::runtime_error& problem) {
    throw InputError({path(name_of(number)), 0, 0}, problem.what());
  }
  return all;
}

void StudyParts::keep(std::size_t number, const Outcome& outcome) const {
  Writer words;
  result(words, outcome);
  write(name_of(number), words.text());
}

void remove_parts(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == kEnding) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
  std::filesystem::remove(folder, ignored);
}

void write_plan(const std::string& path, const std::vector<std::string>& arguments,
                const std::vector<std::size_t>& numbers) {
  std::string command;
  for (const std::string& word : arguments) {
    command += quoted(word) + ' ';
  }
  std::string text;
  for (const std::size_t number : numbers) {
    text += fmt::format("{}--part {}\n", command, number);
  }
  write_files({{path, text}});
}

}  // namespace treedyn
