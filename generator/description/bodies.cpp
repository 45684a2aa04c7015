#include "description/bodies.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

/// Of magnitudes.
Real trace(const Matrix3& a) { return abs(a[0]) + abs(a[4]) + abs(a[8]); }

/// `tensor` without what rounding at 50 digits leaves of zero.
void tidy(Matrix3& tensor) {
  const Real scale = trace(tensor);
  for (Real& entry : tensor) {
    entry = negligible(entry, scale) ? Real(0) : entry;
  }
}

/// How far the principal moments may be off by the rounding of the decimals: twice the largest row
/// sum of six roundings (Gershgorin); 1e-6 of the largest entry for single precision inside of a
/// CAD program, and 1e-15 kg m^2 for what it leaves of zero.
Real moment_tolerance(const Numbers& written, const Matrix3& tensor) {
  const Real scale = *std::ranges::max_element(
      tensor, [](const Real& a, const Real& b) { return abs(a) < abs(b); });
  Real largest = 0;
  for (const Text& text : written.values) {
    largest = std::max(largest, NumberReader::rounding(text, abs(scale)));
  }
  return 6 * largest + Real("1e-6") * abs(scale) + Real("1e-15");
}

std::string six_digits(const Real& value) {
  return fmt::format("{:.6g}", value.convert_to<double>());
}

void check_moments(const RawTree& raw, const RawLink& link, const Matrix3& tensor, bool moves,
                   std::vector<Warning>& warnings) {
  const Numbers& written = *link.inertia->tensor;
  const Real tolerance = moment_tolerance(written, tensor);
  const Vector3 m = eigenvalues(tensor);
  const std::string name = fmt::format("link '{}': inertia", treedyn::shown(link.name.text));
  const std::string moments =
      fmt::format("{}, {}, {}", six_digits(m[0]), six_digits(m[1]), six_digits(m[2]));
  if (m[0] < -tolerance) {
    const std::string fault =
        fmt::format("{} is indefinite, its principal moments are {}", name, moments);
    if (moves) {
      throw InputError(location(raw, written.where), fault + "; expected none below 0");
    }
    warnings.push_back({location(raw, written.where),
                        fault + "; the link does not move, so it is in no equation"});
    return;
  }
  if (m[0] + m[1] < m[2] - 2 * tolerance) {
    warnings.push_back({location(raw, written.where),
                        fmt::format("{} violates the triangle inequality: of its principal moments "
                                    "{} the largest exceeds the sum of the others",
                                    name, moments)});
  }
}

}  // namespace

model::Inertia resolve_inertia(const RawTree& raw, const RawLink& link, const NumberReader& numbers,
                               Snapper& snapper, bool moves, std::vector<Warning>& warnings) {
  model::Inertia result;
  if (!link.inertia) {
    return result;
  }
  const RawInertia& written = *link.inertia;
  const std::string name = fmt::format("link '{}'", treedyn::shown(link.name.text));
  result.mass = numbers.number(written.mass, name + ": mass");
  if (result.mass < 0) {
    throw InputError(location(raw, written.mass.where),
                     fmt::format("{}: mass {} is negative; expected 0 or more", name,
                                 treedyn::shown(written.mass.text)));
  }
  result.com = numbers.vector(written.pose.xyz, name + ": com");
  if (written.tensor) {
    const Matrix3 tensor = numbers.tensor(*written.tensor, name + ": inertia");
    check_moments(raw, link, tensor, moves, warnings);
    result.about_com = tensor;
  }
  if (written.pose.rpy) {
    const std::string what = name + ": inertia rpy";
    const Matrix3 r =
        snapper.from_rpy(numbers.vector(written.pose.rpy, what), *written.pose.rpy, what);
    result.about_com = r * result.about_com * transposed(r);
    tidy(result.about_com);
  }
  return result;
}

model::Inertia moved(const model::Inertia& inertia, const Matrix3& rotation,
                     const Vector3& origin) {
  model::Inertia result = inertia;
  if (rotation != identity()) {
    result.about_com = rotation * inertia.about_com * transposed(rotation);
    tidy(result.about_com);
  }
  result.com = origin + rotation * inertia.com;
  return result;
}

model::Inertia combined(const std::vector<model::Inertia>& bodies) {
  if (bodies.size() == 1) {
    return bodies.front();
  }
  model::Inertia whole;
  Vector3 moment{};
  Real scale = 0;  // of m c
  for (const model::Inertia& body : bodies) {
    whole.mass += body.mass;
    moment = moment + body.mass * body.com;
    scale += body.mass * (abs(body.com[0]) + abs(body.com[1]) + abs(body.com[2]));
  }
  for (std::size_t k = 0; k < 3 && whole.mass != 0; ++k) {
    whole.com[k] = negligible(moment[k], scale) ? Real(0) : Real(moment[k] / whole.mass);
  }
  for (const model::Inertia& body : bodies) {
    whole.about_com =
        whole.about_com + body.about_com + point_inertia(body.mass, body.com - whole.com);
  }
  tidy(whole.about_com);
  return whole;
}

}  // namespace treedyn::description
