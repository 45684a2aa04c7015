#include "emit/named_constants.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "common/transformed.hpp"
#include "emit/layout.hpp"
#include "emit/names.hpp"
#include "model/parameters.hpp"
#include "model/scene_number.hpp"

namespace treedyn::emit {

namespace {

/// More links than these are told by the first and the last of them.
constexpr std::size_t kMostLinks = 6;
constexpr int kNoLink = -1;

bool is_inertial(const Origin& origin) {
  return origin.part == ModelPart::kMass || origin.part == ModelPart::kCom ||
         origin.part == ModelPart::kInertia;
}

/// The first link that the number has inertia of; of numbers without inertia the first at all.
int owner(const Provenance& source) {
  int inertial = kNoLink;
  int any = kNoLink;
  for (auto it = source.origins.rbegin(); it != source.origins.rend(); ++it) {
    inertial = is_inertial(*it) ? it->link : inertial;
    any = it->link != kNoLink ? it->link : any;
  }
  return inertial != kNoLink ? inertial : any;
}

struct ConstantKind {
  Dimension dimension;
  char letter = 'p';
  const char* unit = "";
};

constexpr std::array<ConstantKind, 8> kKinds = {{{{0, 0, 0}, 'k', "ratio"},
                                                 {{1, 0, 0}, 'm', "kg"},
                                                 {{0, 1, 0}, 'l', "m"},
                                                 {{1, 1, 0}, 'h', "kg m"},
                                                 {{1, 2, 0}, 'I', "kg m^2"},
                                                 {{0, 1, -2}, 'g', "m/s^2"},
                                                 {{1, 1, -2}, 'w', "N"},
                                                 {{1, 2, -2}, 'G', "N m"}}};

char letter_of(const Dimension& dimension) {
  const auto found = std::ranges::find(kKinds, dimension, &ConstantKind::dimension);
  return found == kKinds.end() ? 'p' : found->letter;
}

/// "kg m^2: ", of other units "kg^-1 m^-2: "; empty if it is not known.
std::string unit_text(const Dimension& dimension) {
  const auto found = std::ranges::find(kKinds, dimension, &ConstantKind::dimension);
  if (!dimension.is_known || found != kKinds.end()) {
    return dimension.is_known ? fmt::format("{}: ", found->unit) : std::string();
  }
  std::vector<std::string> factors;
  for (const auto& [power, name] :
       {std::pair(dimension.mass, "kg"), {dimension.length, "m"}, {dimension.time, "s"}}) {
    if (power != 0) {
      factors.push_back(power == 1 ? std::string(name) : fmt::format("{}^{}", name, power));
    }
  }
  return fmt::format("{}: ", fmt::join(factors, " "));
}

/// "com x y" or, of all components, "com".
std::string components(const char* word, const std::vector<int>& which,
                       std::span<const char* const> names) {
  if (which.size() == names.size()) {
    return word;
  }
  const std::vector<std::string> chosen =
      transformed<std::string>(which, [&](int k) { return names[static_cast<std::size_t>(k)]; });
  return fmt::format("{} {}", word, fmt::join(chosen, " "));
}

/// What of one link: "mass, com x y, inertia zz".
std::string parts_text(const std::map<ModelPart, std::vector<int>>& parts) {
  using model::kAxes;
  using model::kEntries;
  std::vector<std::string> words;
  for (const auto& [part, which] : parts) {
    switch (part) {
      case ModelPart::kMass:
        words.emplace_back("mass");
        break;
      case ModelPart::kCom:
        words.push_back(components("com", which, kAxes));
        break;
      case ModelPart::kInertia:
        words.push_back(components("inertia", which, kEntries));
        break;
      case ModelPart::kPlace:
        words.push_back(components("offset", which, kAxes));
        break;
      case ModelPart::kTurn:
        words.emplace_back("rotation");
        break;
      case ModelPart::kPoint:
        words.emplace_back("points");
        break;
      case ModelPart::kGravity:
        words.emplace_back("gravity");
        break;
      case ModelPart::kScene:
        for (const int what : which) {
          words.emplace_back(model::row_of(static_cast<model::SceneNumber>(what)).word);
        }
        break;
    }
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string links_text(const std::vector<int>& links, const Vocabulary& words) {
  const auto name = [&](int link) {
    return words.body_comments[static_cast<std::size_t>(link)];
  };
  if (links.size() > kMostLinks) {
    return fmt::format("{} to {} ({} links)", name(links.front()), name(links.back()),
                       links.size());
  }
  return fmt::format("{}", fmt::join(transformed(links, name), ", "));
}

/// "inertia zz of link3; mass, com of link4, link5; gravity".
std::string source_text(const Provenance& source, const Vocabulary& words) {
  std::map<int, std::map<ModelPart, std::vector<int>>> by_link;
  for (const Origin& origin : source.origins) {
    by_link[origin.link][origin.part].push_back(origin.component);
  }
  std::vector<std::pair<std::string, std::vector<int>>> groups;
  for (const auto& [link, parts] : by_link) {
    const std::string text = parts_text(parts);
    auto group = std::ranges::find(groups, text, &std::pair<std::string, std::vector<int>>::first);
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {text, {}});
    }
    if (link != kNoLink) {
      group->second.push_back(link);
    }
  }
  std::vector<std::string> texts;
  for (const auto& [text, links] : groups) {
    texts.push_back(links.empty() ? text : fmt::format("{} of {}", text, links_text(links, words)));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// "forearm_p", in front of a count.
std::string stem_of(const Provenance& source, const Vocabulary& words) {
  const int link = owner(source);
  const std::string body = link == kNoLink ? "base" : words.bodies[static_cast<std::size_t>(link)];
  return fmt::format("{}{}_{}", is_digit(body.front()) || body.front() == '_' ? "n" : "", body,
                     letter_of(source.dimension));
}

}  // namespace

ConstantNames::ConstantNames(const std::vector<const program::Function*>& functions,
                             const std::vector<Real>& numbers, const Vocabulary& words,
                             std::set<std::string> taken)
    : taken_(std::move(taken)) {
  for (const program::Function* const function : functions) {
    const program::Graph& graph = function->graph;
    for (const program::Ref node : program::reachable(graph, function->outputs)) {
      if (graph.node(node).kind == program::Kind::kConstant) {
        add(graph.value(node), words);
      }
    }
  }
  for (const Real& number : numbers) {
    add(abs(number), words);
  }
  std::ranges::stable_sort(entries_, {}, [](const Entry& e) {
    const auto kind = std::ranges::find(kKinds, e.letter, &ConstantKind::letter);
    return std::tuple(e.link, kind - kKinds.begin(), e.number);
  });
  by_value_.clear();
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    by_value_.emplace(static_cast<double>(entries_[k].value.seen()), k);
  }
}

std::vector<DescribedNumber> described(const std::vector<Real>& numbers, const Vocabulary& words) {
  std::vector<DescribedNumber> result;
  std::map<std::string, int> counts;
  for (const Real& number : numbers) {
    const std::optional<Provenance> source = provenance_of(number);
    const std::string stem = !source ? "n" : stem_of(*source, words);
    result.push_back(
        {fmt::format("{}{}", stem, ++counts[stem]),
         !source ? std::string() : unit_text(source->dimension) + source_text(*source, words)});
  }
  return result;
}

void ConstantNames::add(const Real& value, const Vocabulary& words) {
  std::optional<Provenance> source = provenance_of(value);
  if (!source || value.recipe() != 0 || find(value) != nullptr) {
    return;
  }
  const int link = owner(*source);
  const char letter = letter_of(source->dimension);
  const std::string stem = stem_of(*source, words);
  std::string name;
  int number = 0;
  do {
    number = ++counts_[{link, letter}];
    name = fmt::format("{}{}", stem, number);
  } while (is_reserved(name) || !taken_.insert(name).second);
  by_value_.emplace(static_cast<double>(value.seen()), entries_.size());
  entries_.push_back({value, *std::move(source), link, letter, number, name});
}

const std::string* ConstantNames::find(const Real& constant) const {
  const auto key = static_cast<double>(constant.seen());
  for (auto it = by_value_.lower_bound(key * (1 - 1e-14));
       it != by_value_.end() && it->first <= key * (1 + 1e-14); ++it) {
    if (identical(entries_[it->second].value, constant)) {
      return &entries_[it->second].name;
    }
  }
  return nullptr;
}

std::vector<std::string> ConstantNames::names() const {
  return transformed(entries_, &Entry::name);
}

std::string ConstantNames::table(const Vocabulary& words, Scalar scalar) const {
  if (entries_.empty()) {
    return {};
  }
  const bool has_scene = std::ranges::any_of(entries_, [](const Entry& entry) {
    return std::ranges::any_of(entry.source.origins, [](const Origin& origin) {
      return origin.part == ModelPart::kScene;
    });
  });
  std::string result =
      "\nnamespace {\n\n" +
      wrapped(fmt::format(
                  "The numbers that functions take from the {0}, under the first link whose "
                  "inertia is in them; above each the numbers of the {0} that it is made of, but "
                  "for those that are exactly 0 or 1, behind its unit, which a length or mass of "
                  "exactly 1 hides{1}. Other literals are numbers of the equations.",
                  has_scene ? "model and the scene" : "model",
                  has_scene ? "; those of the scene's own numbers have none" : ""),
              "// ");
  int link = kNoLink - 1;
  for (const Entry& entry : entries_) {
    result += entry.link != link ? "\n" : "";
    link = entry.link;
    const std::string unit = unit_text(entry.source.dimension);
    result += wrapped(unit + source_text(entry.source, words), "// ", 4) +
              fmt::format("constexpr {} {} = {};\n", type_name(scalar), entry.name,
                          literal(entry.value, scalar));
  }
  return result + "\n}  // namespace\n";
}

std::string number_text(const Vocabulary& words, const Real& constant, Scalar scalar) {
  const std::string* const name = words.constants ? words.constants->find(constant) : nullptr;
  if (name != nullptr) {
    return *name;
  }
  const std::string number = literal(constant, scalar);
  return number.front() == '-' ? fmt::format("({})", number) : number;
}

std::string signed_number_text(const Vocabulary& words, const Real& constant, Scalar scalar) {
  return constant < 0 ? "-" + number_text(words, -constant, scalar)
                      : number_text(words, constant, scalar);
}

int number_width(const Vocabulary& words, const Real& constant, Scalar scalar) {
  const std::string* const name = words.constants ? words.constants->find(constant) : nullptr;
  return name != nullptr ? static_cast<int>(name->size()) : literal_width(constant, scalar);
}

}  // namespace treedyn::emit
