#include "description/scene_reader.hpp"

#include "description/hard_case.hpp"
#include "description/scene_yaml.hpp"

namespace treedyn::description {

model::Scene parse_scene(const std::string& text, const std::string& file,
                         const TextReader& model_text, const AtRunTime& at_run_time) {
  const Node root = parse_yaml_node(text, file, "a scene");
  return is_hard_case(root) ? read_hard_case(file, root)
                            : read_scene_yaml(root, file, model_text, at_run_time);
}

model::Scene read_scene(const std::string& path) {
  return parse_scene(read_text(path), path, read_model_text);
}

}  // namespace treedyn::description
