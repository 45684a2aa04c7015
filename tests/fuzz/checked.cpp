#include "fuzz/checked.hpp"

#include <algorithm>
#include <set>

#include "common/error.hpp"
#include "common/identifier.hpp"
#include "description/read.hpp"

namespace treedyn::fuzz {

namespace {

/// Products of a few numbers of at most 1e300 are below this; infinities and NaN are not.
const Real kHuge = pow(Real(10), 3000);
bool finite(const Real& x) { return abs(x) < kHuge; }

template <std::size_t size>
void expect_finite(const std::array<Real, size>& values) {
  TREEDYN_EXPECT(std::all_of(values.begin(), values.end(), finite));
}

void expect_rotation(const model::Matrix3& r) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      Real product = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        product += r[3 * k + m] * r[3 * l + m];
      }
      TREEDYN_EXPECT(abs(product - (k == l ? 1 : 0)) < Real(1e-30));
    }
  }
}

void expect_link(const model::Link& link, int index) {
  const model::Vector3& a = link.joint.axis;
  TREEDYN_EXPECT(link.father >= model::kGround && link.father < index);
  TREEDYN_EXPECT(abs(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1) < Real(1e-30));
  TREEDYN_EXPECT(link.inertia.mass >= 0 && finite(link.inertia.mass));
  TREEDYN_EXPECT(to_identifier(link.joint.name) == link.joint.identifier);
  expect_rotation(link.joint.rotation);
  expect_finite(link.joint.offset);
  expect_finite(link.inertia.com);
  expect_finite(link.inertia.about_com);
}

}  // namespace

void expect_checked(const model::Tree& tree) {
  TREEDYN_EXPECT(tree.size() > 0 && tree.dof() > 0 && tree.dof() <= tree.size());
  TREEDYN_EXPECT(tree.drives.size() == tree.links.size());
  std::set<std::string> identifiers;
  for (int i = 0; i < tree.size(); ++i) {
    const model::Link& link = tree.links[static_cast<std::size_t>(i)];
    expect_link(link, i);
    TREEDYN_EXPECT(identifiers.insert(link.joint.identifier).second);
  }
  for (const model::Drive& drive : tree.drives) {
    TREEDYN_EXPECT(drive.coordinate >= 0 && drive.coordinate < tree.dof());
  }
  for (const model::Frame& frame : tree.frames) {
    TREEDYN_EXPECT(frame.link >= model::kGround && frame.link < tree.size());
    expect_rotation(frame.rotation);
  }
  for (const model::Point& point : tree.points) {
    TREEDYN_EXPECT(point.link >= model::kGround && point.link < tree.size());
    expect_finite(point.at);
  }
  if (tree.size() < 200) {
    static_cast<void>(description::joints_without_inertia(tree));
  }
}

void expect_checked_or_refused(const std::uint8_t* data, std::size_t size, const Reader& reader) {
  using description::Base;
  using description::Mimic;
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const Base base : {Base::kFixed, Base::kAxes}) {
    const bool fixed = base == Base::kFixed;
    try {
      expect_checked(reader(text, {base, fixed ? Mimic::kReduce : Mimic::kIndependent,
                                   fixed ? Real(1e-9) : Real(0)}));
    } catch (const InputError&) {  // the only way to refuse
    }
  }
}

}  // namespace treedyn::fuzz
