# treedyn_embed_templates(OUTPUT): the files templates/*.in as text inside the program, so that it
# runs from any place.
function(treedyn_embed_templates output)
  set(TEMPLATE_CASES "")
  foreach(name IN ITEMS report.html accuracy.html simulate.cpp generated_step.cpp model.hpp model.cpp order_of_sums.cpp sincos.cpp sine_cosine.cpp quadrant.cpp quadrant_of_lanes.cpp sines_cosines.cpp numeric.cpp check.cpp solve_rows.cpp step_semi_implicit_euler.cpp step_rk4.cpp step_dopri5.cpp
               step_sdirk2.cpp step_stages.cpp step_events.cpp step_search.cpp step_cut.cpp step_dips.cpp step_falls.cpp step_falls_now.cpp step_clocks.cpp step_parts.cpp step_turns.cpp step_add.cpp self_test.cpp finite_math.cpp)
    set(file ${PROJECT_SOURCE_DIR}/templates/${name}.in)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND TEMPLATE_CASES
           "  if (name == \"${name}\") {\n    return R\"template(${text})template\";\n  }\n")
  endforeach()
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/emit/templates.cpp.in ${output} @ONLY)
endfunction()
