#include "common/real.hpp"

#include <boost/math/constants/constants.hpp>

namespace treedyn {

const Real& pi() {
  static const Real value = boost::math::constants::pi<Digits>();
  return value;
}

}  // namespace treedyn
