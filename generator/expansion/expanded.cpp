#include "expansion/expanded.hpp"

namespace treedyn::expansion {

Expanded::Expanded(const Ring& ring, const GiNaC::ex& value)
    : ring_(&ring), value_(ring.reduce(value.expand())) {}

Expanded& Expanded::operator+=(const Expanded& other) {
  ring_ = ring_ == nullptr ? other.ring_ : ring_;
  value_ += other.value_;  // sums of expanded polynomials are expanded
  return *this;
}

Expanded& Expanded::operator-=(const Expanded& other) { return *this += -other; }

Expanded& Expanded::operator*=(const Expanded& other) {
  if (value_.is_zero() || other.value_.is_zero()) {
    value_ = 0;
    return *this;
  }
  ring_ = ring_ == nullptr ? other.ring_ : ring_;
  value_ = (value_ * other.value_).expand();
  if (ring_ != nullptr) {
    value_ = ring_->reduce(value_);
  }
  return *this;
}

Expanded& Expanded::operator/=(const Expanded& other) {
  value_ = (value_ / other.value_).expand();
  return *this;
}

}  // namespace treedyn::expansion
