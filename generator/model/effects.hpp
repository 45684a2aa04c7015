// The effects that a scene may name.
#pragma once

#include <array>
#include <string_view>

namespace treedyn::model {

struct EffectRow {
  std::string_view name;  ///< key of a scene file
  std::string_view brief;
};

/// What `treedyn list effects` prints, in the order of the equations of motion.
inline constexpr std::array<EffectRow, 18> kEffects = {{
    {"gravity", "uniform field, G(q)"},
    {"velocity_products",
     "Coriolis and centrifugal terms: B(q, qd), and gamma of constraint rows; on unless off"},
    {"viscous_friction", "joint: -d qd"},
    {"coulomb_friction", "joint: exact sticking, or -f qd/sqrt(qd^2 + vs^2)"},
    {"stribeck_friction", "joint: from a static to a sliding force as speed grows"},
    {"armature", "joint: inertia of a rotor, added to the diagonal of A"},
    {"joint_spring", "joint: -k (q - rest) - d qd"},
    {"point_spring", "point: spring and damper to an anchor"},
    {"drive", "joint: a constant, an expression of t, q, qd, or a PD controller"},
    {"locked_joint", "joint held at a position, or led by an expression of t"},
    {"force", "point: components are expressions of t, q, qd and the motion of the point"},
    {"moment", "link of a point: components as those of a force"},
    {"point_constraint", "point held or led along a curve, direction by direction"},
    {"orientation_constraint", "link of a point keeps its orientation"},
    {"joined_constraint", "two points of the robot coincide: closed loops"},
    {"ground_contact", "point against a plane: spring-damper, Hunt-Crossley, friction, expression"},
    {"impact", "velocities jump when a phase ends"},
    {"stabilisation", "drift of constraints: none, baumgarte or projection"},
}};

}  // namespace treedyn::model
