#include "description/doubts.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/transformed.hpp"

namespace treedyn::description {

namespace {

/// Lengths in mm are a thousandfold, radii of gyration of kg mm^2 too: a body reaches, and its
/// center of mass lies, within a hundredfold of the largest of all other lengths.
constexpr int kOtherUnits = 100;
/// Where all lengths of a kind may be wrong: radii of gyration beside distances.
constexpr int kOtherRadius = 30;
/// m; distances below it are not held against radii of gyration. Loads of cranes hang on ropes.
constexpr int kLong = 20;
/// Of mass / radius of gyration^3, kg/m^3, which is up to 9 times the density: 1e3 .. 1e5 of most
/// bodies, a 1e-9th of that with kg mm^2. Air has 1.2.
constexpr double kThin = 1e-2;
/// With nothing to compare with: a tether of 100 m has 4e-5.
constexpr double kVeryThin = 1e-5;
/// kg/m^3, of osmium: nothing is denser. Masses in g make a body 1e3 to 1e7 times as dense.
constexpr int kDensest = 22600;
/// m; what has a smaller radius of gyration stands for a point.
constexpr double kPoint = 1e-4;
/// Of squares of lengths: what is flatter or thinner stands for a disc or a rod.
constexpr double kFlat = 1e-3;

/// m; 0 without a mass.
Real radius_of_gyration(const model::Inertia& body) {
  const Matrix3& I = body.about_com;
  const Real trace = I[0] + I[4] + I[8];
  return body.mass > 0 && trace > 0 ? Real(sqrt(trace / (2 * body.mass))) : Real(0);
}

bool thinner(double density, const Real& mass, const Real& radius) {
  return radius > 0 && mass < density * radius * radius * radius;
}

/// The least density with which a body can have this inertia, kg/m^3: that of an ellipsoid, whose
/// half axes are sqrt 5 times the root mean squares along them. 0 of discs and rods.
Real density(const model::Inertia& body, const Real& radius) {
  Matrix3 squares;  // means of x x^T
  for (std::size_t k = 0; k < 9; ++k) {
    squares[k] = (k % 4 == 0 ? radius * radius : Real(0)) - body.about_com[k] / body.mass;
  }
  const Vector3 along = eigenvalues(squares);
  return along[0] > kFlat * along[2]
             ? Real(body.mass / (4 * pi() / 3 * sqrt(125 * along[0] * along[1] * along[2])))
             : Real(0);
}

/// -1 where there is none.
std::array<Real, 2> largest_two(const std::vector<Real>& lengths) {
  std::array<Real, 2> largest = {-1, -1};
  for (const Real& length : lengths) {
    if (length > largest[1]) {
      largest[1] = length;
    }
    if (largest[1] > largest[0]) {
      std::swap(largest[0], largest[1]);
    }
  }
  return largest;
}

/// By link, the largest offset of a joint, position of a center of mass and radius of gyration of
/// all others; 0 where there is no other body.
std::vector<Real> lengths_elsewhere(const std::vector<model::Inertia>& bodies, const Real& offset) {
  const std::vector<Real> own = transformed<Real>(bodies, [](const model::Inertia& body) {
    return body.mass == 0 ? Real(-1) : std::max(norm(body.com), radius_of_gyration(body));
  });
  const std::array<Real, 2> largest = largest_two(own);
  return transformed<Real>(own, [&](const Real& length) {
    const Real& others = length == largest[0] ? largest[1] : largest[0];
    return others < 0 ? Real(0) : std::max(offset, others);
  });
}

}  // namespace

void Doubts::of_angles(const Vector3& rpy, const Numbers& written, const std::string& what) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (abs(rpy[k]) > 2 * pi() * Real("1.000001")) {
      findings_.push_back({location(raw_, written.values[k].where),
                           fmt::format("{} {} is beyond 2 pi; angles are in radians", what,
                                       shown(written.values[k].text))});
    }
  }
}

void Doubts::of_limits(const RawJoint& joint, const std::string& name,
                       const model::Limits& limits) {
  const auto find = [&](const Text& text, const char* which, const char* fault) {
    findings_.push_back({location(raw_, text.where),
                         fmt::format("{}: {} limit {} {}", name, which, shown(text.text), fault)});
  };
  if (limits.velocity && *limits.velocity < 0) {
    find(*joint.limits.velocity, "velocity", "is negative; it bounds a size");
  }
  if (limits.effort && *limits.effort < 0) {
    find(*joint.limits.effort, "effort", "is negative; it bounds a size");
  }
  const auto find_degrees = [&](const std::optional<Real>& angle, const std::optional<Text>& text,
                                const char* which) {
    if (angle && abs(*angle) >= 60 && abs(*angle) <= 360 && *angle == floor(*angle)) {
      find(*text, which, "looks like degrees; angles are in radians");
    }
  };
  if (joint.type.text == "revolute") {
    find_degrees(limits.lower, joint.limits.lower, "lower");
    find_degrees(limits.upper, joint.limits.upper, "upper");
  }
  if (limits.lower && limits.lower == limits.upper && joint.type.text != "continuous") {
    findings_.push_back(
        {location(raw_, joint.limits.lower->where),
         fmt::format("{}: lower and upper limit are both {}, which leaves it one position", name,
                     shown(joint.limits.lower->text))});
  }
}

Doubts::Scale Doubts::scale_of(const std::vector<model::Inertia>& bodies,
                               const std::vector<Real>& offsets) {
  std::vector<Real> distances = offsets;
  std::vector<Real> radii;
  bool thin = true;
  for (const model::Inertia& body : bodies) {
    if (body.mass > 0) {
      distances.push_back(norm(body.com));
    }
    const Real radius = radius_of_gyration(body);
    if (radius > 0) {
      radii.push_back(thinner(kThin, body.mass, radius) ? Real(0) : radius);
      thin = thin && thinner(kVeryThin, body.mass, radius);
    }
  }
  return {largest_two(distances)[1], largest_two(radii)[0], thin};
}

/// Never where it is the only one: of a pendulum.
bool Doubts::Scale::is_far(const Real& length) const {
  return distance > 0 && radius > 0 && length > kLong && length > kOtherUnits * radius;
}

void Doubts::of_inertia(const RawLink& link, const model::Inertia& body, const Real& others,
                        const Scale& scale) {
  const Real radius = radius_of_gyration(body);
  const Real com = norm(body.com);
  const bool wide = scale.distance > 0 && radius > kOtherRadius * scale.distance;
  std::string fault;
  if (body.mass != 0 && link.inertia->tensor && body.about_com == Matrix3{}) {
    fault = "has a mass, and zeros for its inertia";
  } else if (body.mass == 0 && body.about_com != Matrix3{}) {
    fault = "has an inertia, but no mass";
  } else if (others > 0 && std::max(radius, com) > kOtherUnits * others) {
    fault = fmt::format(
        "has a radius of gyration of {} m and its center of mass at {} m, beside lengths of up to "
        "{} m elsewhere; lengths are in m, masses in kg",
        radius.str(3), com.str(3), others.str(3));
  } else if (thinner(kThin, body.mass, radius) && (wide || scale.thin)) {
    fault = fmt::format(
        "has a mass of {} kg and a radius of gyration of {} m, which is thinner than air; masses "
        "are in kg, inertias in kg m^2",
        body.mass.str(3), radius.str(3));
  } else if (radius > kPoint && density(body, radius) > kDensest) {
    fault = fmt::format(
        "has a mass of {} kg and a radius of gyration of {} m, which is denser than any metal "
        "({} kg/m^3 at least); masses are in kg, inertias in kg m^2",
        body.mass.str(3), radius.str(3), density(body, radius).str(2));
  } else if (body.mass > 0 && scale.is_far(com)) {
    fault = fmt::format(
        "has its center of mass at {} m, beside radii of gyration of up to {} m; lengths are in m",
        com.str(3), scale.radius.str(3));
  }
  if (!fault.empty()) {
    findings_.push_back(
        {location(raw_, link.where), fmt::format("link '{}' {}", shown(link.name.text), fault)});
  }
}

void Doubts::of_offsets(const std::vector<Real>& offsets, const Scale& scale) {
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    if (scale.is_far(offsets[k])) {
      const RawJoint& joint = raw_.joints[k];
      findings_.push_back(
          {location(raw_, joint.where),
           fmt::format("joint '{}' has an offset of {} m, beside radii of gyration of up to {} m; "
                       "lengths are in m",
                       shown(joint.name.text), offsets[k].str(3), scale.radius.str(3))});
    }
  }
}

void Doubts::of_inertias(const std::vector<model::Inertia>& bodies, const Real& offset,
                         const std::vector<Real>& offsets) {
  const std::vector<Real> elsewhere = lengths_elsewhere(bodies, offset);
  const Scale scale = scale_of(bodies, offsets);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    of_inertia(raw_.links[k], bodies[k], elsewhere[k], scale);
  }
  of_offsets(offsets, scale);
}

}  // namespace treedyn::description
