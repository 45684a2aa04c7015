#include "cli/study_parts.hpp"

#include <algorithm>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>
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
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }

  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  void put(const std::string& text) { out_ << std::quoted(text) << '\n'; }
  void put(accuracy::Error error) { put(static_cast<int>(error)); }
  void put(const std::integral auto& number) { out_ << number << '\n'; }
  void put(const std::floating_point auto& number) {
    char text[64];
    std::snprintf(text, sizeof(text), "%La", static_cast<long double>(number));
    out_ << text << '\n';
  }

  template <class Value>
  void put(const std::vector<Value>& all) {
    put(all.size());
    std::ranges::for_each(all, [this](const Value& value) { put(value); });
  }

  template <class Key, class Value>
  void put(const std::map<Key, Value>& all) {
    put(all.size());
    for (const auto& [key, value] : all) {
      put(key);
      put(value);
    }
  }

  template <class Record>
  void put(const Record& record) {
    exchange(*this, record);
  }

  std::ostringstream out_;
};

/// The same words, read back. \throws std::runtime_error where one is missing
class Reader {
 public:
  explicit Reader(const std::string& text) : in_(text) {}

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }

 private:
  std::string word() {
    std::string result;
    if (!(in_ >> result)) {
      throw std::runtime_error("ends early");
    }
    return result;
  }

  long whole() { return std::strtol(word().c_str(), nullptr, 10); }
  void take(std::string& text) { in_ >> std::quoted(text); }
  void take(accuracy::Error& error) { error = static_cast<accuracy::Error>(whole()); }
  template <std::integral Number>
  void take(Number& number) {
    number = static_cast<Number>(whole());
  }
  template <std::floating_point Number>
  void take(Number& number) {
    number = static_cast<Number>(std::strtold(word().c_str(), nullptr));
  }

  template <class Value>
  void take(std::vector<Value>& all) {
    all.resize(static_cast<std::size_t>(whole()));
    std::ranges::for_each(all, [this](Value& value) { take(value); });
  }

  template <class Key, class Value>
  void take(std::map<Key, Value>& all) {
    for (long left = whole(); left > 0; --left) {
      Key key{};
      take(key);
      take(all[key]);
    }
  }

  template <class Record>
  void take(Record& record) {
    exchange(*this, record);
  }

  std::istringstream in_;
};

/// In one order for both directions; records are const where they are written.
template <class T, class Record>
concept Is = std::same_as<std::remove_const_t<T>, Record>;

template <class Words>
void exchange(Words& words, Is<SteppedEvent> auto& event) {
  words(event.number, event.at);
}

template <class Words>
void exchange(Words& words, Is<OffRows> auto& off) {
  words(off.length, off.angle, off.speed, off.rate);
}

template <class Words>
void exchange(Words& words, Is<Motion> auto& motion) {
  words(motion.q, motion.qd, motion.status, motion.events, motion.off);
}

template <class Words>
void exchange(Words& words, Is<Reference> auto& all) {
  words(all.methods, all.agreement, all.differences, all.check, all.check_difference,
        all.check_error);
}

template <class Words>
void exchange(Words& words, Is<KnownReference> auto& all) {
  words(all.reference, all.exact);
}

template <class Words>
void exchange(Words& words, Is<program::Cost> auto& cost) {
  words(cost.add, cost.mul, cost.div, cost.sqrt, cost.sin, cost.cos, cost.fused, cost.angles,
        cost.twos, cost.fours);
}

template <class Words>
void exchange(Words& words, Is<accuracy::PhaseSteps> auto& phase) {
  words(phase.cost, phase.repeated_costs, phase.count.steps, phase.count.repeated,
        phase.count.most);
}

template <class Words>
void exchange(Words& words, Is<accuracy::Size> auto& size) {
  words(size.flash, size.stack);
}

template <class Words>
void exchange(Words& words, Is<Outcome> auto& all) {
  words(all.phases, all.errors, all.status, all.time, all.sizes);
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
  if (folder_.empty()) {
    return std::nullopt;
  }
  const std::optional<std::string> text = read_file(path(part));
  std::error_code ignored;
  if (!text && others_ == Others::kRefused &&
      std::filesystem::status(path(part), ignored).type() !=
          std::filesystem::file_type::not_found) {
    throw InputError({path(part), 0, 0}, "cannot be read; expected a part of a study");
  }
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
    throw InputError(
        {path(part), 1, 0},
        "is damaged: no part of a study begins like this; expected the part as it was written");
  }
  throw InputError(
      {path(part), is_ours ? 2 : 1, 0},
      is_ours ? "is another part of the study, or was changed; expected the part as it was written"
              : "is of another study, of other options, scene, model or version; expected another "
                "folder");
}

void StudyParts::write(const std::string& part, const std::string& text) const {
  if (!folder_.empty()) {
    write_files({{path(part), head_ + seal(part, text) + text}});
  }
}

template <class Value>
std::optional<Value> StudyParts::found(const std::string& part, Value value) const {
  const std::optional<std::string> text = read(part);
  if (!text) {
    return std::nullopt;
  }
  try {
    Reader words(*text);
    words(value);
  } catch (const std::runtime_error& problem) {
    throw InputError({path(part), 0, 0}, problem.what());
  }
  return value;
}

template <class Value>
void StudyParts::keep_as(const std::string& part, const Value& value) const {
  Writer words;
  words(value);
  write(part, words.text());
}

std::optional<KnownReference> StudyParts::reference() const {
  return found("reference", KnownReference{});
}

void StudyParts::keep(const KnownReference& reference) const { keep_as("reference", reference); }

std::optional<Outcome> StudyParts::outcome(std::size_t number,
                                           const accuracy::Setting& setting) const {
  Outcome all;
  all.setting = setting;
  return found(name_of(number), std::move(all));
}

void StudyParts::keep(std::size_t number, const Outcome& outcome) const {
  keep_as(name_of(number), outcome);
}

void remove_parts(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == kEnding &&
        names_a_study(read_file(entry.path().string()).value_or(""))) {
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
