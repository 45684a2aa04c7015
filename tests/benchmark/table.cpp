#include <fmt/format.h>

#include "benchmark/report.hpp"
#include "benchmark/series.hpp"

namespace treedyn::benchmark {

namespace {

/// One column a contestant and those that `more` adds.
class Table {
 public:
  explicit Table(const std::vector<Cell>& cells)
      : cells_(cells), contestants_(values(cells, &Cell::contestant)) {}

  [[nodiscard]] std::string times() const {
    std::string text = head("least (median) time of a call, ns", " fastest engine / treedyn |");
    for (const std::string& robot : values(cells_, &Cell::robot)) {
      for (const std::string& function : values(cells_, &Cell::function)) {
        text += row(robot, function, [](const Cell& cell) {
          return fmt::format("{:.0f} ({:.0f})", cell.least, cell.median);
        });
        text += fmt::format(" {} |\n", ratios(robot, function, &Cell::least));
      }
    }
    return text;
  }

  [[nodiscard]] std::string instructions() const {
    std::string text = head("instructions of a call", "");
    for (const std::string& robot : values(cells_, &Cell::robot)) {
      for (const std::string& function : values(cells_, &Cell::function)) {
        text += row(robot, function, [](const Cell& cell) {
          return cell.instructions ? fmt::format("{:.0f}", *cell.instructions) : std::string();
        });
        text += '\n';
      }
    }
    return text;
  }

 private:
  [[nodiscard]] std::string head(const std::string& what, const std::string& more) const {
    std::string text = fmt::format("{}:\n\n| robot | function |", what);
    std::string line = "|---|---|";
    for (const std::string& contestant : contestants_) {
      text += fmt::format(" {} |", contestant);
      line += "---|";
    }
    return fmt::format("{}{}\n{}{}\n", text, more, line, more.empty() ? "" : "---|");
  }

  template <class Show>
  [[nodiscard]] std::string row(const std::string& robot, const std::string& function,
                                const Show& show) const {
    std::string text;
    for (const std::string& contestant : contestants_) {
      const Cell* cell = find(cells_, robot, function, contestant);
      text += cell == nullptr ? " |" : fmt::format(" {} |", show(*cell));
    }
    const auto any = std::find_if(cells_.begin(), cells_.end(),
                                  [&](const Cell& cell) { return cell.robot == robot; });
    return fmt::format("| {} ({} joints) | {} |{}", robot, any->dof, function, text);
  }

  /// How many times longer the fastest engine takes than each kind of generated code.
  [[nodiscard]] std::string ratios(const std::string& robot, const std::string& function,
                                   double Cell::*time) const {
    double fastest = 0;
    for (const std::string& contestant : contestants_) {
      const Cell* cell = find(cells_, robot, function, contestant);
      if (cell != nullptr && is_engine(contestant)) {
        fastest = fastest == 0 ? cell->*time : std::min(fastest, cell->*time);
      }
    }
    std::string text;
    for (const std::string& contestant : contestants_) {
      const Cell* cell = find(cells_, robot, function, contestant);
      if (cell != nullptr && contestant.rfind("treedyn", 0) == 0) {
        text += fmt::format("{}{:.1f}", text.empty() ? "" : ", ", fastest / (cell->*time));
      }
    }
    return text;
  }

  const std::vector<Cell>& cells_;
  std::vector<std::string> contestants_;
};

}  // namespace

std::string markdown(const std::vector<Cell>& cells) {
  const Table table(cells);
  const bool counted = std::any_of(cells.begin(), cells.end(),
                                   [](const Cell& cell) { return cell.instructions.has_value(); });
  return counted ? fmt::format("{}\n{}", table.times(), table.instructions()) : table.times();
}

std::string csv(const std::vector<Cell>& cells) {
  std::string text =
      "robot,joints,function,contestant,relative_error,least_ns,median_ns,instructions\n";
  for (const Cell& cell : cells) {
    text += fmt::format("{},{},{},\"{}\",{:.1e},{:.1f},{:.1f},{}\n", cell.robot, cell.dof,
                        cell.function, cell.contestant, cell.error, cell.least, cell.median,
                        cell.instructions ? fmt::format("{:.0f}", *cell.instructions) : "");
  }
  return text;
}

}  // namespace treedyn::benchmark
