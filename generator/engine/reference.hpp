// What functions should return, with 50 digits, and how large the terms are that it is made of.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/eigen_real.hpp"
#include "engine/engine.hpp"
#include "equations/user.hpp"

namespace treedyn::engine {

/// The values of a function, all outputs one after the other, and their natural scales.
struct Exact {
  std::vector<Real> values;
  std::vector<double> scales;  ///< see Engine::scales
};

/// The block equations of a tree; factors and solutions of A by elimination with 50 digits.
class Reference {
 public:
  Reference(const model::Tree& tree, std::span<const model::Point> points,
            const model::Vector3& gravity);

  /// \param inputs  in the order of the function's signature
  /// Scales of what A is divided by: those of the residuals, times |A^-1|; of its factors what
  /// A and the products L^T Delta L have.
  Exact operator()(const std::string& function, const std::vector<std::vector<double>>& inputs);
  /// Of a user.
  Exact operator()(const equations::UserEquation& equation,
                   const std::vector<std::vector<double>>& inputs);

 private:
  struct Factors;
  using Inputs = std::vector<std::vector<Real>>;

  Exact of_engine(const std::string& function, const Inputs& inputs);
  Factors factors(const std::vector<Real>& q);
  Exact factor(const Inputs& inputs);
  Exact solution(const Inputs& inputs);
  Exact inverse(const Inputs& inputs);
  Exact terms(const Inputs& inputs);
  Exact regressor(const Inputs& inputs);

  const model::Tree& tree_;
  std::vector<model::Point> points_;
  model::Vector3 gravity_;
  Engine<Real> engine_;
};

}  // namespace treedyn::engine
