#include "cli/vet.hpp"

#include <set>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "description/read.hpp"
#include "emit/json.hpp"
#include "request/user_equations.hpp"

namespace treedyn {

namespace {

const char* severity(const Finding& finding) { return finding.is_error ? "error" : "warning"; }

std::string json_finding(const Finding& finding) {
  return emit::json_object({{"file", emit::json_string(finding.where.file)},
                            {"line", std::to_string(finding.where.line)},
                            {"column", std::to_string(finding.where.column)},
                            {"severity", emit::json_string(severity(finding))},
                            {"message", emit::json_string(finding.message)}});
}

/// Which points there are is a matter of --points or of a scene where the model has none: of all,
/// the first of every identifier.
std::vector<model::Point> points_of(const model::Tree& tree) {
  if (!tree.points.empty()) {
    return tree.points;
  }
  std::vector<model::Point> points = description::points_of_links(tree);
  std::set<std::string> taken;
  std::erase_if(points,
                [&](const model::Point& point) { return !taken.insert(point.identifier).second; });
  return points;
}

}  // namespace

std::vector<Finding> vet(const Request& request) {
  std::vector<Finding> findings;
  try {
    const std::string text = description::read_model_text(request.model);
    const description::Vetted vetted = description::vet_model(text, request.model, request.read);
    for (const Warning& warning : vetted.findings) {
      findings.push_back({warning.where, warning.message, false});
    }
    if (vetted.error) {
      findings.push_back({vetted.error->where(), vetted.error->message(), true});
    } else if (vetted.tree.dof() > 0) {
      read_user_equations(request, request.model, text, vetted.tree, points_of(vetted.tree));
    }
  } catch (const InputError& error) {
    findings.push_back({error.where(), error.message(), true});
  }
  return findings;
}

std::string findings_text(const std::vector<Finding>& findings, const std::string& format) {
  if (format == "json") {
    return emit::json_lines(transformed(findings, json_finding), 2) + "\n";
  }
  std::string result;
  for (const Finding& finding : findings) {
    result += format == "gcc" ? fmt::format("{}: {}: {}\n", to_string(finding.where),
                                            severity(finding), finding.message)
                              : fmt::format("{}: {}\n", to_string(finding.where), finding.message);
  }
  return result;
}

}  // namespace treedyn
