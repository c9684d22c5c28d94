# Runs one of the examples and looks at what it prints and writes.
cmake_minimum_required(VERSION 3.25)

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${EXAMPLE}: there is no \"${pattern}\" in\n${text}")
  endif()
endfunction()

macro(run expectedCode)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE code)
  if(NOT code EQUAL ${expectedCode})
    message(FATAL_ERROR "${ARGN}: ${code}\n${output}\n${errors}")
  endif()
endmacro()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
if(EXAMPLE STREQUAL "girth_of_model")
  run(0 "${PROGRAMS}/girth_of_model" "${DATA}/prism.obj" "${FOLDER}/values.csv")
  expect("${output}" "girth from 4 to 21")
  expect("${output}" "length 4, ")
  file(STRINGS "${FOLDER}/values.csv" lines)
  list(LENGTH lines count)
  if(NOT count EQUAL 45)
    message(FATAL_ERROR "the CSV has ${count} lines, not one for each of 44 vertices and a header")
  endif()
  run(1 "${PROGRAMS}/girth_of_model" "${DATA}/bad/nan.obj" "${FOLDER}/none.csv")
  expect("${errors}" "NON_FINITE_POSITION: ")
elseif(EXAMPLE STREQUAL "loop_of_arrays")
  run(0 "${PROGRAMS}/loop_of_arrays")
  # Just below the perimeter of the tube, a regular polygon of 16 sides and radius 0.5: 3.1214.
  expect("${output}" "^length 3\\.121")
elseif(EXAMPLE STREQUAL "girth_of_folder")
  # Two models, one of them broken, and a file that is no model.
  file(MAKE_DIRECTORY "${FOLDER}/models")
  file(COPY "${DATA}/bad/nan.obj" "${DATA}/prism.obj" "${DATA}/README.md"
       DESTINATION "${FOLDER}/models")
  run(1 "${CMAKE_COMMAND}" -E env "GIRTH=${COMMAND}" "${SOURCES}/girth_of_folder.sh"
      "${FOLDER}/models" "${FOLDER}/results" --threads 1)
  file(READ "${FOLDER}/results/table.csv" table)
  expect("${table}" "^file,vertices,min,median,max,seconds,error\n\"nan.obj\",,,,,,\".*NON_FINITE_POSITION.*\"\n\"prism.obj\",44,4,4,21\\.[0-9]+,[.0-9e-]+,\n$")
  if(NOT EXISTS "${FOLDER}/results/prism.obj.csv" OR EXISTS "${FOLDER}/results/error.txt")
    message(FATAL_ERROR "the folder of results is not as the example says")
  endif()
  file(REMOVE "${FOLDER}/models/nan.obj")
  run(0 "${CMAKE_COMMAND}" -E env "GIRTH=${COMMAND}" "${SOURCES}/girth_of_folder.sh"
      "${FOLDER}/models" "${FOLDER}/results")
endif()
